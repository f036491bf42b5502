// SPDX-License-Identifier: BSD-3-Clause
// Questions answered through ~answer: what is taken, what is refused and why.
#include <cstdio>
#include <string>

#include "aligner_calls.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
using testing::Test;

class AnswerService : public Scenario {};

// What a person types, output and all.
std::string run(const std::string& command) {
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  char buffer[256];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr)
    output += buffer;
  pclose(pipe);
  return output;
}

TEST_F(AnswerService, yesTypedWithRosserviceMeansThatNoPlanExists) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_EQ(question.fluents.size(), 1U);
  EXPECT_EQ(question.person, "Ann");
  const std::string said =
      run("timeout 20 rosservice call /goal_alignment/answer '{answer: yes}' 2>&1");
  EXPECT_NE(said.find("accepted: True"), std::string::npos) << said;
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE) << result.message;
  EXPECT_EQ(align_.getState(), State::ABORTED);
  ASSERT_EQ(result.conflict.size(), 1U);
  EXPECT_EQ(result.conflict[0].name, "quiet");
  EXPECT_EQ(result.questions, 1U);
  EXPECT_EQ(result.failing_step, -1);
}

TEST_F(AnswerService, noLeadsToAPlan) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(align_.getState(), State::SUCCEEDED);
  EXPECT_EQ(result.session_id, question.session_id);
  ASSERT_EQ(result.plan.steps.size(), 1U);
  EXPECT_EQ(result.plan.steps[0].name, "sweep");
  ASSERT_EQ(result.plan.steps[0].parameters.size(), 1U);
  EXPECT_EQ(result.plan.steps[0].parameters[0].key, "r");
  EXPECT_EQ(result.plan.steps[0].parameters[0].value, "hall");
  ASSERT_EQ(result.plan.not_wanted.size(), 1U);
  EXPECT_GT(result.waiting_time, 0);

  const auto plan =
      plans_.waitFor([&](const Plan& shown) { return shown.plan_id == result.plan.plan_id; });
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->session_id, result.session_id);
  EXPECT_FALSE(plan->header.stamp.isZero());
  EXPECT_TRUE(questionIsClosed());
  const auto state = states_.waitFor([&](const AlignmentState& shown) {
    return shown.session_id == result.session_id && shown.phase == AlignmentState::DONE;
  });
  ASSERT_TRUE(state);
  EXPECT_EQ(state->outcome, AlignResult::SUCCESS);
}

TEST_F(AnswerService, unsureIsKeptAndBlocksWhereItCannotBe) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(answer(Answer::Request::UNSURE, question.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::UNSURE_BLOCKS);
}

TEST_F(AnswerService, declineEndsTheDialogue) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(answer(Answer::Request::DECLINE, question.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::DECLINED);
}

TEST_F(AnswerService, staleForeignAndSenselessAnswersAreRefusedWithTheirReason) {
  const Question first = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_EQ(answer(Answer::Request::NO, first.question_id + 500000).message,
            "question " + std::to_string(first.question_id + 500000) + " was not asked here");
  EXPECT_FALSE(answer(7, first.question_id).accepted);
  EXPECT_FALSE(answer(-1, first.question_id).accepted);
  EXPECT_FALSE(answer(Answer::Request::NO, 0, {"(((("}).accepted);
  EXPECT_FALSE(answer(Answer::Request::NO, 0, {"(clean hall)"}).accepted) << "specified";
  EXPECT_FALSE(answer(Answer::Request::NO, 0, {"(quiet cellar)"}).accepted) << "outside S^H";
  EXPECT_FALSE(answer(Answer::Request::NO, first.question_id, {"(room hall)"}).accepted);
  EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted);

  const Question second = awaitQuestionAfter(first.question_id);
  EXPECT_EQ(answer(Answer::Request::NO, first.question_id).message,
            "question " + std::to_string(first.question_id) + " is over");
  const std::string answered = "(" + first.fluents[0].name + " " + first.fluents[0].args[0] + ")";
  EXPECT_NE(answer(Answer::Request::YES, 0, {answered}).message.find("answered already"),
            std::string::npos);
  EXPECT_TRUE(answer(Answer::Request::NO, second.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_EQ(answer(Answer::Request::NO).message, "no alignment is under way");
}

TEST_F(AnswerService, idZeroIsRefusedForASecondAfterAQuestionReplacedAnother) {
  Answer::Response early;
  // On a machine so busy that the second is over before we come to answer, once more.
  do {
    const Question first = sendAndAwaitQuestion(sweepBothRooms());
    EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted);
    awaitQuestionAfter(first.question_id);
    early = answer(Answer::Request::NO);
    if (early.accepted) awaitResult();
  } while (early.accepted);
  EXPECT_NE(early.message.find("just replaced"), std::string::npos) << early.message;
  EXPECT_TRUE(eventually([this] { return answer(Answer::Request::NO).accepted; }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(AnswerService, ofTwoWhoRaceOneIsToldSo) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  const auto one = answer(Answer::Request::NO, question.question_id);
  const auto other = answer(Answer::Request::YES, question.question_id);
  EXPECT_TRUE(one.accepted);
  EXPECT_FALSE(other.accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(AnswerService, aVolunteeredAnswerIsNotAskedFor) {
  const Question first = sendAndAwaitQuestion(sweepBothRooms());
  const std::string other = first.fluents[0].args[0] == "hall" ? "kitchen" : "hall";
  EXPECT_TRUE(answer(Answer::Request::NO, 0, {"(QUIET " + other + ")"}).accepted);
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.phase == AlignmentState::AWAITING_ANSWER &&
           std::any_of(state.candidates.begin(), state.candidates.end(),
                       [&](const Candidate& candidate) {
                         return candidate.fluent.args.at(0) == other &&
                                candidate.state == Candidate::NOT_WANTED;
                       });
  })) << "nobody sees it";
  EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted)
      << "the open question stayed open";
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS);
  EXPECT_EQ(result.questions, 1U);
}

TEST_F(AnswerService, silenceUntilAskTimeoutEndsUndecided) {
  ros::param::set("/goal_alignment/ask_timeout", 0.3);
  const double before = ros::WallTime::now().toSec();
  const Question question = sendAndAwaitQuestion(sweepHall());
  const AlignResult result = awaitResult();
  const double after = ros::WallTime::now().toSec();
  ros::param::del("/goal_alignment/ask_timeout");
  EXPECT_EQ(result.outcome, AlignResult::NO_ANSWER) << result.message;
  EXPECT_EQ(align_.getState(), State::ABORTED);
  EXPECT_GE(result.waiting_time, 0.3);
  EXPECT_GE(question.expires.toSec(), before + 0.3) << "whatever clock ROS has";
  EXPECT_LE(question.expires.toSec(), after) << "it has expired on the clock that it names";
  EXPECT_FALSE(answer(Answer::Request::NO, question.question_id).accepted);
}

TEST_F(AnswerService, whoAnswersAQuestionThatWasPutAgainMeantThatOne) {
  const Parameter timeout("ask_timeout", 0.3);
  const Parameter retries("ask_retries", 1000);
  const Question first = sendAndAwaitQuestion(sweepHall());
  const Question again = awaitQuestionAfter(first.question_id);
  EXPECT_EQ(again.text, first.text);
  const auto late = answer(Answer::Request::NO, first.question_id);
  EXPECT_TRUE(late.accepted) << late.message;
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.questions, 1U);
  EXPECT_EQ(answer(Answer::Request::NO, first.question_id).message, "no alignment is under way");
}

TEST_F(AnswerService, thatAllAnswersWereRefusedIsSaidInTheEnd) {
  const Parameter timeout("ask_timeout", 1.0);
  const Parameter retries("ask_retries", 2);
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_FALSE(answer(7, question.question_id).accepted);
  EXPECT_FALSE(answer(Answer::Request::NO, 0, {"(clean hall)"}).accepted);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::NO_ANSWER) << result.message;
  EXPECT_NE(result.message.find("answers came, all refused: 7 is not an answer"), std::string::npos)
      << result.message;
  EXPECT_NE(result.message.find("(clean hall) is part of the specified goal"), std::string::npos)
      << result.message;
}

TEST_F(AnswerService, aRevisedAnswerLeadsTheSessionOn) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(answer(Answer::Request::YES, question.question_id).accepted);
  const AlignResult before = awaitResult();
  EXPECT_EQ(before.outcome, AlignResult::EXPECTATION_UNACHIEVABLE);

  const auto revised = reviseAnswer(Answer::Request::NO, {"(quiet hall)"});
  EXPECT_TRUE(revised.accepted) << revised.message;
  const auto plan =
      plans_.waitFor([&](const Plan& shown) { return shown.session_id == before.session_id; });
  ASSERT_TRUE(plan) << "the session did not go on";
  EXPECT_EQ(plan->steps.size(), 1U);

  AlignGoal goal;
  goal.continue_session = before.session_id;
  goal.revised_wanted = {fluent("quiet", {"hall"})};
  goal.max_questions = -1;
  align_.sendGoal(goal);
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);

  EXPECT_FALSE(reviseAnswer(Answer::Request::NO, {"(clean hall)"}).accepted);
}

}  // namespace
}  // namespace goal_alignment::test
