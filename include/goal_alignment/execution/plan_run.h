// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "goal_alignment/ExecutePlanFeedback.h"
#include "goal_alignment/ExecutePlanResult.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/execution/robot_watch.h"
#include "goal_alignment/execution/steps.h"

namespace goal_alignment::execution {

/// Why a plan can't be run as it stands; empty: it can.
std::string faultOf(const Plan& plan);

/// "(go hall kitchen)"
std::string textOf(const ActionDispatch& step);

/// What runs plans are made of; outlives every run.
struct RunParts {
  MessageTypes& types;
  StepRunner& action;
  StepRunner& service;
  StepRunner& dispatch;
  StepRunner& simulated;
  AlignerLink& aligner;
  WaitPoint& wait;
  ros::Publisher dispatches;
  ros::Publisher feedback;
};

/// One goal of execute_plan: the plan's steps one after the other, and those of the plans that
/// replace it. Before a step its precondition is held against the facts that the aligner knows, and
/// after it the aligner is told what has changed. Where a step fails for good, a precondition does
/// not hold any more, or the end is not what was guaranteed, the aligner is asked for a new plan
/// under the same answers. A failed step is believed to have changed nothing but what its rule
/// says. It all ends, with a reason, after `max_replans`, after the second failure of one ground
/// action, and where the aligner or its facts are not to be had.
class PlanRun {
 public:
  using Tell = std::function<void(const ExecutePlanFeedback&)>;

  PlanRun(const RunParts& parts, const StepMapping& mapping, const ExecutorOptions& options,
          Tell tell);

  /// Why the steps of the plan can't be carried out with this mapping; empty: they can.
  std::string mappingFault(const Plan& plan) const;

  /// Never throws: what goes wrong here is a result of INTERNAL, with what was done until then.
  ExecutePlanResult run(const Plan& plan);

 private:
  // What stops a plan; SUCCESS: nothing.
  struct Trouble {
    std::uint16_t outcome = ExecutePlanResult::SUCCESS;
    int step = -1;
    std::string reason;
    bool final = false;  // no new plan is asked for
  };

  void checkServer(const std::string& name, const YAML::Node& node) const;
  void checkExpected(const MessageDefinition& definition, const StepRule& rule,
                     const Arguments& arguments) const;
  ExecutePlanResult runOn();
  void beginWatching();
  void stopWatching(const std::string& why);
  std::optional<WorldState> world();
  Trouble walk();
  Trouble awaitPrecondition(const ActionDispatch& step);
  Trouble awaitGoal();
  Trouble awaitFinding(const std::function<RobotWatch::Finding(const WorldState&)>& look, int step,
                       std::uint16_t outcome, const std::string& about);
  Trouble carryOut(const ActionDispatch& step);
  StepEnd tryOnce(const ActionDispatch& step, const StepRule& rule, int retries_left);
  Trouble treatFailure(const ActionDispatch& step, const StepRule& rule, const StepEnd& end);
  void treatSuccess(const ActionDispatch& step);
  void tellFailure(const ActionDispatch& step, const StepRule& rule);
  // Empty: there is a new plan.
  std::string planAnew(const Trouble& trouble);
  std::vector<Literal> failureFacts(const ActionDispatch& step, const StepRule& rule) const;
  void dispatch(const ActionDispatch& step, const StepRule& rule);
  void report(const ActionDispatch& step, int status, bool on_topic);
  void tell(int step, int status, const std::string& message = "", const Plan& new_plan = {});
  StepRunner& runnerOf(StepKind kind) const;
  ExecutePlanResult resultOf(const Trouble& trouble) const;

  RunParts parts_;
  const StepMapping& mapping_;
  const ExecutorOptions& options_;
  Tell tell_;
  Clock::time_point begin_ = Clock::now();
  Plan plan_;
  std::optional<RobotWatch> watch_;      // nothing: the plan just runs
  std::string unwatched_;                // why
  WorldState before_;                    // the step under way
  std::map<std::string, int> failures_;  // by ground action
  int replans_ = 0;
  std::vector<PlanStep> done_;
};

}  // namespace goal_alignment::execution
