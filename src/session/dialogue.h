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
  Dialogue() = default;
  explicit Dialogue(const alignment::Problem& problem);

  /// Applies an answer of yes, no or unsure. `revising`: answered fluents may be answered again,
  /// and only those.
  Receipt answer(const std::vector<Literal>& fluents, AnswerKind kind,
                 const std::string& answered_by, bool revising);

  /// Opens a question about one candidate.
  void ask(std::size_t candidate, const achievability::Conflict* conflict);
  /// The person would not answer: the open question, if there is one, ends with that.
  void decline();
  /// Takes the open question back unanswered.
  void withdraw();
  /// A question that was taken back counts once more when it is put again: to another goal, it is
  /// one of its own.
  void countAnew() { withdrawn_.reset(); }
  /// Makes every fluent answered "don't know" open once more; false when there is none left that
  /// was not reopened before.
  bool reopenUnsure();

  bool isOpen() const { return open_.has_value(); }
  const std::vector<std::size_t>& openCandidates() const { return open_->candidates; }
  const std::vector<questions::Knowledge>& knowledge() const { return knowledge_; }
  const std::string& answeredBy(std::size_t candidate) const { return answered_by_[candidate]; }
  const std::vector<QuestionRecord>& records() const { return records_; }
  /// Questions asked so far, the open one included. One that was taken back and is then put again
  /// is one question.
  std::size_t asked() const { return asked_; }
  /// What asked() would be with a question about the candidate.
  std::size_t askedWith(std::size_t candidate) const {
    return asked_ + (withdrawn_ == candidate ? 0 : 1);
  }

  /// The candidates with this knowledge.
  achievability::CandidateSet with(questions::Knowledge knowledge) const;
  const std::vector<Literal>& fluents() const { return fluents_; }
  /// The conflict that the open question is about; empty: none.
  const std::vector<Literal>& openConflict() const { return open_->record.conflict; }
  bool openConflictProven() const { return open_->record.conflict_proven; }

 private:
  struct OpenQuestion {
    std::vector<std::size_t> candidates;  // of those asked about, the ones not answered yet
    QuestionRecord record;
  };

  std::optional<std::size_t> find(const Literal& fluent) const;
  std::string refusal(const Literal& fluent, bool revising) const;
  void set(std::size_t candidate, AnswerKind kind, const std::string& answered_by);
  void closeIfAnswered(AnswerKind kind);

  std::vector<Literal> fluents_;    // by candidate, and so sorted
  std::vector<Literal> specified_;  // sorted
  std::vector<questions::Knowledge> knowledge_;
  std::vector<std::string> answered_by_;
  std::vector<bool> reopened_;
  std::optional<OpenQuestion> open_;
  std::vector<QuestionRecord> records_;
  std::size_t asked_ = 0;
  std::optional<std::size_t> withdrawn_;  // the last question, where nobody answered it
};

}  // namespace goal_alignment::session
