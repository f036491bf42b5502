// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench_instance.h"
#include "bench_report.h"
#include "bench_workers.h"
#include "goal_alignment/cli/alignment_options.h"
#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/interrupt.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::cli {

namespace {

struct BenchArguments {
  std::string root;
  std::vector<std::string> truths;
  std::string csv;
  bool json = false;
  BenchPlan plan;
};

/// Refuses what is wrong before the first instance.
void check(BenchArguments& arguments) {
  BenchPlan& plan = arguments.plan;
  std::vector<std::string> policies;
  for (const std::string& policy : plan.policies) {
    AlignmentWords words = plan.words;
    words.policy = policy;
    const session::Session refuses_what_is_wrong(words.options());
    if (std::find(policies.begin(), policies.end(), policy) == policies.end())
      policies.push_back(policy);
  }
  plan.policies = std::move(policies);
  plan.truths = truthsNamed(arguments.truths);
}

void requireWritable(const std::string& file) {
  if (file.empty()) return;
  const std::ofstream out(file, std::ios::app);
  if (!out) throw pddl::InputError(file, {}, "can't write here");
}

Json toJson(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows)
    list.push_back(toJson(row));
  return list;
}

/// Shows the rows as they come, or keeps them for the end. True: it was not interrupted.
bool measure(const BenchArguments& arguments, const std::vector<InstanceFolder>& instances,
             BenchTable& table, std::vector<Row>& rows) {
  const BenchPlan& plan = arguments.plan;
  const bool mixed = arguments.json && ::isatty(STDOUT_FILENO) == 1;
  ProgressBar bar(progressStream(!mixed),
                  instances.size() * plan.truths.size() * plan.runsOfTruth());
  CancelToken cancel;
  const InterruptGuard guard(cancel);
  measureAll(instances, plan, plan.words.threads, cancel, bar, [&](InstanceResult result) {
    if (!result.note.empty()) std::cerr << "hagl: " << result.note << '\n';
    if (!arguments.json) table.print(result.rows);
    std::move(result.rows.begin(), result.rows.end(), std::back_inserter(rows));
  });
  return !cancel.cancelled();
}

int bench(const BenchArguments& arguments) {
  const std::vector<InstanceFolder> instances = instancesBelow(arguments.root);
  requireWritable(arguments.csv);
  std::size_t widest = 0;
  for (const InstanceFolder& instance : instances)
    widest = std::max(widest, instance.name.size());
  BenchTable table(std::cout, widest);
  std::vector<Row> rows;
  const bool whole = measure(arguments, instances, table, rows);
  if (arguments.json)
    std::cout << toJson(rows).dump(2) << '\n';
  else
    table.printSummary(rows);
  if (!arguments.csv.empty()) {
    writeCsv(rows, arguments.csv);
    writePlots(rows, arguments.csv);
  }
  if (!whole) return session::exitStatus(session::OutcomeCode::Canceled);
  const bool all_ran =
      std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.error.empty(); });
  return all_ran ? 0 : session::exitStatus(session::OutcomeCode::InvalidModel);
}

}  // namespace

void addBenchCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand("bench", "align every instance below a folder");
  command->add_option("ROOT", arguments->root, "folder of instance folders")->required();
  command->add_option("--policy", arguments->plan.policies, "may be repeated; auto else");
  command->add_option("--truth", arguments->truths,
                      "own, or the probability that a candidate is wanted; may be repeated; "
                      "own, 0.2 and 0.5 else");
  command->add_option("--runs", arguments->plan.runs, "runs that differ in the seed")
      ->check(CLI::PositiveNumber);
  command->add_option("--csv", arguments->csv, "write the table here, too, and plots beside it");
  command->add_flag("--json", arguments->json);
  arguments->plan.words.add(*command);
  command->get_option("--threads")->description("instances measured side by side");
  command->callback([arguments, &run] {
    if (arguments->plan.policies.empty()) arguments->plan.policies = {"auto"};
    check(*arguments);
    run = [arguments] { return bench(*arguments); };
  });
}

}  // namespace goal_alignment::cli
