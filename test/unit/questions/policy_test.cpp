// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/policy.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace goal_alignment::questions {
namespace {

TEST(Policy, EveryNameMakesOne) {
  EXPECT_EQ(policyNames(),
            (std::vector<std::string>{"auto", "optimal", "ratio", "paper", "ask-all"}));
  for (const std::string& name : policyNames())
    EXPECT_NE(makePolicy(name, {}), nullptr) << name;
}

TEST(Policy, AllButThePublishedOnesGoByConflicts) {
  for (const char* name : {"auto", "optimal", "ratio"})
    EXPECT_TRUE(makePolicy(name, {})->usesConflicts()) << name;
  EXPECT_FALSE(makePolicy("paper", {})->usesConflicts());
  EXPECT_FALSE(makePolicy("ask-all", {})->usesConflicts());
}

TEST(Policy, AnUnknownNameIsRefusedWithThoseThereAre) {
  try {
    makePolicy("pepper", {});
    FAIL() << "'pepper' is no policy";
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("'pepper'"), std::string::npos) << what;
    EXPECT_NE(what.find("auto, optimal, ratio, paper, ask-all"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace goal_alignment::questions
