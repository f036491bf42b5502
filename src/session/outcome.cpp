// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/outcome.h"

#include <new>
#include <stdexcept>

#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::session {

const char* outcomeWord(OutcomeCode code) noexcept {
  switch (code) {
    case OutcomeCode::Success:
      return "plan_found";
    case OutcomeCode::Canceled:
      return "canceled";
    case OutcomeCode::GoalUnsolvable:
    case OutcomeCode::ExpectationUnachievable:
      return "no_plan";
    case OutcomeCode::TimeLimit:
    case OutcomeCode::MemoryLimit:
    case OutcomeCode::BudgetLimit:
    case OutcomeCode::NoAnswer:
    case OutcomeCode::Declined:
    case OutcomeCode::QuestionLimit:
    case OutcomeCode::Contradiction:
    case OutcomeCode::UnsureBlocks:
    case OutcomeCode::Busy:
      return "undecided";
    case OutcomeCode::InvalidModel:
    case OutcomeCode::HumanPlanInvalid:
    case OutcomeCode::GoalNotExpected:
    case OutcomeCode::StateUnknown:
      return "invalid";
    case OutcomeCode::None:
    case OutcomeCode::Internal:
      return "internal";
  }
  return "internal";
}

int exitStatus(OutcomeCode code) noexcept {
  const auto band = static_cast<int>(code);
  if (code == OutcomeCode::Success) return 0;
  if (code == OutcomeCode::Canceled) return 4;
  if (code == OutcomeCode::GoalUnsolvable || code == OutcomeCode::ExpectationUnachievable) return 1;
  if (band >= 70 && band < 80) return 2;
  if (band > 50 && band < 70) return 3;
  return 5;
}

OutcomeCode outcomeOf(LimitReason reason) noexcept {
  switch (reason) {
    case LimitReason::Cancelled:
      return OutcomeCode::Canceled;
    case LimitReason::Memory:
      return OutcomeCode::MemoryLimit;
    case LimitReason::None:
    case LimitReason::States:
      return OutcomeCode::BudgetLimit;
    case LimitReason::Time:
      return OutcomeCode::TimeLimit;
  }
  return OutcomeCode::Internal;
}

Outcome outcomeOf(const std::exception& exception) {
  Outcome outcome;
  outcome.message = exception.what();
  if (const auto* limit = dynamic_cast<const LimitReached*>(&exception)) {
    outcome.code = outcomeOf(limit->reason());
  } else if (const auto* step = dynamic_cast<const alignment::HumanPlanInvalid*>(&exception)) {
    outcome.code = OutcomeCode::HumanPlanInvalid;
    outcome.failing_step = static_cast<int>(step->step());
    outcome.violation = step->violation();
  } else if (const auto* goal = dynamic_cast<const alignment::GoalNotExpected*>(&exception)) {
    outcome.code = OutcomeCode::GoalNotExpected;
    if (!goal->hasCondition()) outcome.missing = goal->missing();
  } else if (dynamic_cast<const alignment::GoalsDiffer*>(&exception) != nullptr ||
             dynamic_cast<const pddl::InputError*>(&exception) != nullptr) {
    outcome.code = OutcomeCode::InvalidModel;
  } else if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr) {
    outcome.code = OutcomeCode::MemoryLimit;
    outcome.message = "the machine has no memory left";
  } else {
    outcome.code = OutcomeCode::Internal;
  }
  return outcome;
}

}  // namespace goal_alignment::session
