// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/task_notes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;

class TaskNotesTest : public testing::Test {
 protected:
  TaskNotesTest()
      : folder_(fs::temp_directory_path() / ("under_way_test." + std::to_string(getpid()))) {}
  ~TaskNotesTest() override { fs::remove_all(folder_); }

  // As after a restart.
  TaskNotes noteOf(const std::string& robot = "/r") {
    return TaskNotes(folder_.string(), robot,
                     [this](const std::string& line) { complaints_.push_back(line); });
  }

  fs::path folder_;
  std::vector<std::string> complaints_;
};

TEST_F(TaskNotesTest, aTaskThatDidNotEndIsToldOnce) {
  noteOf().begin({"s", "tidy", "Ann \"\n\xff"});
  EXPECT_FALSE(noteOf("/another").takeLost().running);
  const auto lost = noteOf().takeLost().running;
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->session_id, "s");
  EXPECT_EQ(lost->task_id, "tidy");
  EXPECT_EQ(lost->person.substr(0, 6), "Ann \"\n");
  EXPECT_FALSE(noteOf().takeLost().running);
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(TaskNotesTest, aTaskThatEndedIsNotLost) {
  TaskNotes note = noteOf();
  note.begin({"s", "", ""});
  note.begin({"t", "", ""});
  note.end();
  EXPECT_FALSE(noteOf().takeLost().running);
  note.end();
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(TaskNotesTest, tasksThatWaitedAreToldAfterTheOneThatRan) {
  {
    TaskNotes note = noteOf();
    note.setWaiting({{"", "tidy", "Ann"}, {"", "tea", ""}});
    note.begin({"s", "sweep", "Bob"});
    note.setWaiting({{"", "tea", ""}});
  }
  const TaskNotes::Tasks lost = noteOf().takeLost();
  ASSERT_TRUE(lost.running);
  EXPECT_EQ(lost.running->task_id, "sweep");
  ASSERT_EQ(lost.waiting.size(), 1U);
  EXPECT_EQ(lost.waiting[0].task_id, "tea");
  EXPECT_TRUE(noteOf().takeLost().waiting.empty());
}

TEST_F(TaskNotesTest, oneThatWaitsStaysNotedWhenTheOtherEnds) {
  {
    TaskNotes note = noteOf();
    note.begin({"s", "sweep", "Bob"});
    note.setWaiting({{"", "tea", ""}});
    note.end();
  }
  const TaskNotes::Tasks lost = noteOf().takeLost();
  EXPECT_FALSE(lost.running);
  EXPECT_EQ(lost.waiting.size(), 1U);
}

TEST_F(TaskNotesTest, aNoteThatNobodyCanReadIsComplainedOfAndGoes) {
  noteOf().begin({"s", "", ""});
  std::ofstream(folder_ / "r.json") << "{";
  EXPECT_FALSE(noteOf().takeLost().running);
  EXPECT_EQ(complaints_.size(), 1U);
  EXPECT_FALSE(noteOf().takeLost().running);
  EXPECT_EQ(complaints_.size(), 1U);
}

TEST_F(TaskNotesTest, aFolderThatCannotBeIsComplainedOfOnce) {
  std::ofstream(folder_) << "a file";
  TaskNotes note = noteOf();
  note.begin({"s", "", ""});
  note.begin({"s", "", ""});
  note.end();
  EXPECT_EQ(complaints_.size(), 1U);
}

}  // namespace
}  // namespace goal_alignment::aligner
