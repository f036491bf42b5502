// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/graph_view.h"

#include <gtest/gtest.h>

namespace goal_alignment::execution {
namespace {

TEST(GraphView, saysWhatMayBeMeantByAnAction) {
  GraphView view;
  view.actions = {
      {"/left/gripper", "robot/Grasp"}, {"/navigate", "robot/Go"}, {"/walk", "legs/Go"}};
  EXPECT_EQ(view.nearAction("/naviagte", "robot/Go"), "; did you mean '/navigate'?");
  EXPECT_EQ(view.nearAction("/wlak", "robot/Go"), "; did you mean '/walk'?");
  EXPECT_EQ(view.nearAction("/hand", "robot/Grasp"), "; of that type there is /left/gripper");
  EXPECT_EQ(view.nearAction("/walk", "robot/Go"), "; what is there by that name is a legs/Go");
  EXPECT_EQ(view.nearAction("/navigate", "robot/Go"), "; it is registered, but can't be reached");
  EXPECT_EQ(view.nearAction("/sing", "robot/Sing"), "");
}

TEST(GraphView, saysWhatMayBeMeantByAService) {
  GraphView view;
  view.services = {"/door/open", "/rosout/get_loggers"};
  EXPECT_EQ(view.nearService("/doro/open"), "; did you mean '/door/open'?");
  EXPECT_EQ(view.nearService("/kettle"), "");
}

TEST(GraphView, knowsWhichServerOfARuleIsLacking) {
  GraphView view;
  view.actions = {{"/go", "robot/Go"}};
  view.services = {"/open"};
  StepRule rule;
  EXPECT_EQ(view.lackOf(rule, "/go"), "") << "of others no server is wanted";
  rule.action.emplace().type = "robot/Go";
  EXPECT_EQ(view.lackOf(rule, "/go"), "");
  EXPECT_EQ(view.lackOf(rule, "/og"),
            "nobody offers the action /og of type robot/Go; did you mean '/go'?");
  rule.action.reset();
  rule.service.emplace();
  EXPECT_EQ(view.lackOf(rule, "/open"), "");
  EXPECT_EQ(view.lackOf(rule, "/opne"), "nobody offers the service /opne; did you mean '/open'?");
}

}  // namespace
}  // namespace goal_alignment::execution
