// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::session {

/// How an alignment ended; the numbers are part of the ROS interface. Bands: 1 success, 50 an
/// answer without a plan, 60 the dialogue, 70 the input, 80 a fault of ours.
enum class OutcomeCode : std::uint16_t {
  None = 0,  ///< never on purpose, so that an empty result does not read as success
  Success = 1,
  Canceled = 50,
  GoalUnsolvable = 51,           ///< G^H itself, proven
  ExpectationUnachievable = 52,  ///< a conflict whose fluents are all wanted, proven
  TimeLimit = 53,
  MemoryLimit = 54,
  BudgetLimit = 55,  ///< a search ran through its budget of states; more time would not help
  NoAnswer = 60,
  Declined = 61,
  QuestionLimit = 62,
  Contradiction = 63,
  UnsureBlocks = 64,
  Busy = 65,  ///< of the node: a plan is being carried out, so the task was not taken on
  InvalidModel = 70,
  HumanPlanInvalid = 71,
  GoalNotExpected = 72,
  StateUnknown = 73,
  Internal = 80,
};

/// The final plan and what it promises.
struct FinalPlan {
  std::vector<GroundName> steps;
  std::int64_t cost = 0;
  bool optimal = false;               ///< proven the cheapest for what it achieves
  std::vector<Literal> guaranteed;    ///< the specified goal and every fluent answered YES
  std::vector<Literal> kept_unasked;  ///< candidates achieved though nobody was asked
  std::int64_t extra_cost = 0;  ///< what `kept_unasked` costs beyond the cheapest plan found for
                                ///< `guaranteed`; that plan need not be the cheapest there is
  std::vector<Literal> not_wanted;          ///< candidates answered NO
  std::vector<Literal> assumed_not_wanted;  ///< Options::assumed_unwanted_predicates: nobody was
                                            ///< asked, and the plan does not promise them
};

/// What could be had instead, where a dialogue ended without a plan. After code 52 there is a plan
/// for everything answered YES but these fluents. After the others that have alternatives (53 to
/// 55, 61, 62, 64) there is one for everything not answered NO but these: answered NO, the session
/// finds it without another question.
struct Alternative {
  std::vector<Literal> given_up;
  /// That the person wants none of the fluents given up, as far as the answers let: the product of
  /// 1 − p over them, where p is the belief; what was answered YES counts as wanted but for one
  /// case in fifty, so there 0.02 · (1 − p).
  double probability = 0;
};

struct Outcome {
  OutcomeCode code = OutcomeCode::None;
  std::string message;            ///< one or two sentences for people
  FinalPlan plan;                 ///< with code Success
  std::vector<Literal> conflict;  ///< what can't be had together, with codes 51, 52, 64
  bool conflict_proven = false;   ///< proven, not only suspected
  bool conflict_minimal = false;  ///< every proper subset can be had
  /// The likeliest first, ten at most. With codes 53 and 54 from what was known already, so that
  /// less might do.
  std::vector<Alternative> alternatives;
  int failing_step = -1;  ///< index in the human plan, with code HumanPlanInvalid
  std::optional<validation::Violation> violation;  ///< of that step
  std::vector<Literal> missing;  ///< with code GoalNotExpected: what the plan does not lead to;
                                 ///< empty: something that is no literal
};

/// What an outcome means, whatever else is in it. The numbers are the exit statuses of the command
/// line.
enum class OutcomeKind : std::uint8_t {
  PlanFound = 0,
  NoPlan = 1,  ///< proven
  Invalid = 2,
  Undecided = 3,
  Canceled = 4,
  Internal = 5,
};

/// Where a dialogue that ends so gets its alternatives from.
enum class AlternativesFrom : std::uint8_t {
  Nothing,      ///< there are none
  KnownPlans,   ///< from the plans that are known already: a limit is used up
  ShortSearch,  ///< from a search of its own
};

/// All that is decided by an outcome's code alone: one row of the table of outcomes.
struct OutcomeTraits {
  OutcomeCode code;
  OutcomeKind kind;
  /// Session::resume() takes the work up where it was left. Models that are invalid may have been
  /// made so from outside; a plan or a goal that is wrong would be wrong once more.
  bool resumable;
  bool rests_on_robot_state;  ///< may be another outcome once the robot's state is another
  /// Nothing is left to take up after a crash. Internal is neither that nor resumable: the answers
  /// given must survive a fault of ours.
  bool closes_journal;
  bool ended_on_request;  ///< by the person or the client: no answer that still waits counts
  AlternativesFrom alternatives;
};

/// The row of this code; that of None for a number that is no code. O(number of codes).
const OutcomeTraits& outcomeTraits(OutcomeCode code) noexcept;

/// The word of the command line's JSON: plan_found no_plan undecided canceled invalid internal.
const char* outcomeWord(OutcomeCode code) noexcept;

/// The exit status of the command line: 0 plan_found, 1 no_plan, 2 invalid, 3 undecided,
/// 4 canceled, 5 internal.
int exitStatus(OutcomeCode code) noexcept;

/// The one place where an exception becomes an outcome.
Outcome outcomeOf(const std::exception& exception);

/// The outcome of work that a limit or a cancel stopped.
OutcomeCode outcomeOf(LimitReason reason) noexcept;

}  // namespace goal_alignment::session
