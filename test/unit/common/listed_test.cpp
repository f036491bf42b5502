// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/listed.h"

#include <gtest/gtest.h>

#include <vector>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment {
namespace {

TEST(Listed, separatesByCommas) {
  EXPECT_EQ(listed(std::vector<Literal>{}), "");
  EXPECT_EQ(listed(std::vector<Literal>{Literal::parse("(on a b)")}), "(on a b)");
  EXPECT_EQ(listed(std::vector<Literal>{Literal::parse("(p)"), Literal::parse("(not (q a))")}),
            "(p), (not (q a))");
}

TEST(Listed, keepsEmptyTextsApart) {
  const auto same = [](const std::string& text) { return text; };
  EXPECT_EQ(listed(std::vector<std::string>{"", "b"}, same), ", b");
}

}  // namespace
}  // namespace goal_alignment
