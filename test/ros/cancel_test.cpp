// SPDX-License-Identifier: BSD-3-Clause
// How goals end that nobody wants any more: every end carries a filled result.
#include "aligner_calls.h"
#include "goals_by_hand.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
using actionlib_msgs::GoalStatus;

class Cancel : public GoalsByHand {};

TEST_F(Cancel, whileAQuestionIsOpen) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  cancelKnownGoal(align_);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::CANCELED);
  EXPECT_EQ(align_.getState(), State::PREEMPTED);
  EXPECT_EQ(result.session_id, question.session_id);
  EXPECT_EQ(result.candidates.size(), 2U);
  EXPECT_EQ(result.questions, 1U);
  EXPECT_TRUE(questionIsClosed());
  EXPECT_FALSE(answer(Answer::Request::NO, question.question_id).accepted);
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& shown) {
    return shown.session_id == question.session_id && shown.phase == AlignmentState::DONE &&
           shown.outcome == AlignResult::CANCELED;
  }));

  const Question next = sendAndAwaitQuestion(sweepHall());
  EXPECT_GT(next.question_id, question.question_id);
  EXPECT_TRUE(answer(Answer::Request::NO, next.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Cancel, arrivingWithTheGoal) {
  for (int i = 0; i < 20; ++i) {
    const std::string id = send(sweepHall());
    cancel(id);
    const AlignActionResult result = resultOf(id);
    const bool ended = result.status.status == GoalStatus::PREEMPTED ||
                       result.status.status == GoalStatus::RECALLED;
    EXPECT_TRUE(ended) << int{result.status.status};
    expectCanceled(result, result.status.status);
  }
}

TEST_F(Cancel, arrivingBeforeItsGoal) {
  // actionlib remembers the cancel; its status shows when it has arrived.
  Topic<actionlib_msgs::GoalStatusArray> statuses(node_, "/goal_alignment/align/status");
  const std::string id = newId();
  actionlib_msgs::GoalID message;
  message.id = id;
  message.stamp = ros::Time::now();
  cancels_.publish(message);
  ASSERT_TRUE(statuses.waitFor([&](const actionlib_msgs::GoalStatusArray& shown) {
    return std::any_of(shown.status_list.begin(), shown.status_list.end(),
                       [&](const GoalStatus& status) { return status.goal_id.id == id; });
  }));
  AlignActionGoal goal;
  goal.goal_id = message;
  goal.goal = sweepHall();
  goals_.publish(goal);
  expectCanceled(resultOf(id), GoalStatus::RECALLED);
}

// Clients' clocks may be wrong by anything.
TEST_F(Cancel, withAnyStampHarmsNothing) {
  Topic<actionlib_msgs::GoalStatusArray> statuses(node_, "/goal_alignment/align/status");
  const auto is_listed = [&](const std::string& id) {
    return statuses.waitFor([&](const actionlib_msgs::GoalStatusArray& shown) {
      return std::any_of(shown.status_list.begin(), shown.status_list.end(),
                         [&](const GoalStatus& status) { return status.goal_id.id == id; });
    });
  };
  for (const std::uint32_t seconds : {1U, 4000000000U, 4294967295U}) {
    SCOPED_TRACE(seconds);
    actionlib_msgs::GoalID message;
    message.id = newId();
    message.stamp = ros::Time(seconds, 0);
    cancels_.publish(message);
    ASSERT_TRUE(is_listed(message.id));
    // The status list is looked through several times a second.
    ros::WallDuration(0.5).sleep();
    EXPECT_EQ(int{resultOf(send(sweepSilently())).status.status}, GoalStatus::SUCCEEDED);

    message.id = newId();
    cancels_.publish(message);
    ASSERT_TRUE(is_listed(message.id));
    AlignActionGoal goal;
    goal.goal_id.id = message.id;
    goal.goal = sweepHall();
    goals_.publish(goal);
    expectCanceled(resultOf(message.id), GoalStatus::RECALLED);
  }
}

TEST_F(Cancel, byANewerGoal) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  const auto older = results_.all().size();
  const std::string newer = send(sweepSilently());
  EXPECT_EQ(int{resultOf(newer).status.status}, GoalStatus::SUCCEEDED);
  // Either result may come first.
  ASSERT_TRUE(eventually([&] { return results_.all().size() == older + 2; }));
  const auto all = results_.all();
  const AlignActionResult& displaced =
      all[all[older].status.goal_id.id == newer ? older + 1 : older];
  expectCanceled(displaced, GoalStatus::PREEMPTED);
  EXPECT_EQ(displaced.result.message, "displaced by a newer goal");
  EXPECT_EQ(displaced.result.session_id, question.session_id);
}

TEST_F(Cancel, afterTheEndChangesNothing) {
  const std::string id = send(sweepSilently());
  EXPECT_EQ(int{resultOf(id).status.status}, GoalStatus::SUCCEEDED);
  cancel(id);
  cancel(id);
  cancel(newId());  // of a goal that nobody sent
  const std::string next = send(sweepSilently());
  EXPECT_EQ(int{resultOf(next).status.status}, GoalStatus::SUCCEEDED);
  EXPECT_EQ(resultsOf(id), 1U);
}

TEST_F(Cancel, ofAllGoalsAtOnce) {
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(eventually([this] { return align_.getState() == State::ACTIVE; }));
  align_.cancelAllGoals();
  EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
}

TEST_F(Cancel, leavesTheLatchedTopicsReadable) {
  sendAndAwaitQuestion(sweepHall());
  Topic<Question> late_question(node_, "/goal_alignment/question");
  EXPECT_TRUE(late_question.waitFor([](const Question& q) { return q.question_id != 0; }));
  Topic<AlignmentState> late_state(node_, "/goal_alignment/state");
  EXPECT_TRUE(late_state.waitFor(
      [](const AlignmentState& s) { return s.phase == AlignmentState::AWAITING_ANSWER; }));
  EXPECT_EQ(int{currentState().phase}, AlignmentState::AWAITING_ANSWER);
  cancelKnownGoal(align_);
  EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
  EXPECT_TRUE(questionIsClosed());
}

}  // namespace
}  // namespace goal_alignment::test
