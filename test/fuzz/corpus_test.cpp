// SPDX-License-Identifier: BSD-3-Clause
// The fuzzers' corpus once more, without a fuzzer: what broke something one day never does again.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/source_position.h"
#include "targets.h"
#include "unit/source_root.h"

namespace goal_alignment::fuzz {
namespace {

using Target = void (*)(std::string_view);

std::vector<std::filesystem::path> corpus(const std::string& folder) {
  const auto root = sourceRoot() / "test/fuzz/corpus" / folder;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(root))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The whole of a folder, which must not have got lost.
void replay(const std::string& folder, Target target) {
  const auto files = corpus(folder);
  EXPECT_GE(files.size(), 10U);
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    const std::string text = pddl::readFile(file.string()).text;
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(target(text));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

TEST(FuzzCorpus, PddlIsReadOrRefused) {
  replay("pddl", pddl);
}

TEST(FuzzCorpus, PlansAreReadOrRefused) {
  replay("plan", plan);
}

TEST(FuzzCorpus, YamlFilesAreReadOrRefused) {
  replay("yaml", yaml);
}

}  // namespace
}  // namespace goal_alignment::fuzz
