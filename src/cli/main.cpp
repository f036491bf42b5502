// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/session/outcome.h"

namespace cli = goal_alignment::cli;
namespace session = goal_alignment::session;

namespace {

/// Known even where the rest of the command line is not understood.
bool wantsJson(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* word) { return std::string_view(word) == "--json"; });
}

/// Whoever reads JSON gets an object whatever happens. Returns the exit status.
int fail(const session::Outcome& outcome, bool json) {
  if (json) cli::print(cli::toJson(outcome));
  return session::exitStatus(outcome.code);
}

session::Outcome invalid(const std::exception& exception) {
  session::Outcome outcome;
  outcome.code = session::OutcomeCode::InvalidModel;
  outcome.message = exception.what();
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = wantsJson(argc, argv);
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
    return app.exit(error) == 0 ? 0 : fail(invalid(error), json);
  } catch (const std::invalid_argument& out_of_range) {
    std::cerr << "hagl: " << out_of_range.what() << '\n';
    return fail(invalid(out_of_range), json);
  } catch (const std::exception& exception) {
    std::cerr << "hagl: " << exception.what() << '\n';
    return fail(session::outcomeOf(exception), json);
  }
}
