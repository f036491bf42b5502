// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/outcome_text.h"

#include <algorithm>
#include <vector>

#include "goal_alignment/phrasing/outcomes.h"

namespace goal_alignment::ros_interface {
namespace {

using session::CandidateState;
using session::CandidateView;
using session::ConflictView;
using session::OutcomeCode;
using session::Snapshot;

bool isProven(const Snapshot& snapshot, const std::vector<Literal>& fluents) {
  const ConflictView* conflict = snapshot.conflictOf(fluents);
  return conflict != nullptr && conflict->proven;
}

// Those of the conflict that nobody is sure of.
std::vector<Literal> deciding(const Snapshot& snapshot, const std::vector<Literal>& conflict) {
  std::vector<Literal> fluents;
  for (const CandidateView& candidate : snapshot.candidates) {
    const bool part =
        std::find(conflict.begin(), conflict.end(), candidate.fluent) != conflict.end();
    if (part && candidate.state == CandidateState::Unsure) fluents.push_back(candidate.fluent);
  }
  return fluents;
}

std::vector<std::vector<Literal>> givenUp(const session::Outcome& outcome) {
  std::vector<std::vector<Literal>> sets;
  for (const session::Alternative& alternative : outcome.alternatives)
    sets.push_back(alternative.given_up);
  return sets;
}

std::string withoutAlternatives(const session::Outcome& outcome, const Snapshot& last,
                                const phrasing::Phrases& phrases) {
  const std::vector<Literal>& conflict = outcome.conflict;
  switch (outcome.code) {
    case OutcomeCode::Success:
      if (outcome.plan.assumed_not_wanted.empty()) break;
      return phrasing::planWithout(phrases, outcome.plan.assumed_not_wanted);
    case OutcomeCode::GoalUnsolvable:
      if (!last.condition.empty()) break;  // for which there are no words
      return phrasing::goalUnsolvable(phrases, last.specified);
    case OutcomeCode::ExpectationUnachievable:
      if (conflict.empty()) break;
      return phrasing::expectationUnachievable(phrases, conflict, givenUp(outcome));
    case OutcomeCode::UnsureBlocks:
      if (conflict.empty()) break;
      return phrasing::unsureBlocks(phrases, conflict, isProven(last, conflict),
                                    deciding(last, conflict));
    case OutcomeCode::TimeLimit:
    case OutcomeCode::MemoryLimit:
    case OutcomeCode::BudgetLimit:
      if (conflict.empty()) break;
      return phrasing::leftOpen(phrases, conflict);
    default:
      break;
  }
  return outcome.message;
}

// With a full stop, so that another sentence can follow.
std::string sentence(const std::string& text) {
  return text.empty() || text.back() == '.' ? text : text + ".";
}

}  // namespace

std::string spokenOutcome(const session::Outcome& outcome, const Snapshot& last,
                          const phrasing::Phrases& phrases) {
  const std::string text = withoutAlternatives(outcome, last, phrases);
  std::vector<std::vector<Literal>> sets = givenUp(outcome);
  const bool is_said = outcome.code == OutcomeCode::ExpectationUnachievable;
  if (sets.empty() || is_said) return text;
  sets.resize(std::min(sets.size(), phrasing::kSpokenAlternatives));
  return sentence(text) + " " + phrases.alternatives(sets);
}

}  // namespace goal_alignment::ros_interface
