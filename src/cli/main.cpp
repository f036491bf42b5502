// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "goal_alignment/cli/commands.h"
#include "goal_alignment/session/outcome.h"

namespace cli = goal_alignment::cli;

namespace {

constexpr int kUsageError = 2;

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Human-aware goal alignment: finds out what is really wanted, and plans for it.",
               "hagl");
  app.require_subcommand(1);
  cli::Run run;
  cli::addAlignCommand(app, run);
  cli::addConflictsCommand(app, run);
  cli::addPlanCommand(app, run);
  cli::addValidateCommand(app, run);
  cli::addBenchCommand(app, run);
  cli::addPerturbCommand(app, run);
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsageError;
  } catch (const std::invalid_argument& out_of_range) {
    std::cerr << "hagl: " << out_of_range.what() << '\n';
    return kUsageError;
  } catch (const std::exception& exception) {
    std::cerr << "hagl: " << exception.what() << '\n';
    return goal_alignment::session::exitStatus(goal_alignment::session::outcomeOf(exception).code);
  }
}
