// SPDX-License-Identifier: BSD-3-Clause
#include "conclusion.h"

#include <string>
#include <utility>

#include "fluents.h"

namespace goal_alignment::session {

using achievability::Conflict;
using alignment::Problem;

namespace {

Outcome restingOn(OutcomeCode code, const Conflict& conflict, const Problem& problem) {
  Outcome outcome;
  outcome.code = code;
  outcome.conflict = fluentsOf(problem, conflict.members);
  outcome.conflict_proven = conflict.proven;
  outcome.conflict_minimal = conflict.minimal;
  return outcome;
}

Outcome restingOn(OutcomeCode code, const std::optional<Conflict>& conflict,
                  const Problem& problem) {
  if (conflict) return restingOn(code, *conflict, problem);
  Outcome outcome;
  outcome.code = code;
  return outcome;
}

}  // namespace

Outcome outcomeOf(FinalPlan plan, const Problem& problem) {
  Outcome outcome;
  outcome.code = OutcomeCode::Success;
  outcome.plan = std::move(plan);
  outcome.message =
      "I have a plan. It does what you asked and keeps everything you didn't rule out.";
  if (!outcome.plan.assumed_not_wanted.empty()) {
    outcome.message += " I don't promise this, since nobody was asked about it: " +
                       listed(problem, outcome.plan.assumed_not_wanted) + ".";
  }
  return outcome;
}

Outcome outcomeOf(const GoalUnsolvable& decision, const Problem& problem) {
  Outcome outcome = restingOn(OutcomeCode::GoalUnsolvable, decision.conflict, problem);
  outcome.message = "no plan can achieve what was asked for: " + askedFor(problem);
  return outcome;
}

Outcome expectationUnachievable(const Conflict& conflict, std::vector<Alternative> alternatives,
                                const Problem& problem) {
  Outcome outcome = restingOn(OutcomeCode::ExpectationUnachievable, conflict, problem);
  outcome.alternatives = std::move(alternatives);
  outcome.message = "proven: no plan achieves what was asked for together with " +
                    listed(problem, outcome.conflict);
  return outcome;
}

Outcome outcomeOf(const Blocked& decision, const Problem& problem) {
  Outcome outcome = restingOn(OutcomeCode::UnsureBlocks, decision.conflict, problem);
  const std::string unsure = listed(problem, fluentsOf(problem, decision.unsure));
  if (decision.at_once) {
    outcome.message = "\"don't know\" ends this dialogue undecided; it depends on " + unsure;
  } else {
    outcome.message = (outcome.conflict_proven ? "what is wanted can't be had all together"
                                               : "what is wanted may not be had all together") +
                      ("; it depends on " + unsure);
  }
  return outcome;
}

Outcome outcomeOf(const Exhausted& decision, const Problem& problem) {
  Outcome outcome = restingOn(outcomeOf(decision.limit), decision.conflict, problem);
  outcome.message = decision.message;
  return outcome;
}

}  // namespace goal_alignment::session
