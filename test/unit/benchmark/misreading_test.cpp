// SPDX-License-Identifier: BSD-3-Clause
#include "generators/misreading.h"

#include <gtest/gtest.h>

#include "generators/families.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::benchmarks {
namespace {

Models aHousehold() {
  RandomSource random(1);
  return household(8, random);
}

std::size_t facts(const Models& models) {
  return models.problem.init.size();
}

TEST(ForgetPredicate, leavesNoTraceOfIt) {
  Models models = aHousehold();
  forgetPredicate(models, "bare");
  EXPECT_EQ(models.domain.text().find("(bare "), std::string::npos);
  EXPECT_EQ(models.problemText().find("(bare "), std::string::npos);
  EXPECT_EQ(pddl::faults({"domain", models.domain.text()}, {"problem", models.problemText()}),
            std::vector<std::string>());
}

TEST(ForgetCondition, takesOutOne) {
  Models models = aHousehold();
  const std::size_t before = models.domain.action("set-down").condition.size();
  forgetCondition(models.domain, "set-down", "(light ?d)");
  EXPECT_EQ(models.domain.action("set-down").condition.size(), before - 1);
  EXPECT_THROW(forgetCondition(models.domain, "set-down", "(light ?d)"), std::out_of_range);
  EXPECT_THROW(forgetCondition(models.domain, "dance", "(light ?d)"), std::out_of_range);
}

TEST(Misread, displacesOneThing) {
  RandomSource random(4);
  const Models robot = aHousehold();
  const Models human = misread(robot, misreadingOf("i"), random);
  ASSERT_EQ(facts(human), facts(robot));
  std::size_t different = 0;
  for (std::size_t i = 0; i < facts(robot); ++i)
    different += human.problem.init[i] == robot.problem.init[i] ? 0 : 1;
  EXPECT_EQ(different, 1U);
  EXPECT_EQ(human.domain.text(), robot.domain.text());
}

TEST(Misread, believesOneStaticFactMore) {
  RandomSource random(1);
  const Models robot = aHousehold();
  const Models human = misread(robot, misreadingOf("s"), random);
  ASSERT_EQ(facts(human), facts(robot) + 1);
  const std::string more = human.problem.init.back();
  for (const char* changing : {"(inside ", "(open ", "(robot-in ", "(holds "})
    EXPECT_EQ(more.find(changing), std::string::npos) << more;
}

TEST(Misread, bringsAWordAndAThingOfTheirOwn) {
  RandomSource random(1);
  const Models human = misread(aHousehold(), misreadingOf("v"), random);
  EXPECT_NE(human.domain.predicate("noticed"), nullptr);
  EXPECT_EQ(human.problem.objects.back().name, "heirloom");
  EXPECT_EQ(human.problem.init.back().find("(inside heirloom "), 0U);
}

}  // namespace
}  // namespace goal_alignment::benchmarks
