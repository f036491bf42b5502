// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/reply.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace goal_alignment::phrasing {
namespace {

using Kind = Reply::Kind;

void expectKind(const std::vector<std::string>& lines, std::size_t fluents, Kind kind) {
  for (const std::string& line : lines) {
    const auto reply = parseReply(line, fluents);
    ASSERT_TRUE(reply.has_value()) << line;
    EXPECT_EQ(reply->kind, kind) << line;
    EXPECT_TRUE(reply->chosen.empty()) << line;
  }
}

TEST(Reply, WordsInAnyCase) {
  expectKind({"y", " YES\t", "Yes\r"}, 1, Kind::Yes);
  expectKind({"n", "No "}, 1, Kind::No);
  expectKind({"?", "u", "unsure", "Don't know", "i don't know"}, 1, Kind::Unsure);
  expectKind({"d", "DECLINE"}, 1, Kind::Decline);
  expectKind({"all", "yes"}, 2, Kind::Yes);
  expectKind({"none", "no"}, 2, Kind::No);
}

TEST(Reply, NumbersChooseAmongSeveral) {
  for (const std::string line : {"1 3", "3,1", " 1, 3 ", "1 3 3 1"}) {
    const auto reply = parseReply(line, 3);
    ASSERT_TRUE(reply.has_value()) << line;
    EXPECT_EQ(reply->kind, Kind::Yes);
    EXPECT_EQ(std::set<std::size_t>(reply->chosen.begin(), reply->chosen.end()),
              (std::set<std::size_t>{0, 2}))
        << line;
    EXPECT_EQ(reply->chosen.size(), 2U);
  }
}

TEST(Reply, AnythingElseIsNone) {
  for (const std::string line :
       {"", " ", "yesno", "y y", "\x01", "maybe", "1", "0", "yes please", "all", "none", "-1"})
    EXPECT_FALSE(parseReply(line, 1).has_value()) << line;
  for (const std::string line :
       {"0", "4", "1 4", "1 x", "1.5", "-1", "1;2", ",", "99999999999999999999999"})
    EXPECT_FALSE(parseReply(line, 3).has_value()) << line;
}

TEST(Reply, ABoundThatIsAGuessIsNotSaid) {
  EXPECT_EQ(questionLine({2, "Ada", 4, false, "Why?"}, {}),
            "Question 2 for Ada (at most 3 more after it): Why?");
  EXPECT_EQ(questionLine({1, "", 2, false, "Why?"}, {}),
            "Question 1 (at most one more after it): Why?");
  EXPECT_EQ(questionLine({1, "", 1, false, "Why?"}, {}), "Question 1 (the last one): Why?");
  EXPECT_EQ(questionLine({1, "", 9, true, "Why?"}, {}),
            "Question 1 (a few more questions may follow): Why?");
}

TEST(Reply, TheKeysNameWhatIsTaken) {
  EXPECT_EQ(replyKeys(1).find("numbers"), std::string::npos);
  EXPECT_NE(replyKeys(2).find("numbers"), std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::phrasing
