// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/outcome.h"

#include <new>
#include <stdexcept>

#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::session {

namespace {

using Code = OutcomeCode;
using Kind = OutcomeKind;
using From = AlternativesFrom;

// clang-format off
constexpr OutcomeTraits kOutcomes[] = {
    // code                        kind             resumable  robot  journal  request  alternatives
    {Code::None,                    Kind::Internal,  false,     false, true,    false,   From::Nothing},
    {Code::Success,                 Kind::PlanFound, false,     true,  true,    false,   From::Nothing},
    {Code::Canceled,                Kind::Canceled,  true,      false, false,   true,    From::Nothing},
    {Code::GoalUnsolvable,          Kind::NoPlan,    false,     true,  true,    false,   From::Nothing},
    {Code::ExpectationUnachievable, Kind::NoPlan,    false,     true,  true,    false,   From::ShortSearch},
    {Code::TimeLimit,               Kind::Undecided, true,      false, false,   false,   From::KnownPlans},
    {Code::MemoryLimit,             Kind::Undecided, true,      false, false,   false,   From::KnownPlans},
    {Code::BudgetLimit,             Kind::Undecided, true,      false, false,   false,   From::ShortSearch},
    {Code::NoAnswer,                Kind::Undecided, true,      false, false,   false,   From::Nothing},
    {Code::Declined,                Kind::Undecided, true,      false, false,   true,    From::ShortSearch},
    {Code::QuestionLimit,           Kind::Undecided, true,      false, false,   false,   From::ShortSearch},
    {Code::Contradiction,           Kind::Undecided, false,     false, true,    false,   From::Nothing},
    {Code::UnsureBlocks,            Kind::Undecided, true,      false, false,   false,   From::ShortSearch},
    {Code::Busy,                    Kind::Undecided, false,     false, true,    false,   From::Nothing},
    {Code::InvalidModel,            Kind::Invalid,   true,      false, false,   false,   From::Nothing},
    {Code::HumanPlanInvalid,        Kind::Invalid,   false,     false, true,    false,   From::Nothing},
    {Code::GoalNotExpected,         Kind::Invalid,   false,     false, true,    false,   From::Nothing},
    {Code::StateUnknown,            Kind::Invalid,   true,      false, false,   false,   From::Nothing},
    {Code::Internal,                Kind::Internal,  false,     false, false,   false,   From::Nothing},
};
// clang-format on

}  // namespace

const OutcomeTraits& outcomeTraits(OutcomeCode code) noexcept {
  for (const OutcomeTraits& row : kOutcomes) {
    if (row.code == code) return row;
  }
  return kOutcomes[0];
}

const char* outcomeWord(OutcomeCode code) noexcept {
  constexpr const char* kWords[] = {"plan_found", "no_plan",  "invalid",
                                    "undecided",  "canceled", "internal"};
  return kWords[exitStatus(code)];
}

int exitStatus(OutcomeCode code) noexcept {
  return static_cast<int>(outcomeTraits(code).kind);
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
