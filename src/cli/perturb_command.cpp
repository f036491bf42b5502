// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/pddl/perturbation.h"

namespace goal_alignment::cli {

namespace {

struct PerturbArguments {
  std::string domain;
  std::string output;
  std::uint64_t seed = 0;
  std::size_t preconditions = 1;
  std::size_t deletes = 1;
  bool json = false;
};

void write(const std::string& text, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) throw std::invalid_argument(file + ": can't be written");
}

void report(const pddl::Perturbation& human, const PerturbArguments& arguments) {
  if (arguments.json) {
    Json json = {{"forgotten", human.forgotten}};
    if (arguments.output.empty()) json["domain"] = human.text;
    print(json);
    return;
  }
  if (arguments.output.empty()) std::cout << human.text << std::flush;
  for (const std::string& piece : human.forgotten)
    std::cerr << "forgotten: " << piece << '\n';
}

int perturbDomain(const PerturbArguments& arguments) {
  RandomSource random(arguments.seed);
  const pddl::Perturbation human = pddl::perturb(
      pddl::readFileOrPipe(arguments.domain), arguments.preconditions, arguments.deletes, random);
  if (!arguments.output.empty()) write(human.text, arguments.output);
  report(human, arguments);
  return 0;
}

}  // namespace

void addPerturbCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<PerturbArguments>();
  CLI::App* command =
      app.add_subcommand("perturb", "make a human's domain from the robot's, with gaps");
  command->add_option("DOMAIN", arguments->domain)->required();
  command->add_option("--seed", arguments->seed, "draws what is forgotten");
  command->add_option("--preconditions", arguments->preconditions, "how many are forgotten");
  command->add_option("--deletes", arguments->deletes, "how many delete effects are");
  command->add_option("-o", arguments->output, "file; standard output if not given");
  command->add_flag("--json", arguments->json);
  command->callback([arguments, &run] { run = [arguments] { return perturbDomain(*arguments); }; });
}

}  // namespace goal_alignment::cli
