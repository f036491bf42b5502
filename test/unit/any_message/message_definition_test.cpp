// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/message_definition.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/AlignAction.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/AskHuman.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "goal_alignment/Explain.h"
#include "samples.h"

namespace goal_alignment::any_message::test {
namespace {

template <typename Message>
void expectSameAsCompiled(MessageTypes& types) {
  const std::string type = ros::message_traits::datatype<Message>();
  EXPECT_EQ(types.message(type).md5, ros::message_traits::md5sum<Message>()) << type;
}

template <typename Service>
void expectSameServiceAsCompiled(MessageTypes& types) {
  const std::string type = ros::service_traits::datatype<Service>();
  EXPECT_EQ(types.service(type).md5, ros::service_traits::md5sum<Service>()) << type;
}

TEST(MessageTypes, haveTheChecksumsOfTheCompilersDefinitions) {
  MessageTypes types(installedDefinition);
  expectSameAsCompiled<std_msgs::Header>(types);
  expectSameAsCompiled<geometry_msgs::PoseStamped>(types);
  expectSameAsCompiled<actionlib_msgs::GoalStatusArray>(types);
  expectSameAsCompiled<Plan>(types);
  expectSameAsCompiled<AlignmentState>(types);
  expectSameAsCompiled<ActionFeedback>(types);
  expectSameServiceAsCompiled<std_srvs::SetBool>(types);
  expectSameServiceAsCompiled<std_srvs::Trigger>(types);
  expectSameServiceAsCompiled<AskHuman>(types);
  expectSameServiceAsCompiled<Explain>(types);
}

TEST(MessageTypes, haveTheChecksumsOfTheCompilersActions) {
  MessageTypes types(installedDefinition);
  EXPECT_EQ(types.action("move_base_msgs/MoveBase").goal_message_md5,
            ros::message_traits::md5sum<move_base_msgs::MoveBaseActionGoal>());
  EXPECT_EQ(types.action("goal_alignment/Align").goal_message_md5,
            ros::message_traits::md5sum<AlignActionGoal>());
  const ActionDefinition execute = types.action("goal_alignment/ExecutePlan");
  EXPECT_EQ(execute.goal_message_md5, ros::message_traits::md5sum<ExecutePlanActionGoal>());
  EXPECT_EQ(execute.result.md5, ros::message_traits::md5sum<ExecutePlanResult>());
}

TEST(MessageTypes, areReadFromAnActionFileOrFromTheMessagesMadeOfIt) {
  MessageTypes file =
      typesOf({{"robot/action/Go", "# goal\nstring to\n---\nbool done # so\n---\n"}});
  MessageTypes made =
      typesOf({{"robot/msg/GoGoal", "string to"}, {"robot/msg/GoResult", "bool done"}});
  EXPECT_EQ(file.action("robot/Go").goal_message_md5, made.action("robot/Go").goal_message_md5);
  EXPECT_EQ(made.action("robot/Go").result.fieldNames(), "done");
}

TEST(MessageTypes, takeATextConstantWithItsCommentAndOthersWithout) {
  MessageTypes types =
      typesOf({{"a/msg/A", "string S= x # y \nint32 N = 5 # five\nB[] bs\nfloat64[3] f"},
               {"a/msg/B", "bool b"}});
  EXPECT_EQ(types.message("a/A").normal_form,
            "string S=x # y\nint32 N=5\n" + types.message("a/B").md5 + " bs\nfloat64[3] f");
  EXPECT_EQ(types.message("a/A").find("bs")->type, "a/B");
  EXPECT_EQ(types.message("a/A").find("f")->length, 3);
}

TEST(MessageTypes, tellWhichTypeIsMissing) {
  MessageTypes types = typesOf({{"a/msg/A", "b/B b"}, {"a/msg/Loop", "Loop loop"}});
  EXPECT_EQ(faultOfCall([&] { types.message("a/A"); }),
            "the type b/B is not known: no msg/B.msg of package b is installed");
  EXPECT_EQ(faultOfCall([&] { types.message("a/Loop"); }), "the type a/Loop contains itself");
  EXPECT_EQ(faultOfCall([&] { types.service("Trigger"); }),
            "'Trigger' is no type's name: expected package/Name");
  EXPECT_NE(faultOfCall([&] { types.message("../etc"); }), "");
}

TEST(MessageTypes, tellOfADefinitionThatIsNone) {
  MessageTypes types = typesOf({{"a/msg/A", "int32 x y"}, {"a/srv/S", "int32 x"}});
  EXPECT_EQ(faultOfCall([&] { types.message("a/A"); }),
            "a/A: 'int32 x y' is no field of a message");
  EXPECT_EQ(faultOfCall([&] { types.service("a/S"); }), "a/S is no service: no line of ---");
}

}  // namespace
}  // namespace goal_alignment::any_message::test
