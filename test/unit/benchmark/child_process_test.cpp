// SPDX-License-Identifier: BSD-3-Clause
#include "measure/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

namespace goal_alignment::benchmarks {
namespace {

TEST(ChildProcess, handsBackWhatTheWorkFound) {
  const Record record =
      runInChild([](Record& mine, const Save&) { mine.set("status", std::string("solved")); }, {});
  EXPECT_EQ(record.text("status"), "solved");
  EXPECT_GT(record.number("peak_mib"), 0);
}

TEST(ChildProcess, saysWhatWasThrown) {
  const Record record =
      runInChild([](Record&, const Save&) { throw std::runtime_error("no such file"); }, {});
  EXPECT_EQ(record.text("status"), "failed");
  EXPECT_EQ(record.text("error"), "no such file");
}

TEST(ChildProcess, survivesACrashAndKeepsWhatWasSaved) {
  const Record record = runInChild(
      [](Record& mine, const Save& save) {
        mine.set("questions", std::size_t{3});
        save();
        std::raise(SIGKILL);
      },
      {});
  EXPECT_EQ(record.text("status"), "crashed: signal 9");
  EXPECT_EQ(record.number("questions"), 3);
}

TEST(ChildProcess, isKilledWhenItsTimeIsUp) {
  const Record record = runInChild(
      [](Record&, const Save&) {
        for (;;)
          raise(SIGSTOP);
      },
      {0.2, 2048});
  EXPECT_EQ(record.text("status"), "killed: time");
}

TEST(ChildProcess, hasNoMoreMemoryThanItsLimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's shadow takes the whole address space";
#endif
  const Record record = runInChild(
      [](Record& mine, const Save&) {
        std::vector<std::string> held;
        for (int i = 0; i < 1000; ++i)
          held.emplace_back(1U << 20U, 'x');
        mine.set("status", std::to_string(held.size()));
      },
      {60, 400});
  EXPECT_EQ(record.text("status"), "limit: memory");
}

}  // namespace
}  // namespace goal_alignment::benchmarks
