// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/outside_text.h"

#include <gtest/gtest.h>

namespace goal_alignment::ros_common {
namespace {

TEST(OutsideText, namesStayAsTheyAre) {
  EXPECT_EQ(outsideName("Ann"), "Ann");
  EXPECT_EQ(outsideName(""), "");
  EXPECT_EQ(outsideName("Zoë Müller-Ångström"), "Zoë Müller-Ångström");
  EXPECT_EQ(outsideName("李雷"), "李雷");
}

TEST(OutsideText, controlCharactersBecomeBlanks) {
  EXPECT_EQ(outsideName("Ann\n[WARN] Bob\x1b[2J\x7f"), "Ann [WARN] Bob [2J ");
  EXPECT_EQ(outsideName("a\xc2\x9b"
                        "2Jb"),
            "a  2Jb")
      << "C1, as terminals know it";
  EXPECT_EQ(outsideName(std::string("a\0b", 3)), "a b");
}

TEST(OutsideText, longTextsAreCutShort) {
  const std::string long_name = outsideName(std::string(1000000, 'x'));
  EXPECT_LT(long_name.size(), 300U);
  EXPECT_EQ(long_name.substr(long_name.size() - 3), "…");
  EXPECT_EQ(onOneLine("abcdef", 3), "abc…");
  EXPECT_EQ(onOneLine("\xc3", 10), "…") << "where it stops being UTF-8";
}

}  // namespace
}  // namespace goal_alignment::ros_common
