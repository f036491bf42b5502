// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/taken_tasks.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;

class TakenTasksTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  TakenTasks taken() {
    return {file_, [this](const std::string& line) { complaints_.push_back(line); }};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / "taken_tasks_test";
  const std::string file_ = folder_ / "state" / "latched";
  std::vector<std::string> complaints_;
};

TEST_F(TakenTasksTest, areKnownInALaterLife) {
  {
    TakenTasks before = taken();
    EXPECT_FALSE(before.knows("tea"));
    before.add("tea");
    before.add("coffee");
    EXPECT_TRUE(before.knows("tea"));
  }
  const TakenTasks now = taken();
  EXPECT_TRUE(now.knows("tea"));
  EXPECT_TRUE(now.knows("coffee"));
  EXPECT_FALSE(now.knows(""));
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(TakenTasksTest, theOldestAreForgotten) {
  TakenTasks before = taken();
  for (int i = 0; i < 150; ++i)
    before.add(std::to_string(i));
  for (const TakenTasks& tasks : {before, taken()}) {
    EXPECT_FALSE(tasks.knows("49"));
    EXPECT_TRUE(tasks.knows("50"));
    EXPECT_TRUE(tasks.knows("149"));
  }
}

TEST_F(TakenTasksTest, aFileThatCantBeWrittenIsComplainedOfOnce) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "state") << "no folder";
  TakenTasks tasks = taken();
  tasks.add("tea");
  tasks.add("coffee");
  EXPECT_TRUE(tasks.knows("tea")) << "in this life";
  EXPECT_EQ(complaints_.size(), 1U);
}

}  // namespace
}  // namespace goal_alignment::aligner
