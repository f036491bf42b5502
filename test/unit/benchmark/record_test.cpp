// SPDX-License-Identifier: BSD-3-Clause
#include "measure/record.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::benchmarks {
namespace {

TEST(Record, comesBackFromItsLines) {
  Record record;
  record.set("status", std::string("failed"));
  record.set("error", std::string("one line\nand = another"));
  record.set("total", 0.25);
  Record read;
  read.read(record.serialised());
  EXPECT_EQ(read.text("error"), "one line and = another");
  EXPECT_EQ(read.number("total"), 0.25);
  EXPECT_EQ(read.fields().front().first, "status");
}

TEST(Record, keepsThePlaceOfAFieldThatIsSetAgain) {
  Record record;
  record.set("a", std::size_t{1});
  record.set("b", std::size_t{2});
  record.set("a", std::size_t{3});
  ASSERT_EQ(record.fields().size(), 2U);
  EXPECT_EQ(record.fields().front().second, "3");
  EXPECT_EQ(record.text("c"), "");
}

TEST(Csv, quotesWhatNeedsIt) {
  Record one;
  one.set("task", std::string("a, \"b\""));
  Record other;
  other.set("cost", std::size_t{7});
  const std::string file = testing::TempDir() + "records.csv";
  writeCsv({one, other}, file);
  EXPECT_EQ(pddl::readFile(file).text, "task,cost\n\"a, \"\"b\"\"\",\n,7\n");
  std::filesystem::remove(file);
  EXPECT_THROW(writeCsv({one}, testing::TempDir() + "no/such/folder.csv"), pddl::InputError);
}

}  // namespace
}  // namespace goal_alignment::benchmarks
