// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "goal_alignment/cli/alignment_options.h"
#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/json_output.h"

namespace goal_alignment::cli {

namespace {

struct BenchArguments {
  std::string root;
  std::vector<std::string> policies;
  int runs = 10;
  std::string csv;
  bool json = false;
  AlignmentWords words;
};

/// What the runs of one policy on one instance came to.
struct Row {
  std::string instance;
  std::string policy;
  std::size_t candidates = 0;
  std::size_t candidates_static = 0;
  std::vector<double> questions;
  std::vector<double> seconds;
  std::map<std::string, int> outcomes;
  std::string error;

  static double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
      sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
  }
  /// Of the sample, as the papers' tables have it.
  static double deviation(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    double sum = 0;
    for (const double value : values)
      sum += (value - mean(values)) * (value - mean(values));
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
  std::string outcomeText() const {
    if (!error.empty()) return "error: " + error;
    std::string text;
    for (const auto& [outcome, count] : outcomes) {
      text += (text.empty() ? "" : " ") + outcome;
      if (outcomes.size() > 1) text += fmt::format(" x{}", count);
    }
    return text;
  }
};

std::vector<std::string> instancesBelow(const std::string& root) {
  std::vector<std::string> folders;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().filename() == "robot_domain.pddl") {
      folders.push_back(entry.path().parent_path().string());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

void runOnce(const std::string& folder, const session::Options& options, Row& row) {
  const InstanceFiles files = InstanceFiles::of(folder);
  const ScriptedOracle oracle(files.true_goal);
  session::Session session(options);
  session.begin(readInput(files));
  while (session.step() != session::State::Done) {
    if (session.state() != session::State::AwaitingAnswer) continue;
    const std::vector<Literal> fluents = session.question()->fluents;
    for (const Literal& fluent : fluents)
      session.answer({fluent}, oracle.answer(fluent), "true goal");
  }
  const session::Snapshot view = session.snapshot();
  row.candidates = view.candidates.size();
  row.candidates_static = static_cast<std::size_t>(
      std::count_if(view.candidates.begin(), view.candidates.end(),
                    [](const session::CandidateView& candidate) { return candidate.is_static; }));
  row.questions.push_back(static_cast<double>(session.questions().size()));
  row.seconds.push_back(session.statistics().total);
  ++row.outcomes[session::outcomeWord(session.outcome().code)];
}

Row measure(const std::string& folder, const std::string& policy, const BenchArguments& arguments) {
  Row row;
  row.instance = std::filesystem::path(folder).filename().string();
  row.policy = policy;
  AlignmentWords words = arguments.words;
  words.policy = policy;
  session::Options options = words.options();
  try {
    for (int i = 0; i < arguments.runs; ++i, ++options.seed)
      runOnce(folder, options, row);
  } catch (const Exception& exception) {
    row.error = exception.what();
  }
  return row;
}

Json toJson(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    list.push_back({{"instance", row.instance},
                    {"policy", row.policy},
                    {"candidates", row.candidates},
                    {"candidates_static", row.candidates_static},
                    {"questions_mean", Row::mean(row.questions)},
                    {"questions_std", Row::deviation(row.questions)},
                    {"seconds_mean", Row::mean(row.seconds)},
                    {"outcome", row.outcomeText()}});
  }
  return list;
}

void writeCsv(const std::vector<Row>& rows, const std::string& file) {
  std::ofstream out(file);
  if (!out) throw pddl::InputError(file, {}, "can't write here");
  out << "instance,policy,candidates,candidates_static,questions_mean,questions_std,seconds_mean,"
         "outcome\n";
  for (const Row& row : rows) {
    out << fmt::format("{},{},{},{},{:.4f},{:.4f},{:.6f},\"{}\"\n", row.instance, row.policy,
                       row.candidates, row.candidates_static, Row::mean(row.questions),
                       Row::deviation(row.questions), Row::mean(row.seconds), row.outcomeText());
  }
}

void print(const Row& row) {
  std::cout << fmt::format("{:<20} {:<8} {:>4}/{:<4} {:>6.1f} ± {:<5.1f} {:>9.3f} s  {}\n",
                           row.instance, row.policy, row.candidates,
                           row.candidates - row.candidates_static, Row::mean(row.questions),
                           Row::deviation(row.questions), Row::mean(row.seconds), row.outcomeText())
            << std::flush;
}

int bench(BenchArguments arguments) {
  if (!std::filesystem::is_directory(arguments.root)) {
    throw pddl::InputError(arguments.root, {}, "expected a folder of instance folders");
  }
  if (arguments.policies.empty()) arguments.policies = {"auto"};
  std::vector<Row> rows;
  const std::vector<std::string> folders = instancesBelow(arguments.root);
  if (folders.empty()) throw pddl::InputError(arguments.root, {}, "no instance folder in here");
  if (!arguments.json) {
    std::cout
        << "instance             policy   candidates (all/without static), questions mean ± std, "
           "thinking time, outcome\n";
  }
  for (const std::string& folder : folders) {
    for (const std::string& policy : arguments.policies) {
      rows.push_back(measure(folder, policy, arguments));
      if (!arguments.json) print(rows.back());
    }
  }
  if (arguments.json) std::cout << toJson(rows).dump(2) << '\n';
  if (!arguments.csv.empty()) writeCsv(rows, arguments.csv);
  const bool all_ran =
      std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.error.empty(); });
  return all_ran ? 0 : session::exitStatus(session::OutcomeCode::InvalidModel);
}

}  // namespace

void addBenchCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand("bench", "align every instance below a folder");
  command->add_option("ROOT", arguments->root, "folder of instance folders")->required();
  command->add_option("--policy", arguments->policies, "may be given several times");
  command->add_option("--runs", arguments->runs, "runs that differ in the seed")
      ->check(CLI::PositiveNumber);
  command->add_option("--csv", arguments->csv, "write the table here, too");
  command->add_flag("--json", arguments->json);
  arguments->words.add(*command);
  command->callback([arguments, &run] {
    for (const std::string& policy : arguments->policies) {
      AlignmentWords words = arguments->words;
      words.policy = policy;
      words.options();  // refuse before the first instance
    }
    run = [arguments] { return bench(*arguments); };
  });
}

}  // namespace goal_alignment::cli
