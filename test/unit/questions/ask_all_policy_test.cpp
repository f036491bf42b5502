// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "goal_alignment/questions/policy.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using samples::askedAll;
using samples::conflict;
using samples::fresh;

PolicyContext contextWith(bool ask_static) {
  PolicyContext context;
  context.is_static = {false, true, false, true};
  context.ask_static = ask_static;
  return context;
}

TEST(AskAllPolicy, AsksEverythingInOrder) {
  const auto policy = makePolicy("ask-all", contextWith(true));
  EXPECT_EQ(askedAll(*policy, fresh(4, {}), Knowledge::Wanted),
            (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(AskAllPolicy, LeavesStaticFluentsOutWhereToldTo) {
  const auto policy = makePolicy("ask-all", contextWith(false));
  EXPECT_EQ(askedAll(*policy, fresh(4, {}), Knowledge::NotWanted),
            (std::vector<std::size_t>{0, 2}));
}

TEST(AskAllPolicy, SkipsWhatIsAnsweredAndNamesALiveConflict) {
  const auto policy = makePolicy("ask-all", contextWith(true));
  Situation situation = fresh(4, {conflict(4, 0b0110), conflict(4, 0b1000)});
  situation.knowledge[0] = Knowledge::Unsure;
  const auto choice = policy->next(situation);
  ASSERT_TRUE(choice.has_value());
  EXPECT_EQ(choice->candidate, 1U);
  EXPECT_EQ(choice->conflict, 0U);
  situation.knowledge[2] = Knowledge::NotWanted;
  EXPECT_EQ(policy->next(situation)->conflict, std::nullopt);
}

}  // namespace
}  // namespace goal_alignment::questions
