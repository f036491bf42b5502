// SPDX-License-Identifier: BSD-3-Clause
#include "session/option_ranges.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace goal_alignment::session {
namespace {

TEST(OptionRanges, TheDefaultsAreWithinThem) {
  EXPECT_NO_THROW(requireInRange({}));
}

TEST(OptionRanges, SayWhichOptionIsOutOfThem) {
  Options options;
  options.belief.flat = 2;
  try {
    requireInRange(options);
    FAIL() << "it was let pass";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "a flat belief must lie between 0 and 1");
  }
  options = {};
  options.policy = "none such";
  EXPECT_THROW(requireInRange(options), std::invalid_argument);
}

}  // namespace
}  // namespace goal_alignment::session
