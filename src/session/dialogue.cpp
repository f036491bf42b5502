// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue.h"

#include <algorithm>

namespace goal_alignment::session {

using questions::Knowledge;

Dialogue::Dialogue(const alignment::Problem& problem)
    : specified_(problem.specified),
      knowledge_(problem.candidates.size(), Knowledge::Open),
      answered_by_(problem.candidates.size()),
      reopened_(problem.candidates.size(), false) {
  fluents_.reserve(problem.candidates.size());
  for (const alignment::Candidate& candidate : problem.candidates)
    fluents_.push_back(candidate.fluent);
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
  if (answered && !revising)
    return fluent.text() + " is answered already; revise the answer instead";
  if (!answered && revising)
    return fluent.text() + " is not answered yet, so there is nothing to revise";
  return "";
}

Receipt Dialogue::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                         const std::string& answered_by, bool revising) {
  if (fluents.empty()) return {false, "no fluent is named"};
  for (const Literal& fluent : fluents) {
    if (std::string why = refusal(fluent, revising); !why.empty()) return {false, std::move(why)};
  }
  for (const Literal& fluent : fluents)
    set(*find(fluent), kind, answered_by);
  closeIfAnswered(kind);
  return {true, ""};
}

void Dialogue::set(std::size_t candidate, AnswerKind kind, const std::string& answered_by) {
  knowledge_[candidate] = kind == AnswerKind::Yes  ? Knowledge::Wanted
                          : kind == AnswerKind::No ? Knowledge::NotWanted
                                                   : Knowledge::Unsure;
  answered_by_[candidate] = answered_by;
}

void Dialogue::closeIfAnswered(AnswerKind kind) {
  if (!open_) return;
  std::vector<std::size_t>& waiting = open_->candidates;
  const std::size_t before = waiting.size();
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                               [this](std::size_t f) { return knowledge_[f] != Knowledge::Open; }),
                waiting.end());
  // "These matter to me" out of a group says that the others don't.
  if (kind == AnswerKind::Yes && waiting.size() < before) {
    for (const std::size_t f : waiting)
      set(f, AnswerKind::No, "");
    waiting.clear();
  }
  if (!waiting.empty()) return;
  open_->record.answer = kind;
  records_.push_back(open_->record);
  open_.reset();
}

void Dialogue::ask(std::size_t candidate, const achievability::Conflict* conflict) {
  asked_ = askedWith(candidate);
  withdrawn_.reset();
  OpenQuestion question;
  question.candidates = {candidate};
  question.record.fluents = {fluents_[candidate]};
  question.record.round = records_.size() + 1;
  if (conflict != nullptr) {
    question.record.conflict_proven = conflict->proven;
    for (const std::size_t f : achievability::members(conflict->members)) {
      question.record.conflict.push_back(fluents_[f]);
    }
  }
  open_ = std::move(question);
}

void Dialogue::withdraw() {
  if (open_) withdrawn_ = open_->candidates.front();
  open_.reset();
}

void Dialogue::decline() {
  if (!open_) return;
  open_->record.answer = AnswerKind::Decline;
  records_.push_back(open_->record);
  open_.reset();
}

bool Dialogue::reopenUnsure() {
  bool any = false;
  for (std::size_t f = 0; f < knowledge_.size(); ++f) {
    if (knowledge_[f] != Knowledge::Unsure || reopened_[f]) continue;
    knowledge_[f] = Knowledge::Open;
    reopened_[f] = true;
    any = true;
  }
  return any;
}

achievability::CandidateSet Dialogue::with(Knowledge knowledge) const {
  achievability::CandidateSet set(knowledge_.size());
  for (std::size_t f = 0; f < knowledge_.size(); ++f)
    set.set(f, knowledge_[f] == knowledge);
  return set;
}

}  // namespace goal_alignment::session
