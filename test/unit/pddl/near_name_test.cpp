// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/near_name.h"

#include <gtest/gtest.h>

namespace goal_alignment::pddl {
namespace {

TEST(Suggestion, NamesTheNearest) {
  EXPECT_EQ(suggestion("handempy", {"holding", "handempty", "hand"}),
            "; did you mean 'handempty'?");
  EXPECT_EQ(suggestion("PICKUP", {"pick-up", "put-down"}), "; did you mean 'pick-up'?");
  EXPECT_EQ(suggestion("plaec", {"place"}), "; did you mean 'place'?") << "a swap is one slip";
  EXPECT_EQ(suggestion("on-tabel", {"on", "on-table"}), "; did you mean 'on-table'?");
}

TEST(Suggestion, IsSilentWhereNothingIsNear) {
  EXPECT_EQ(suggestion("handempty", {"on", "clear"}), "");
  EXPECT_EQ(suggestion("a", {"b", "c"}), "") << "every one-letter name is one slip away";
  EXPECT_EQ(suggestion("anything", {}), "");
  EXPECT_EQ(suggestion(std::string(5000, 'a'), {std::string(5000, 'a')}), "");
}

TEST(Suggestion, DoesNotDependOnTheOrder) {
  EXPECT_EQ(suggestion("cap", {"cup", "cab"}), suggestion("cap", {"cab", "cup"}));
}

}  // namespace
}  // namespace goal_alignment::pddl
