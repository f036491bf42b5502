// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

#include "goal_alignment/alignment/robot_analysis.h"
#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/interrupt.h"
#include "goal_alignment/cli/json_output.h"

namespace goal_alignment::cli {

namespace {

struct ConflictsArguments {
  std::string folder;
  double time_limit = 0;
  bool json = false;
};

Json toJson(const alignment::Problem& problem, const achievability::Achievability& robot) {
  Json list = Json::array();
  for (const achievability::Conflict& conflict : robot.conflicts()) {
    // Candidates are sorted, so their texts nearly are: by name and arguments, not by characters.
    std::vector<std::string> fluents;
    for (const std::size_t f : achievability::members(conflict.members)) {
      fluents.push_back(problem.candidates[f].fluent.text());
    }
    std::sort(fluents.begin(), fluents.end());
    list.push_back(
        {{"fluents", fluents}, {"proven", conflict.proven}, {"minimal", conflict.minimal}});
  }
  std::sort(list.begin(), list.end(), [](const Json& a, const Json& b) {
    return a["fluents"].get<std::vector<std::string>>() <
           b["fluents"].get<std::vector<std::string>>();
  });
  return {{"complete", robot.complete()}, {"conflicts", list}};
}

int findConflicts(const ConflictsArguments& arguments) {
  session::Input input = readInput(InstanceFiles::of(arguments.folder));
  CancelToken cancel;
  const InterruptGuard guard(cancel);
  Limits limits;
  limits.cancel = &cancel;
  if (arguments.time_limit > 0) limits = limits.withSeconds(arguments.time_limit);
  const alignment::Problem problem = alignment::makeProblem(
      pddl::readModel(input.robot_domain, input.robot_problem),
      pddl::readModel(input.human_domain, input.human_problem), {}, std::move(input.human_plan));
  achievability::SearchBudget budget;
  budget.open_sets = std::numeric_limits<std::uint64_t>::max();  // all are what is asked for
  const alignment::RobotAnalysis robot = alignment::analyseRobot(problem, true, budget, limits);
  const bool complete = robot.achievability->findAllConflicts(limits);
  const Json json = toJson(problem, *robot.achievability);
  if (arguments.json) {
    print(json);
  } else {
    for (const Json& conflict : json["conflicts"]) {
      std::cout << (conflict["proven"].get<bool>() ? "conflict " : "suspected");
      for (const Json& fluent : conflict["fluents"])
        std::cout << ' ' << fluent.get<std::string>();
      std::cout << '\n';
    }
    std::cout << (complete ? "complete" : "incomplete") << '\n';
  }
  if (cancel.cancelled()) return session::exitStatus(session::OutcomeCode::Canceled);
  return complete ? 0 : session::exitStatus(session::OutcomeCode::TimeLimit);
}

}  // namespace

void addConflictsCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<ConflictsArguments>();
  CLI::App* command = app.add_subcommand("conflicts", "list what can't be had together");
  command->add_option("DIR", arguments->folder, "instance folder")->required();
  command->add_option("--time-limit", arguments->time_limit, "seconds")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", arguments->json);
  command->callback([arguments, &run] { run = [arguments] { return findConflicts(*arguments); }; });
}

}  // namespace goal_alignment::cli
