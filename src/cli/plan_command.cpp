// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/interrupt.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/search/solve.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::cli {

using session::OutcomeCode;

namespace {

struct PlanArguments {
  std::string domain;
  std::string problem;
  bool optimal = false;
  bool json = false;
  double time_limit = 0;
  std::size_t memory_limit_mib = 2048;
};

double peakMib() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// One planning call, from text to a validated plan.
class Planning {
 public:
  explicit Planning(const PlanArguments& arguments) : arguments_(arguments) {}

  int run() {
    const InterruptGuard guard(cancel_);
    Limits limits;
    limits.cancel = &cancel_;
    limits.bytes = accountable(arguments_.memory_limit_mib << 20U);
    if (arguments_.time_limit > 0) limits = limits.withSeconds(arguments_.time_limit);
    try {
      plan(limits);
    } catch (const LimitReached& limit) {
      result_.status = search::Status::LimitReached;
      result_.limit = limit.reason();
    }
    timing_["total"] = secondsSince(began_);
    report();
    return session::exitStatus(code());
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double secondsSince(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  void plan(const Limits& limits) {
    Clock::time_point phase = Clock::now();
    const auto lap = [&](const char* name) {
      timing_[name] = secondsSince(phase);
      phase = Clock::now();
    };
    const pddl::Model model = readModel(arguments_.domain, arguments_.problem);
    lap("parse");
    const std::vector<Literal> goal = model.goalLiterals();
    const bool unit_costs = !(arguments_.optimal && model.has_costs);
    const grounding::GroundTask ground = grounding::ground(model, goal, {unit_costs}, limits);
    lap("ground");
    const auto seek = arguments_.optimal ? search::Seek::OptimalPlan : search::Seek::AnyPlan;
    result_ = search::solve(ground.task, ground.goal(goal), seek, limits);
    steps_ = task::names(ground.task, result_.plan);
    lap("search");
    if (result_.status != search::Status::Solved) return;
    if (const auto fault = validation::fault(model, steps_, goal)) {
      throw Exception("the plan found did not pass validation: " + *fault);
    }
    result_.cost = validation::execute(model, steps_).cost();
  }

  OutcomeCode code() const {
    switch (result_.status) {
      case search::Status::Solved:
        return OutcomeCode::Success;
      case search::Status::Unsolvable:
        return OutcomeCode::GoalUnsolvable;
      case search::Status::LimitReached:
        return session::outcomeOf(result_.limit);
    }
    return OutcomeCode::Internal;
  }

  void report() const {
    if (!arguments_.json) {
      for (const GroundName& step : steps_)
        std::cout << step.text() << '\n';
      std::cout << "; " << session::outcomeWord(code());
      if (result_.status == search::Status::Solved) std::cout << ", cost " << result_.cost;
      if (result_.status == search::Status::LimitReached) {
        std::cout << ", limit: " << toString(result_.limit);
      }
      std::cout << '\n';
      return;
    }
    Json json = {{"outcome", session::outcomeWord(code())}};
    if (result_.status == search::Status::Solved) {
      json["plan"] = texts(steps_);
      json["cost"] = result_.cost;
      json["optimal"] = arguments_.optimal;
    }
    json["expanded"] = result_.statistics.expanded;
    json["evaluated"] = result_.statistics.evaluated;
    json["timing"] = timing_;
    json["peak_mib"] = peakMib();
    print(json);
  }

  const PlanArguments& arguments_;
  Clock::time_point began_ = Clock::now();
  CancelToken cancel_;
  search::Result result_;
  std::vector<GroundName> steps_;
  Json timing_;
};

}  // namespace

void addPlanCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "solve one planning task");
  command->add_option("DOMAIN", arguments->domain)->required();
  command->add_option("PROBLEM", arguments->problem)->required();
  command->add_flag("--optimal", arguments->optimal, "minimise the problem's metric");
  command->add_option("--time-limit", arguments->time_limit, "seconds")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--memory-limit", arguments->memory_limit_mib, "MiB")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", arguments->json);
  command->callback(
      [arguments, &run] { run = [arguments] { return Planning(*arguments).run(); }; });
}

}  // namespace goal_alignment::cli
