// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

/// The commands of the program `hagl`. Each function adds one subcommand to the command line; when
/// the user chose it, `run` becomes what carries it out and returns the exit status.
namespace goal_alignment::cli {

using Run = std::function<int()>;

void addAlignCommand(CLI::App& app, Run& run);
void addConflictsCommand(CLI::App& app, Run& run);
void addPlanCommand(CLI::App& app, Run& run);
void addValidateCommand(CLI::App& app, Run& run);
void addPerturbCommand(CLI::App& app, Run& run);
void addBenchCommand(CLI::App& app, Run& run);

}  // namespace goal_alignment::cli
