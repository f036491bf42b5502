// SPDX-License-Identifier: BSD-3-Clause
// What doc/tutorial.md shows of config/domains/ward.
#include <gtest/gtest.h>

#include <string>

#include "program.h"
#include "unit/source_root.h"

namespace goal_alignment::cli {
namespace {

using nlohmann::json;
using samples::hagl;

std::string ward(const std::string& file = "") {
  return (sourceRoot() / "config/domains/ward" / file).string();
}

TEST(Ward, ThePersonsPlanIsValidForThemAndNotForTheRobot) {
  EXPECT_EQ(hagl({"validate", ward("human_domain.pddl"), ward("human_problem.pddl"),
                  ward("human_plan.txt")})
                .status,
            0);
  const auto ended = hagl(
      {"validate", ward("robot_domain.pddl"), ward("robot_problem.pddl"), ward("human_plan.txt")});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE((ended.out + ended.err).find("step 4 (load soup kitchen)"), std::string::npos);
}

TEST(Ward, SoupOrDockIsTheOneConflict) {
  const json found = hagl({"conflicts", ward(), "--json"}).json();
  ASSERT_EQ(found["conflicts"].size(), 1U);
  EXPECT_EQ(found["conflicts"][0]["fluents"],
            json::array({"(robot-at dock)", "(thing-at soup bedside)"}));
}

TEST(Ward, OneQuestionLeadsToAPlanOfNineSteps) {
  const json found = hagl({"align", ward(), "--json"}).json();
  EXPECT_EQ(found["code"], 1);
  EXPECT_EQ(found["rounds"], 1);
  EXPECT_EQ(found["plan"].size(), 9U);
}

}  // namespace
}  // namespace goal_alignment::cli
