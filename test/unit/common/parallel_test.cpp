// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace goal_alignment {
namespace {

TEST(InParallel, DoesEachPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(100);
    inParallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    for (const auto& count : done)
      EXPECT_EQ(count, 1);
  }
}

TEST(InParallel, OneThreadIsTheCallers) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  inParallel(3, 1, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(InParallel, ThrowsWhatTheFirstInOrderThrew) {
  for (const int threads : {1, 4}) {
    try {
      inParallel(10, threads, [](std::size_t i) {
        if (i >= 3) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "3");
    }
  }
}

}  // namespace
}  // namespace goal_alignment
