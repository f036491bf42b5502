// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/reply.h"

#include <gtest/gtest.h>

namespace goal_alignment::phrasing {
namespace {

using Indices = std::vector<std::size_t>;
using Kind = Reply::Kind;

TEST(Reply, UnderstandsWhatPeopleType) {
  EXPECT_EQ(parseReply("y", 1)->kind, Kind::Yes);
  EXPECT_EQ(parseReply("  YES \r", 1)->kind, Kind::Yes);
  EXPECT_EQ(parseReply("n", 1)->kind, Kind::No);
  EXPECT_EQ(parseReply("No", 1)->kind, Kind::No);
  EXPECT_EQ(parseReply("?", 1)->kind, Kind::Unsure);
  EXPECT_EQ(parseReply("Don't know", 1)->kind, Kind::Unsure);
  EXPECT_EQ(parseReply("decline", 1)->kind, Kind::Decline);
  for (const char* rubbish : {"", " ", "yesno", "ye", "1", "y y", "all", "none", "\x01"}) {
    EXPECT_FALSE(parseReply(rubbish, 1)) << rubbish;
  }
}

TEST(Reply, TakesNumbersForAGroup) {
  EXPECT_EQ(parseReply("1 3", 3)->chosen, (Indices{0, 2}));
  EXPECT_EQ(parseReply("2,3", 3)->chosen, (Indices{1, 2}));
  EXPECT_EQ(parseReply("2 2", 3)->chosen, Indices{1});
  EXPECT_EQ(parseReply("2", 3)->kind, Kind::Yes);
  for (const char* all : {"y", "all"}) {
    EXPECT_EQ(parseReply(all, 3)->kind, Kind::Yes);
    EXPECT_TRUE(parseReply(all, 3)->chosen.empty());
  }
  EXPECT_EQ(parseReply("none", 3)->kind, Kind::No);
  for (const char* rubbish : {"0", "4", "1 x", "1 4", "-1", ","}) {
    EXPECT_FALSE(parseReply(rubbish, 3)) << rubbish;
  }
}

TEST(Reply, KeysSayWhatIsUnderstood) {
  EXPECT_EQ(replyKeys(1), "y = yes, n = no, ? = don't know, d = no more questions");
  EXPECT_NE(replyKeys(2).find("numbers of those that matter"), std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::phrasing
