// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>

#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::cli {

namespace {

struct ValidateArguments {
  std::string domain;
  std::string problem;
  std::string plan;
  bool json = false;
};

int reportFault(const std::string& fault, bool json) {
  session::Outcome outcome;
  outcome.code = session::OutcomeCode::HumanPlanInvalid;
  outcome.message = fault;
  if (json) {
    print(toJson(outcome));
  } else {
    std::cout << "invalid: " << fault << '\n';
  }
  return session::exitStatus(outcome.code);
}

int validatePlan(const ValidateArguments& arguments) {
  const pddl::Model model = readModel(arguments.domain, arguments.problem);
  const std::vector<GroundName> plan = pddl::parsePlan(pddl::readFileOrPipe(arguments.plan)).steps;
  if (const auto fault = validation::fault(model, plan, model.goalLiterals())) {
    return reportFault(*fault, arguments.json);
  }
  const std::int64_t cost = validation::execute(model, plan).cost();
  if (arguments.json) {
    print({{"outcome", "valid"}, {"steps", plan.size()}, {"cost", cost}});
  } else {
    std::cout << "valid, " << plan.size() << " steps, cost " << cost << '\n';
  }
  return 0;
}

}  // namespace

void addValidateCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand("validate", "execute a plan and check its goal");
  command->add_option("DOMAIN", arguments->domain)->required();
  command->add_option("PROBLEM", arguments->problem)->required();
  command->add_option("PLAN", arguments->plan, "in any form that planners print")->required();
  command->add_flag("--json", arguments->json);
  command->callback([arguments, &run] { run = [arguments] { return validatePlan(*arguments); }; });
}

}  // namespace goal_alignment::cli
