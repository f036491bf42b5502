// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/spoken_choice.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/pddl/source_position.h"
#include "unit/source_root.h"

namespace goal_alignment::phrasing {
namespace {

class SpokenAlternatives : public testing::Test {
 protected:
  static Vocabulary english() {
    const auto path = sourceRoot() / "config/vocabulary/en.yaml";
    return Vocabulary::fromYaml(pddl::readFile(path.string()).text, "en.yaml");
  }

  Vocabulary vocabulary_ = english();
  std::vector<std::string> two_ = {"the cat stays in", "the door is shut"};
  SpokenChoice several_{vocabulary_, "It can't be.", 0, two_, 1};
};

TEST_F(SpokenAlternatives, AreListedUnlessTheMessageDoesSo) {
  EXPECT_EQ(several_.asked(),
            "It can't be. I can do everything except one of these. one: the cat stays in. two: the "
            "door is shut. Which one shall I leave out?");
  EXPECT_EQ(SpokenChoice(vocabulary_, "It can't be.", 3, two_, 1).asked(),
            "It can't be. Which one shall I leave out?");
  EXPECT_EQ(SpokenChoice(vocabulary_, "It can't be.", 0, {"the cat stays in"}, 1).asked(),
            "It can't be. I can do everything except: the cat stays in. Shall I do that?");
}

TEST_F(SpokenAlternatives, OfWhichTheMessageListsTheFirstAreListedFromTheNextOn) {
  EXPECT_EQ(
      SpokenChoice(vocabulary_, "All but a. Or b. Two more.", 2, {"a", "b", "c", "d"}, 1).asked(),
      "All but a. Or b. Two more. three: c. four: d. Which one shall I leave out?");
}

TEST_F(SpokenAlternatives, EndWithAChoice) {
  const auto turn = several_.hear("the door");
  EXPECT_TRUE(turn.ended);
  EXPECT_EQ(turn.chosen, 1U);
  EXPECT_EQ(turn.say, "All right.");
}

TEST_F(SpokenAlternatives, EndWithNone) {
  const auto turn = several_.hear("none of them");
  EXPECT_TRUE(turn.ended);
  EXPECT_FALSE(turn.chosen);
  EXPECT_EQ(turn.say, "All right, I'll leave it at that.");
}

TEST_F(SpokenAlternatives, AreSaidAgainOnDemandAsOftenAsOneLikes) {
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(several_.hear("pardon?").say, several_.asked());
}

TEST_F(SpokenAlternatives, AreLeftWhenNothingIsUnderstood) {
  const auto sorry = several_.hear("I don't care");
  EXPECT_FALSE(sorry.ended);
  EXPECT_EQ(sorry.say.find("Sorry? Please say the number"), 0U) << sorry.say;
  const auto end = several_.hear("bananas");
  EXPECT_TRUE(end.ended);
  EXPECT_FALSE(end.chosen);
}

TEST_F(SpokenAlternatives, AreLeftAfterSilence) {
  EXPECT_EQ(several_.silence().say.find(several_.asked()), 0U);
  const auto end = several_.silence();
  EXPECT_TRUE(end.ended);
  EXPECT_FALSE(end.chosen);
  EXPECT_EQ(end.say, "");
}

TEST_F(SpokenAlternatives, APlanIsSaidByItsEnds) {
  const EndSayings& sayings = *vocabulary_.atEnd();
  EXPECT_EQ(spokenPlan(sayings, {"go", "wipe", "pour"}),
            "It has 3 steps. The first: go. The last: pour.");
  EXPECT_EQ(spokenPlan(sayings, {"go"}), "It is one step: go.");
  EXPECT_EQ(spokenPlan(sayings, {}), "");
}

}  // namespace
}  // namespace goal_alignment::phrasing
