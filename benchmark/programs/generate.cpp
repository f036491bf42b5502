// SPDX-License-Identifier: BSD-3-Clause
// Writes one generated planning task, or one generated alignment, into a folder. Homes are always
// alignments: their people have a domain of their own.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>

#include "generators/alignment_instance.h"

namespace benchmarks = goal_alignment::benchmarks;

namespace {

struct Arguments {
  std::string family;
  std::string folder;
  int size = 4;
  std::uint64_t seed = 0;
  std::string differences;
  benchmarks::Truth truth;
};

void generate(const Arguments& arguments) {
  if (arguments.family == "large-home") {
    benchmarks::write(benchmarks::largeHome(arguments.seed), arguments.folder);
    return;
  }
  goal_alignment::RandomSource random(arguments.seed);
  if (arguments.family == "home") {
    benchmarks::write(benchmarks::homeAlignment(arguments.size, arguments.truth, random),
                      arguments.folder);
    return;
  }
  const auto models = benchmarks::familyCalled(arguments.family).make(arguments.size, random);
  if (arguments.differences.empty()) {
    benchmarks::write(models, arguments.folder);
    return;
  }
  const auto misreading = benchmarks::misreadingOf(arguments.differences);
  benchmarks::write(benchmarks::alignmentOf(models, misreading, arguments.truth, random),
                    arguments.folder);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes a generated planning task, or with --differences (or of `home` and `large-home`) an "
      "alignment, into DIR.");
  Arguments arguments;
  std::string families = "large-home";
  for (const benchmarks::MonotoneDnf& family : benchmarks::families())
    families += " " + family.name;
  app.add_option("FAMILY", arguments.family, "one of: " + families)->required();
  app.add_option("DIR", arguments.folder)->required();
  app.add_option("--size", arguments.size, "things to be moved, seated, …")
      ->check(CLI::Range(2, 1'000'000));
  app.add_option("--seed", arguments.seed);
  app.add_option("--differences", arguments.differences,
                 "in what the human's model differs: letters of `aisv` (actions, initial state, "
                 "statics, vocabulary)");
  app.add_option(
         "--wanted", arguments.truth.wanted,
         "how likely each expected fluent is wanted; without it, the true goal has one atom "
         "more than the stated one")
      ->check(CLI::Range(0.0, 1.0));
  CLI11_PARSE(app, argc, argv);
  try {
    generate(arguments);
    return 0;
  } catch (const std::exception& exception) {
    std::cerr << "goal_alignment_generate: " << exception.what() << '\n';
    return 2;
  }
}
