// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>

#include "goal_alignment/cli/commands.h"
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
};

int validatePlan(const ValidateArguments& arguments) {
  const pddl::Model model =
      pddl::readModel(pddl::readFile(arguments.domain), pddl::readFile(arguments.problem));
  const std::vector<GroundName> plan = pddl::parsePlan(pddl::readFile(arguments.plan)).steps;
  if (const auto fault = validation::fault(model, plan, model.goalLiterals())) {
    std::cout << "invalid: " << *fault << '\n';
    return session::exitStatus(session::OutcomeCode::HumanPlanInvalid);
  }
  std::cout << "valid, " << plan.size() << " steps, cost "
            << validation::execute(model, plan).cost() << '\n';
  return 0;
}

}  // namespace

void addValidateCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand("validate", "execute a plan and check its goal");
  command->add_option("DOMAIN", arguments->domain)->required();
  command->add_option("PROBLEM", arguments->problem)->required();
  command->add_option("PLAN", arguments->plan)->required();
  command->callback([arguments, &run] { run = [arguments] { return validatePlan(*arguments); }; });
}

}  // namespace goal_alignment::cli
