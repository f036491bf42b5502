// SPDX-License-Identifier: BSD-3-Clause
#include "scenario.h"

#include <ros/package.h>

#include "graph.h"

namespace goal_alignment::test {

PlanStep step(const std::string& name, const std::vector<std::string>& args) {
  PlanStep message;
  message.name = name;
  message.args = args;
  return message;
}

Fluent fluent(const std::string& name, const std::vector<std::string>& args) {
  Fluent message;
  message.name = name;
  message.args = args;
  return message;
}

std::string model(const std::string& file) {
  return ros::package::getPath("goal_alignment") + "/test/ros/models/" + file;
}

AlignGoal sweepHall() {
  AlignGoal goal;
  goal.source = AlignGoal::FILES;
  goal.robot_domain = model("robot_domain.pddl");
  goal.robot_problem = model("one_room.pddl");
  goal.human_domain = model("human_domain.pddl");
  goal.human_problem = model("one_room.pddl");
  goal.task.person = "Ann";
  goal.task.plan = {step("sweep", {"hall"})};
  goal.max_questions = -1;
  return goal;
}

AlignGoal sweepBothRooms() {
  AlignGoal goal = sweepHall();
  goal.robot_problem = goal.human_problem = model("two_rooms.pddl");
  goal.task.plan.push_back(step("sweep", {"kitchen"}));
  return goal;
}

AlignGoal sweepSilently() {
  AlignGoal goal = sweepHall();
  goal.robot_domain = goal.human_domain;
  return goal;
}

AlignGoal lightLamps() {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("lamps_robot_domain.pddl");
  goal.human_domain = model("lamps_human_domain.pddl");
  goal.robot_problem = goal.human_problem = model("lamps.pddl");
  goal.task.plan = {step("light", {"a1", "a2"}), step("light", {"a2", "a1"}),
                    step("light", {"b1", "b2"}), step("light", {"b2", "b1"}), step("check", {})};
  return goal;
}

Scenario::Scenario()
    : questions_(node_, "/goal_alignment/question"),
      states_(node_, "/goal_alignment/state"),
      plans_(node_, "/goal_alignment/plan"),
      align_(node_, "/goal_alignment/align") {}

void Scenario::SetUp() {
  ASSERT_TRUE(isLinked(align_, "/goal_alignment", "/goal_alignment/align"));
  ASSERT_TRUE(isOffered("/goal_alignment/answer"));
  ASSERT_TRUE(questionIsClosed()) << "the scenario before left a question open";
}

// A scenario that failed half-way must not fail the next one.
void Scenario::TearDown() {
  // Not all goals: that cancel might arrive after the next scenario's goal.
  if (HasFailure()) align_.cancelGoal();
  EXPECT_TRUE(questionIsClosed());
}

Question Scenario::sendAndAwaitQuestion(const AlignGoal& goal) {
  const auto before = questions_.all();
  std::uint32_t newest = 0;
  for (const Question& question : before)
    newest = std::max(newest, question.question_id);
  align_.sendGoal(goal);
  return awaitQuestionAfter(newest);
}

Question Scenario::awaitQuestionAfter(std::uint32_t id) {
  const auto question =
      questions_.waitFor([id](const Question& shown) { return shown.question_id > id; });
  EXPECT_TRUE(question) << "no question came";
  return question.value_or(Question{});
}

AlignResult Scenario::awaitResult() {
  EXPECT_TRUE(waitForEnd(align_)) << "the goal did not end";
  const auto result = align_.getResult();
  return result ? *result : AlignResult{};
}

Answer::Response Scenario::answer(int value, std::uint32_t id,
                                  const std::vector<std::string>& fluents) {
  Answer call;
  call.request.answer = static_cast<std::int8_t>(value);
  call.request.question_id = id;
  call.request.fluents = fluents;
  call.request.answered_by = "test";
  EXPECT_TRUE(callService("/goal_alignment/answer", call));
  return call.response;
}

bool Scenario::questionIsClosed() {
  return eventually([this] {
    const auto shown = questions_.last();
    return shown && shown->question_id == 0;
  });
}

}  // namespace goal_alignment::test
