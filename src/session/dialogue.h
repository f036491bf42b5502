// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/questions/policy.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::session {

/// What the person has said, and what they are being asked.
class Dialogue {
 public:
  /// A candidate that is asked about, and why.
  struct AskedCandidate {
    std::size_t candidate = 0;
    Reason reason;
  };

  Dialogue() = default;
  explicit Dialogue(const alignment::Problem& problem);

  /// Nobody is asked about the candidates of this predicate: they count as answered so. What a
  /// person says of them by themselves replaces it.
  void assume(const std::string& predicate, questions::Knowledge knowledge);

  /// Applies an answer of yes, no or unsure. `revising`: answered fluents may be answered again,
  /// and only those.
  SubmitResult answer(const std::vector<Literal>& fluents, AnswerKind kind,
                      const std::string& answered_by, bool revising);

  /// Opens a question, "which of these matter to you?".
  void ask(const std::vector<AskedCandidate>& posed);
  /// The person would not answer: the open question, if there is one, ends with that.
  void decline();
  /// Takes the open question back, or what of it nobody has answered.
  void withdraw();
  /// A question that was taken back counts once more when it is put again: to another goal, it is
  /// one of its own.
  void countAnew() { withdrawn_.clear(); }
  /// These of reopenable() are open once more.
  void reopen(const achievability::CandidateSet& candidates);

  bool isOpen() const { return open_.has_value(); }
  const std::vector<std::size_t>& openCandidates() const { return open_->waiting; }
  /// The open question's candidates, answered or not, as they were posed.
  std::vector<AskedCandidate> posed() const;
  const std::vector<questions::Knowledge>& knowledge() const { return knowledge_; }
  const std::string& answeredBy(std::size_t candidate) const { return answered_by_[candidate]; }
  const std::vector<QuestionRecord>& records() const { return records_; }
  /// Questions asked so far, the open one included. One that was taken back and is then put again
  /// is one question.
  std::size_t asked() const { return asked_; }
  /// What asked() would be with a question about these candidates.
  std::size_t askedWith(const std::vector<std::size_t>& candidates) const {
    return asked_ + (!withdrawn_.empty() && withdrawn_ == candidates ? 0 : 1);
  }

  /// The candidates with this knowledge.
  achievability::CandidateSet with(questions::Knowledge knowledge) const;
  /// What a person answered with "don't know" and has not been asked about once more.
  achievability::CandidateSet reopenable() const;
  /// Those that were assumed, not answered.
  achievability::CandidateSet assumed() const;
  const std::vector<Literal>& fluents() const { return fluents_; }
  /// The candidate's index; nothing where the fluent is none.
  std::optional<std::size_t> find(const Literal& fluent) const;

 private:
  struct OpenQuestion {
    std::vector<std::size_t> candidates;  // asked about
    std::vector<std::size_t> waiting;     // of these, the ones not answered yet
    std::vector<Reason> reasons;          // by candidate
  };

  std::string refusal(const Literal& fluent, bool revising) const;
  void set(std::size_t candidate, AnswerKind kind, const std::string& answered_by);
  void closeIfAnswered();
  void close(bool declined);
  void noteLateAnswers();

  std::vector<Literal> fluents_;    // by candidate, and so sorted
  std::vector<Literal> specified_;  // sorted
  std::vector<questions::Knowledge> knowledge_;
  std::vector<std::string> answered_by_;
  std::vector<bool> reopened_;
  std::vector<bool> assumed_;
  std::optional<OpenQuestion> open_;
  std::vector<QuestionRecord> records_;
  std::optional<OpenQuestion> taken_back_;  // the last record's, answered in part
  std::size_t asked_ = 0;
  std::vector<std::size_t> withdrawn_;  // the last question, where nobody answered it
};

}  // namespace goal_alignment::session
