// SPDX-License-Identifier: BSD-3-Clause
// Measures planning calls and whole alignments, each in a process of its own.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "goal_alignment/pddl/exceptions.h"
#include "measure/jobs.h"
#include "measure/report.h"

namespace {

using goal_alignment::benchmarks::Job;
using goal_alignment::benchmarks::Record;
using Jobs = std::vector<Job>;
namespace benchmarks = goal_alignment::benchmarks;

struct Arguments {
  std::vector<std::string> paths;
  std::vector<std::string> generated;
  std::vector<std::string> kinds;
  std::string only;
  benchmarks::DialogueOptions dialogue;
  std::uint64_t seed = 1;
  benchmarks::MeasureLimits limits;
  std::string csv;
  std::string report;
};

void add(Jobs more, Jobs& jobs) {
  std::move(more.begin(), more.end(), std::back_inserter(jobs));
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Jobs chosen(const Arguments& arguments) {
  std::vector<std::string> generated = arguments.generated;
  if (generated.empty() && (arguments.paths.empty() || !arguments.report.empty()))
    generated = {"calls", "alignments", "growth"};
  Jobs jobs;
  if (has(generated, "calls")) add(benchmarks::familyCalls(arguments.seed), jobs);
  if (has(generated, "alignments"))
    add(benchmarks::familyAlignments(arguments.seed, arguments.dialogue), jobs);
  if (has(generated, "growth"))
    add(benchmarks::householdGrowth(arguments.seed, arguments.dialogue), jobs);
  for (const std::string& path : arguments.paths)
    add(benchmarks::jobsBelow(path, arguments.dialogue), jobs);
  const auto unwanted = [&](const Job& job) {
    return (!arguments.kinds.empty() && !has(arguments.kinds, job.kind)) ||
           job.task.find(arguments.only) == std::string::npos;
  };
  jobs.erase(std::remove_if(jobs.begin(), jobs.end(), unwanted), jobs.end());
  return jobs;
}

// Calls and alignments have columns of their own, and so a table each.
std::vector<Record> measured(const Jobs& jobs, bool alignments,
                             const benchmarks::MeasureLimits& limits) {
  const std::vector<std::string> of_calls = {
      "task",  "kind",   "status",  "operators", "expanded", "evaluated", "evaluations_per_s",
      "parse", "ground", "mutexes", "search",    "total",    "peak_mib"};
  const std::vector<std::string> of_alignments = {
      "task",           "status", "operators",      "candidates",   "questions",  "checks",
      "checks_unknown", "parse",  "ground",         "belief",       "conflict_s", "question_s",
      "plan",           "total",  "first_question", "longest_step", "peak_mib"};
  std::vector<Record> records;
  const auto fits = [&](const Job& job) { return (job.kind == "align") == alignments; };
  if (std::none_of(jobs.begin(), jobs.end(), fits)) return records;
  benchmarks::TablePrinter table(std::cout, alignments ? of_alignments : of_calls);
  for (const Job& job : jobs) {
    if (!fits(job)) continue;
    records.push_back(benchmarks::run(job, limits));
    table.print(records.back());
  }
  return records;
}

std::string conditions(const Arguments& arguments) {
  std::ostringstream text;
  text << "Limits: " << arguments.limits.seconds << " s and " << arguments.limits.mebibytes
       << " MiB a task; seed " << arguments.seed << "; policy " << arguments.dialogue.policy
       << ".\n\n";
  return text.str();
}

void writeReport(const Arguments& arguments, const std::vector<Record>& calls,
                 const std::vector<Record>& alignments, const std::vector<Record>& all) {
  const std::filesystem::path base = std::filesystem::path(arguments.report) / "performance";
  std::filesystem::create_directories(base);
  if (!calls.empty()) benchmarks::writeCsv(calls, (base / "calls.csv").string());
  if (!alignments.empty()) benchmarks::writeCsv(alignments, (base / "alignments.csv").string());
  std::ofstream out(base / "summary.md");
  out << conditions(arguments) << benchmarks::summary(all);
  if (!out.flush())
    throw goal_alignment::pddl::InputError((base / "summary.md").string(), {}, "can't write here");
}

void measure(const Arguments& arguments) {
  const Jobs jobs = chosen(arguments);
  const std::vector<Record> calls = measured(jobs, false, arguments.limits);
  const std::vector<Record> alignments = measured(jobs, true, arguments.limits);
  std::vector<Record> all = calls;
  all.insert(all.end(), alignments.begin(), alignments.end());
  std::cout << '\n' << conditions(arguments) << benchmarks::summary(all);
  if (!arguments.csv.empty()) benchmarks::writeCsv(all, arguments.csv);
  if (!arguments.report.empty()) writeReport(arguments, calls, alignments, all);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures planning calls and alignments, each in a process of its own.");
  Arguments arguments;
  bool full = false;
  app.add_option("PATH", arguments.paths,
                 "folders of planning tasks and of alignments; none: generated ones");
  app.add_option("--generated", arguments.generated, "these of the generated ones, too")
      ->check(CLI::IsMember({"calls", "alignments", "growth"}));
  app.add_option("--kind", arguments.kinds, "only these kinds")
      ->check(CLI::IsMember({"first", "optimal", "align"}));
  app.add_option("--only", arguments.only, "only tasks whose name contains this");
  app.add_option("--policy", arguments.dialogue.policy, "of the alignments");
  app.add_flag("--full", full, "find all conflicts before the first question");
  app.add_option("--threads", arguments.dialogue.threads, "of an alignment")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", arguments.seed, "of the generated tasks");
  app.add_option("--time-limit", arguments.limits.seconds, "seconds a task")
      ->check(CLI::PositiveNumber);
  app.add_option("--memory-limit", arguments.limits.mebibytes, "MiB a task")
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", arguments.csv, "all figures");
  app.add_option("--report", arguments.report,
                 "folder whose subfolder `performance` gets tables and the summary");
  CLI11_PARSE(app, argc, argv);
  if (full) arguments.dialogue.conflicts = goal_alignment::session::ConflictMode::Full;
  try {
    measure(arguments);
    return 0;
  } catch (const std::exception& exception) {
    std::cerr << "goal_alignment_measure: " << exception.what() << '\n';
    return 2;
  }
}
