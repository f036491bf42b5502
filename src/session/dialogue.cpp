// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue.h"

#include <algorithm>

namespace goal_alignment::session {

using questions::Knowledge;

namespace {

/// What an asked candidate was answered. What still is open when a question ends was declined.
AnswerKind kindOf(Knowledge knowledge) {
  return knowledge == Knowledge::Wanted      ? AnswerKind::Yes
         : knowledge == Knowledge::NotWanted ? AnswerKind::No
         : knowledge == Knowledge::Unsure    ? AnswerKind::Unsure
                                             : AnswerKind::Decline;
}

}  // namespace

Dialogue::Dialogue(const alignment::Problem& problem)
    : specified_(problem.specified),
      knowledge_(problem.candidates.size(), Knowledge::Open),
      answered_by_(problem.candidates.size()),
      reopened_(problem.candidates.size(), false),
      assumed_(problem.candidates.size(), false) {
  fluents_.reserve(problem.candidates.size());
  for (const alignment::Candidate& candidate : problem.candidates)
    fluents_.push_back(candidate.fluent);
}

void Dialogue::assume(const std::string& predicate, Knowledge knowledge) {
  const std::string name = toLower(predicate);
  for (std::size_t f = 0; f < fluents_.size(); ++f) {
    if (fluents_[f].atom.name != name) continue;
    knowledge_[f] = knowledge;
    assumed_[f] = true;
  }
}

std::optional<std::size_t> Dialogue::find(const Literal& fluent) const {
  const auto found = std::lower_bound(fluents_.begin(), fluents_.end(), fluent);
  if (found == fluents_.end() || *found != fluent) return std::nullopt;
  return static_cast<std::size_t>(found - fluents_.begin());
}

std::string Dialogue::refusal(const Literal& fluent, bool revising) const {
  if (std::binary_search(specified_.begin(), specified_.end(), fluent)) {
    return fluent.text() + " is part of the specified goal";
  }
  const std::optional<std::size_t> found = find(fluent);
  if (!found) {
    return fluent.text() + " is no part of the expected state, so nothing depends on it";
  }
  const bool answered = knowledge_[*found] != Knowledge::Open;
  if (assumed_[*found]) return "";  // there is no answer yet, and something to revise
  if (answered && !revising)
    return fluent.text() + " is answered already; revise the answer instead";
  if (!answered && revising)
    return fluent.text() + " is not answered yet, so there is nothing to revise";
  return "";
}

SubmitResult Dialogue::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                              const std::string& answered_by, bool revising) {
  if (fluents.empty()) return {false, "no fluent is named"};
  for (const Literal& fluent : fluents) {
    if (std::string why = refusal(fluent, revising); !why.empty()) return {false, std::move(why)};
  }
  for (const Literal& fluent : fluents)
    set(*find(fluent), kind, answered_by);
  noteLateAnswers();
  closeIfAnswered();
  return {true, ""};
}

void Dialogue::set(std::size_t candidate, AnswerKind kind, const std::string& answered_by) {
  knowledge_[candidate] = kind == AnswerKind::Yes  ? Knowledge::Wanted
                          : kind == AnswerKind::No ? Knowledge::NotWanted
                                                   : Knowledge::Unsure;
  answered_by_[candidate] = answered_by;
  assumed_[candidate] = false;
}

void Dialogue::closeIfAnswered() {
  if (!open_) return;
  std::vector<std::size_t>& waiting = open_->waiting;
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                               [this](std::size_t f) { return knowledge_[f] != Knowledge::Open; }),
                waiting.end());
  if (waiting.empty()) close(false);
}

/// Notes what was answered. What was not is declined, or else was not asked after all.
void Dialogue::close(bool declined) {
  QuestionRecord record;
  record.round = records_.size() + 1;
  for (std::size_t i = 0; i < open_->candidates.size(); ++i) {
    const Knowledge knowledge = knowledge_[open_->candidates[i]];
    if (knowledge == Knowledge::Open && !declined) continue;
    record.fluents.push_back(fluents_[open_->candidates[i]]);
    record.reasons.push_back(std::move(open_->reasons[i]));
    record.answers.push_back(kindOf(knowledge));
  }
  records_.push_back(std::move(record));
  open_.reset();
}

/// Who was shown a group answers all of it, also what the first answers have made needless.
void Dialogue::noteLateAnswers() {
  if (!taken_back_) return;
  QuestionRecord& record = records_.back();
  std::ptrdiff_t at = 0;  // in the record, which is in the question's order
  for (std::size_t i = 0; i < taken_back_->candidates.size(); ++i) {
    const std::size_t candidate = taken_back_->candidates[i];
    const auto next = record.fluents.begin() + at;
    const bool is_new = next == record.fluents.end() || *next != fluents_[candidate];
    if (is_new && knowledge_[candidate] == Knowledge::Open) continue;
    if (is_new) {
      record.fluents.insert(next, fluents_[candidate]);
      record.reasons.insert(record.reasons.begin() + at, taken_back_->reasons[i]);
      record.answers.insert(record.answers.begin() + at, kindOf(knowledge_[candidate]));
    }
    ++at;
  }
}

std::vector<Dialogue::AskedCandidate> Dialogue::posed() const {
  std::vector<AskedCandidate> result;
  for (std::size_t i = 0; i < open_->candidates.size(); ++i)
    result.push_back({open_->candidates[i], open_->reasons[i]});
  return result;
}

void Dialogue::ask(const std::vector<AskedCandidate>& posed) {
  OpenQuestion question;
  for (const auto& [candidate, reason] : posed) {
    question.candidates.push_back(candidate);
    question.reasons.push_back(reason);
  }
  asked_ = askedWith(question.candidates);
  withdrawn_.clear();
  taken_back_.reset();
  question.waiting = question.candidates;
  open_ = std::move(question);
}

void Dialogue::withdraw() {
  if (!open_) return;
  if (open_->waiting.size() < open_->candidates.size()) {
    taken_back_ = open_;
    return close(false);
  }
  withdrawn_ = std::move(open_->candidates);
  open_.reset();
}

void Dialogue::decline() {
  if (open_) close(true);
}

void Dialogue::reopen(const achievability::CandidateSet& candidates) {
  for (const std::size_t f : achievability::members(candidates & reopenable())) {
    knowledge_[f] = Knowledge::Open;
    reopened_[f] = true;
  }
}

achievability::CandidateSet Dialogue::reopenable() const {
  achievability::CandidateSet set = with(Knowledge::Unsure);
  for (std::size_t f = 0; f < set.size(); ++f) {
    if (reopened_[f] || assumed_[f]) set.reset(f);
  }
  return set;
}

achievability::CandidateSet Dialogue::with(Knowledge knowledge) const {
  achievability::CandidateSet set(knowledge_.size());
  for (std::size_t f = 0; f < knowledge_.size(); ++f)
    set.set(f, knowledge_[f] == knowledge);
  return set;
}

achievability::CandidateSet Dialogue::assumed() const {
  achievability::CandidateSet set(assumed_.size());
  for (std::size_t f = 0; f < assumed_.size(); ++f)
    set.set(f, assumed_[f]);
  return set;
}

}  // namespace goal_alignment::session
