// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "goal_alignment/pddl/parser.h"
#include "unit/source_root.h"

/// The benchmarks live outside the repository: `$GOAL_ALIGNMENT_SHARED/benchmarks`, or the folder
/// `shared` beside this source tree.
namespace goal_alignment::samples {

inline std::filesystem::path benchmarks() {
  namespace fs = std::filesystem;
  if (const char* shared = std::getenv("GOAL_ALIGNMENT_SHARED")) {
    return fs::path(shared) / "benchmarks";
  }
  return (sourceRoot() / "../shared/benchmarks").lexically_normal();
}

inline pddl::Source readBenchmark(const std::filesystem::path& path) {
  return pddl::readFile(path.string());
}

/// Tests that are skipped where the benchmarks are not.
class BenchmarkTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(benchmarks())) {
      GTEST_SKIP() << "no benchmarks at " << benchmarks() << "; set GOAL_ALIGNMENT_SHARED";
    }
  }
};

}  // namespace goal_alignment::samples
