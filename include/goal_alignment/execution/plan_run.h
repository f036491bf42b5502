// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "goal_alignment/ExecutePlanFeedback.h"
#include "goal_alignment/ExecutePlanResult.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/execution/facts_ledger.h"
#include "goal_alignment/execution/facts_watch.h"
#include "goal_alignment/execution/plan_check.h"
#include "goal_alignment/execution/steps.h"

namespace goal_alignment::execution {

/// What runs plans are made of; outlives every run.
struct RunParts {
  any_message::MessageTypes& types;
  StepRunner& action;
  StepRunner& service;
  StepRunner& dispatch;
  StepRunner& simulated;
  AlignerLink& aligner;
  FactsLedger& ledger;
  any_message::WaitPoint& wait;
  ros::Publisher dispatches;
  ros::Publisher feedback;
  std::function<void(const std::string&)> warn_once;              ///< for people
  std::function<void(const std::set<std::string>&)> set_missing;  ///< servers, for people
};

/// One goal of execute_plan: the plan's steps one after the other, and those of the plans that
/// replace it. Nothing begins before all that carry steps out are there. Before a step it and all
/// that follow are held against the facts that the aligner knows, and after it the aligner is told
/// what has changed. Where a step fails for good, the rest of the plan can't succeed any more, or
/// the end is not what was guaranteed, the aligner is asked for a new plan under the same answers.
/// A failed step is believed to have changed nothing but what its rule says. It all ends, with a
/// reason, after `max_replans`, after the second failure of one ground action, and where the
/// aligner or its facts are not to be had.
class PlanRun {
 public:
  using Tell = std::function<void(const ExecutePlanFeedback&)>;

  PlanRun(const RunParts& parts, const StepMapping& mapping, const ExecutorOptions& options,
          Tell tell);

  /// Never throws: what goes wrong here is a result of INTERNAL, with what was done until then.
  ExecutePlanResult run(const Plan& plan);

  const Plan& plan() const { return plan_; }

 private:
  // What stops a plan; SUCCESS: nothing.
  struct PlanFailure {
    std::uint16_t outcome = ExecutePlanResult::SUCCESS;
    int step = -1;
    std::string reason;
    bool final = false;  // no new plan is asked for
  };

  ExecutePlanResult runOn();
  PlanFailure walk();
  PlanFailure awaitServers();
  bool isAvoidable(const StepRule& rule, const std::string& server);
  PlanFailure beforeStep(std::size_t index);
  PlanFailure atTheEnd();
  PlanFailure carryOut(const ActionDispatch& step);
  StepEnd tryOnce(const ActionDispatch& step, const StepRule& rule, int retries_left);
  PlanFailure treatFailure(const ActionDispatch& step, const StepRule& rule, const StepEnd& end);
  // Empty: there is a new plan.
  std::string replan(const PlanFailure& trouble);
  void dispatch(const ActionDispatch& step, const StepRule& rule);
  void report(const ActionDispatch& step, int status, bool on_topic);
  void tell(int step, int status, const std::string& message = "", const Plan& new_plan = {});
  StepRunner& runnerOf(StepKind kind) const;
  ExecutePlanResult resultOf(const PlanFailure& trouble) const;

  RunParts parts_;
  const StepMapping& mapping_;
  const ExecutorOptions& options_;
  Tell tell_;
  any_message::Clock::time_point begin_ = any_message::Clock::now();
  Plan plan_;
  FactsWatch facts_;
  std::map<std::string, int> failures_;  // by ground action
  std::set<std::string> given_up_;       // servers that were not there
  int replans_ = 0;
  std::vector<PlanStep> done_;
};

}  // namespace goal_alignment::execution
