// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/under_way.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;

class UnderWayTest : public testing::Test {
 protected:
  UnderWayTest()
      : folder_(fs::temp_directory_path() / ("under_way_test." + std::to_string(getpid()))) {}
  ~UnderWayTest() override { fs::remove_all(folder_); }

  // As after a restart.
  UnderWay noteOf(const std::string& robot = "/r") {
    return UnderWay(folder_.string(), robot,
                    [this](const std::string& line) { complaints_.push_back(line); });
  }

  fs::path folder_;
  std::vector<std::string> complaints_;
};

TEST_F(UnderWayTest, aTaskThatDidNotEndIsToldOnce) {
  noteOf().begin({"s", "tidy", "Ann \"\n\xff"});
  EXPECT_FALSE(noteOf("/another").lost().running);
  const auto lost = noteOf().lost().running;
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->session_id, "s");
  EXPECT_EQ(lost->task_id, "tidy");
  EXPECT_EQ(lost->person.substr(0, 6), "Ann \"\n");
  EXPECT_FALSE(noteOf().lost().running);
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(UnderWayTest, aTaskThatEndedIsNotLost) {
  UnderWay note = noteOf();
  note.begin({"s", "", ""});
  note.begin({"t", "", ""});
  note.end();
  EXPECT_FALSE(noteOf().lost().running);
  note.end();
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(UnderWayTest, tasksThatWaitedAreToldAfterTheOneThatRan) {
  {
    UnderWay note = noteOf();
    note.wait({{"", "tidy", "Ann"}, {"", "tea", ""}});
    note.begin({"s", "sweep", "Bob"});
    note.wait({{"", "tea", ""}});
  }
  const UnderWay::Tasks lost = noteOf().lost();
  ASSERT_TRUE(lost.running);
  EXPECT_EQ(lost.running->task_id, "sweep");
  ASSERT_EQ(lost.waiting.size(), 1U);
  EXPECT_EQ(lost.waiting[0].task_id, "tea");
  EXPECT_TRUE(noteOf().lost().waiting.empty());
}

TEST_F(UnderWayTest, oneThatWaitsStaysNotedWhenTheOtherEnds) {
  {
    UnderWay note = noteOf();
    note.begin({"s", "sweep", "Bob"});
    note.wait({{"", "tea", ""}});
    note.end();
  }
  const UnderWay::Tasks lost = noteOf().lost();
  EXPECT_FALSE(lost.running);
  EXPECT_EQ(lost.waiting.size(), 1U);
}

TEST_F(UnderWayTest, aNoteThatNobodyCanReadIsComplainedOfAndGoes) {
  noteOf().begin({"s", "", ""});
  std::ofstream(folder_ / "r.json") << "{";
  EXPECT_FALSE(noteOf().lost().running);
  EXPECT_EQ(complaints_.size(), 1U);
  EXPECT_FALSE(noteOf().lost().running);
  EXPECT_EQ(complaints_.size(), 1U);
}

TEST_F(UnderWayTest, aFolderThatCannotBeIsComplainedOfOnce) {
  std::ofstream(folder_) << "a file";
  UnderWay note = noteOf();
  note.begin({"s", "", ""});
  note.begin({"s", "", ""});
  note.end();
  EXPECT_EQ(complaints_.size(), 1U);
}

}  // namespace
}  // namespace goal_alignment::aligner
