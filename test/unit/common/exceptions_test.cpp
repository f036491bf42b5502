// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/exceptions.h"

#include <gtest/gtest.h>

#include <string>

namespace goal_alignment {
namespace {

TEST(LimitReached, SaysWhatStoppedAndWhy) {
  const LimitReached reached(LimitReason::Memory, "grounding");
  EXPECT_STREQ(reached.what(), "grounding stopped: memory");
  EXPECT_EQ(reached.reason(), LimitReason::Memory);
}

TEST(ThrowIfReached, DoesNothingWithoutAReason) {
  EXPECT_NO_THROW(throwIfReached(LimitReason::None, "grounding"));
}

TEST(ThrowIfReached, PutsItsWordsTogether) {
  try {
    throwIfReached(LimitReason::States, "reading ", std::string("a.pddl"));
    FAIL() << "nothing was thrown";
  } catch (const LimitReached& reached) {
    EXPECT_STREQ(reached.what(), "reading a.pddl stopped: states");
    EXPECT_EQ(reached.reason(), LimitReason::States);
  }
}

TEST(PollOrThrow, ThrowsOnceACancelHasCome) {
  CancelToken cancel;
  Limits limits;
  limits.cancel = &cancel;
  LimitMonitor monitor(limits);
  EXPECT_NO_THROW(pollOrThrow(monitor, "work"));
  cancel.cancel();
  EXPECT_THROW(pollOrThrow(monitor, "work"), LimitReached);
}

}  // namespace
}  // namespace goal_alignment
