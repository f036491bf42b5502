// SPDX-License-Identifier: BSD-3-Clause
#include "outcome_text.h"

#include <algorithm>
#include <vector>

#include "goal_alignment/phrasing/outcomes.h"

namespace goal_alignment::aligner {
namespace {

using session::CandidateState;
using session::CandidateView;
using session::ConflictView;
using session::OutcomeCode;
using session::Snapshot;

questions::Reason reasonOf(const session::Outcome& outcome, const Snapshot& snapshot) {
  questions::Reason reason;
  reason.conflict = outcome.conflict;
  const ConflictView* conflict = snapshot.conflictOf(outcome.conflict);
  if (conflict == nullptr) return reason;
  reason.proven = conflict->proven;
  reason.alone = conflict->alone;
  return reason;
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

std::string limitText(const session::Outcome& outcome, phrasing::Limit limit,
                      const phrasing::Phrases& phrases) {
  return outcome.conflict.empty() ? phrasing::leftOpen(phrases, outcome.message, limit)
                                  : phrasing::leftOpen(phrases, outcome.conflict, limit);
}

std::string unsureText(const session::Outcome& outcome, const Snapshot& last,
                       const phrasing::Phrases& phrases) {
  if (outcome.conflict.empty()) return phrases.say("outcome_unsure");
  return phrasing::unsureBlocks(phrases, reasonOf(outcome, last), deciding(last, outcome.conflict),
                                givenUp(outcome));
}

// Of what is wrong with the person's plan; empty: there are no words for it.
std::string planFault(const session::Outcome& outcome, const phrasing::Phrases& phrases,
                      const std::vector<GroundName>& human_plan) {
  const auto& violation = outcome.violation;
  if (violation && violation->step < human_plan.size()) {
    return phrases.say("plan_wrong", {phrases.failure(*violation, human_plan[violation->step])});
  }
  if (outcome.missing.empty()) return "";
  return phrasing::planMisses(phrases, outcome.missing, !human_plan.empty());
}

// What there could be instead is not part of it, but with EXPECTATION_UNACHIEVABLE and
// UNSURE_BLOCKS.
std::string ending(const session::Outcome& outcome, const Snapshot& last,
                   const phrasing::Phrases& phrases, const std::vector<GroundName>& human_plan) {
  std::string text;
  switch (outcome.code) {
    case OutcomeCode::Success:
      return phrasing::planFound(phrases, outcome.plan.assumed_not_wanted);
    case OutcomeCode::Canceled:
      return phrases.say("outcome_canceled");
    case OutcomeCode::GoalUnsolvable:
      // There are no words for a condition.
      return phrasing::goalUnsolvable(
          phrases, last.condition.empty() ? last.specified : std::vector<Literal>{});
    case OutcomeCode::ExpectationUnachievable:
      if (outcome.conflict.empty()) break;
      return phrasing::expectationUnachievable(phrases, reasonOf(outcome, last), givenUp(outcome));
    case OutcomeCode::UnsureBlocks:
      return unsureText(outcome, last, phrases);
    case OutcomeCode::TimeLimit:
      return limitText(outcome, phrasing::Limit::Time, phrases);
    case OutcomeCode::MemoryLimit:
      return limitText(outcome, phrasing::Limit::Memory, phrases);
    case OutcomeCode::BudgetLimit:
      return limitText(outcome, phrasing::Limit::Budget, phrases);
    case OutcomeCode::StateUnknown:
      return phrases.say("facts_unknown", {phrases.inWords(outcome.message)});
    case OutcomeCode::Declined:
      return phrases.say("outcome_declined");
    case OutcomeCode::QuestionLimit:
      return phrases.say("outcome_question_limit");
    case OutcomeCode::HumanPlanInvalid:
    case OutcomeCode::GoalNotExpected:
      text = planFault(outcome, phrases, human_plan);
      break;
    default:
      break;
  }
  return text.empty() ? outcome.message : text;
}

// With a full stop, so that another sentence can follow.
std::string sentence(const std::string& text) {
  return text.empty() || text.back() == '.' ? text : text + ".";
}

}  // namespace

std::string spokenOutcome(const session::Outcome& outcome, const Snapshot& last,
                          const phrasing::Phrases& phrases,
                          const std::vector<GroundName>& human_plan) {
  const std::string text = ending(outcome, last, phrases, human_plan);
  const bool is_said = outcome.code == OutcomeCode::ExpectationUnachievable ||
                       (outcome.code == OutcomeCode::UnsureBlocks && !outcome.conflict.empty());
  std::vector<std::vector<Literal>> sets = givenUp(outcome);
  if (sets.empty() || is_said) return text;
  sets.resize(std::min(sets.size(), phrasing::kSpokenAlternatives));
  return sentence(text) + " " + phrases.alternatives(sets);
}

}  // namespace goal_alignment::aligner
