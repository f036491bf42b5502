// SPDX-License-Identifier: BSD-3-Clause
// Dialogue nodes that are quick, slow, hanging, dying, and late.
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <vector>

#include "goal_alignment/AskHuman.h"
#include "scenario.h"

namespace goal_alignment::test {
namespace {

class ScriptedDialogue : public Scenario {};
class SlowDialogue : public Scenario {};

bool isReady(const std::future<AskHuman>& asker) {
  return asker.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

TEST_F(ScriptedDialogue, answersFromItsList) {
  align_.sendGoal(sweepBothRooms());
  const AlignResult result = awaitResult();
  // Its list holds (quiet kitchen) alone, which can't be had.
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE) << result.message;
  ASSERT_EQ(result.conflict.size(), 1U);
  EXPECT_EQ(result.conflict[0].args[0], "kitchen");
  for (const Candidate& candidate : result.candidates) {
    if (candidate.state != Candidate::WANTED) continue;
    EXPECT_EQ(candidate.answered_by, "scripted_dialogue");
    EXPECT_FALSE(candidate.answered_at.isZero());
  }
}

TEST_F(ScriptedDialogue, saysNoToWhatIsNotInItsList) {
  align_.sendGoal(sweepHall());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

// More askers than the dialogue has threads: none of them may keep it from hearing that the
// question is over.
TEST_F(SlowDialogue, leavesAQuestionThatSomebodyElseAnswered) {
  ASSERT_TRUE(isOffered("/ask_human"));
  const Question question = sendAndAwaitQuestion(sweepHall());
  std::vector<std::future<AskHuman>> askers;
  for (int i = 0; i < 4; ++i) {
    askers.push_back(std::async(std::launch::async, [&question] {
      AskHuman call;
      call.request.question = question;
      EXPECT_TRUE(ros::service::call("/ask_human", call));
      return call;
    }));
  }
  EXPECT_FALSE(eventually([&] { return isReady(askers[0]); }, 0.5)) << "it takes an hour";
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  for (auto& asker : askers) {
    ASSERT_TRUE(eventually([&] { return isReady(asker); }));
    EXPECT_EQ(int{asker.get().response.answer}, AskHuman::Response::NONE);
  }
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

// A dialogue node inside the test, whose calls last until they are told to end.
class HangingDialogue : public Scenario {
 protected:
  void SetUp() override {
    Scenario::SetUp();
    advertise();
  }

  void TearDown() override {
    Scenario::TearDown();
    release(AskHuman::Response::NONE);
    server_.shutdown();
    EXPECT_TRUE(eventually([this] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return outstanding_ == 0;
    }));
  }

  void advertise() { server_ = node_.advertiseService("/ask_human", &HangingDialogue::ask, this); }

  bool ask(AskHuman::Request& request, AskHuman::Response& response) {
    std::unique_lock<std::mutex> lock(mutex_);
    most_ = std::max(most_, ++outstanding_);
    asked_.push_back(request.question.question_id);
    const bool first = asked_.size() == 1;
    changed_.notify_all();
    changed_.wait(lock, [this] { return released_; });
    --outstanding_;
    response.answer = first ? first_answer_ : later_answer_;
    response.question_id = request.question.question_id;
    return response.answer != AskHuman::Response::NONE;
  }

  bool wasAsked(std::uint32_t id) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(kPatience), [&] {
      return std::find(asked_.begin(), asked_.end(), id) != asked_.end();
    });
  }

  // Ends the calls: the first one with the answer given, later ones with NO. NONE: it fails.
  void release(std::int8_t first_answer) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      released_ = true;
      first_answer_ = first_answer;
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::uint32_t> asked_;
  int outstanding_ = 0;
  int most_ = 0;
  bool released_ = false;
  std::int8_t first_answer_ = AskHuman::Response::NONE;
  std::int8_t later_answer_ = AskHuman::Response::NO;
  ros::ServiceServer server_;
};

TEST_F(HangingDialogue, isAskedOnceAndItsLateAnswerIsRefused) {
  const Question first = sendAndAwaitQuestion(sweepBothRooms());
  ASSERT_TRUE(wasAsked(first.question_id));
  EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted);
  const Question second = awaitQuestionAfter(first.question_id);
  const ros::WallTime asked = ros::WallTime::now();
  {
    // The hanging call is abandoned: the second question is on ~question alone.
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_EQ(most_, 1);
    EXPECT_EQ(asked_.size(), 1U);
  }
  // Once the grace for answers without an id is over, the id alone protects the second question.
  EXPECT_TRUE(eventually([&] { return (ros::WallTime::now() - asked).toSec() > 1.1; }));
  release(AskHuman::Response::YES);
  ASSERT_TRUE(wasAsked(second.question_id)) << "it is asked again once it is free";
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS) << "NO to both, the YES came too late";
}

TEST_F(HangingDialogue, doesNotHoldUpACancel) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(wasAsked(question.question_id));
  align_.cancelGoal();
  EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
}

TEST_F(HangingDialogue, thatFailsIsAskedAgain) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(wasAsked(question.question_id));
  release(AskHuman::Response::NONE);  // the service call fails
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_EQ(asked_, (std::vector<std::uint32_t>{question.question_id, question.question_id}));
}

TEST_F(HangingDialogue, thatComesLaterIsAskedThen) {
  server_.shutdown();
  const Question question = sendAndAwaitQuestion(sweepHall());
  release(AskHuman::Response::NO);
  advertise();
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_EQ(asked_.front(), question.question_id);
}

}  // namespace
}  // namespace goal_alignment::test
