// SPDX-License-Identifier: BSD-3-Clause
// Dialogue nodes that are quick, slow, hanging, dying, and late.
#include <std_msgs/String.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <vector>

#include "aligner_calls.h"
#include "generated_tasks.h"
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

TEST_F(ScriptedDialogue, answersAGroupAtOnce) {
  const Parameter groups("max_group_size", 2);
  align_.sendGoal(sweepBothRooms());
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE) << result.message;
  EXPECT_EQ(result.questions, 1U);
  for (const Candidate& candidate : result.candidates) {
    if (candidate.fluent.name != "quiet") continue;
    EXPECT_EQ(int{candidate.state},
              candidate.fluent.args[0] == "kitchen" ? Candidate::WANTED : Candidate::NOT_WANTED);
    EXPECT_EQ(candidate.answered_by, "scripted_dialogue");
  }
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
      EXPECT_TRUE(callService("/ask_human", call));
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
  cancelKnownGoal(align_);
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

// However many questions come and go while it hangs, it has one call to answer.
TEST_F(HangingDialogue, isNotFloodedByTheQuestionsThatPass) {
  constexpr int kRooms = 12;
  Question question = sendAndAwaitQuestion(sweepRooms(kRooms));
  const std::uint32_t first = question.question_id;
  ASSERT_TRUE(wasAsked(first));
  for (int room = 1; room < kRooms; ++room) {
    EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
    question = awaitQuestionAfter(question.question_id);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_EQ(asked_, std::vector<std::uint32_t>{first});
  }
  release(AskHuman::Response::YES);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS) << "the YES came too late";
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_EQ(asked_, (std::vector<std::uint32_t>{first, question.question_id}));
  EXPECT_EQ(most_, 1);
}

// A dialogue node inside the test that answers as no dialogue should.
class OddDialogue : public Scenario {
 protected:
  using Reply = std::function<AskHuman::Response(const Question&)>;

  OddDialogue() : events_(node_, "/goal_alignment/events") {}

  void SetUp() override {
    Scenario::SetUp();
    ASSERT_TRUE(eventually([this] { return events_.isHeard(); }));
  }

  void TearDown() override {
    Scenario::TearDown();
    server_.shutdown();
  }

  // It answers so the first time, and later NO.
  void answersFirst(const Reply& reply) {
    reply_ = reply;
    server_ = node_.advertiseService("/ask_human", &OddDialogue::ask, this);
  }

  bool ask(AskHuman::Request& request, AskHuman::Response& response) {
    const bool first = asked_++ == 0;
    response = first ? reply_(request.question) : answered(AskHuman::Response::NO, 0);
    return true;
  }

  static AskHuman::Response answered(int value, std::uint32_t id,
                                     const std::vector<std::string>& fluents = {}) {
    AskHuman::Response response;
    response.answer = static_cast<std::int8_t>(value);
    response.question_id = id;
    response.fluents = fluents;
    response.answered_by = "odd";
    return response;
  }

  // The answer is refused, people are told why, and the same question is asked again.
  void expectRefused(const Reply& reply, const std::string& reason) {
    answersFirst(reply);
    align_.sendGoal(sweepHall());
    EXPECT_TRUE(tellsOfRefusal(reason));
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
    EXPECT_EQ(result.questions, 1U);
    EXPECT_EQ(asked_, 2);
  }

  bool tellsOfRefusal(const std::string& reason) {
    return events_
        .waitFor([&](const std_msgs::String& line) {
          return line.data.find("an answer from /ask_human was refused") == 0 &&
                 line.data.find(reason) != std::string::npos;
        })
        .has_value();
  }

  Topic<std_msgs::String> events_;
  Reply reply_;
  std::atomic<int> asked_{0};
  ros::ServiceServer server_;
};

TEST_F(OddDialogue, thatNamesAForeignQuestionIsRefused) {
  expectRefused(
      [](const Question& question) {
        return answered(AskHuman::Response::YES, question.question_id + 500'000);
      },
      "was not asked here");
}

TEST_F(OddDialogue, thatGivesAnAnswerWhichIsNoneIsRefused) {
  expectRefused([](const Question& question) { return answered(7, question.question_id); },
                "7 is not an answer");
}

TEST_F(OddDialogue, thatAnswersFluentsOfNoQuestionIsRefused) {
  expectRefused(
      [](const Question& question) {
        return answered(AskHuman::Response::YES, question.question_id, {"(room hall)"});
      },
      "(room hall) is not part of question");
}

TEST_F(OddDialogue, thatVolunteersSomethingElseIsHeardAndAskedAgain) {
  std::string other;
  answersFirst([&](const Question& question) {
    const bool hall = question.fluents.at(0).args.at(0) == "hall";
    other = hall ? "(quiet kitchen)" : "(quiet hall)";
    return answered(AskHuman::Response::NO, 0, {other});
  });
  align_.sendGoal(sweepBothRooms());
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(asked_, 2) << "the same question";
  EXPECT_EQ(result.questions, 1U);
  for (const Candidate& candidate : result.candidates) {
    if (textOf(candidate.fluent) != other) continue;
    EXPECT_EQ(int{candidate.state}, Candidate::NOT_WANTED);
  }
}

TEST_F(OddDialogue, thatAnswersWhatNobodyCanReadIsRefused) {
  expectRefused(
      [](const Question& question) {
        return answered(AskHuman::Response::YES, question.question_id, {"((quiet\xff"});
      },
      "");
}

TEST_F(OddDialogue, thatHasNoAnswerIsAskedAgain) {
  answersFirst([](const Question& question) {
    return answered(AskHuman::Response::NONE, question.question_id);
  });
  align_.sendGoal(sweepHall());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_EQ(asked_, 2);
}

TEST_F(OddDialogue, thatNamesSomeOfAGroupSaysNoToTheRest) {
  const Parameter groups("max_group_size", 2);
  std::vector<std::string> group;
  answersFirst([&](const Question& question) {
    group = {textOf(question.fluents.at(0)), textOf(question.fluents.at(1))};
    return answered(AskHuman::Response::YES, question.question_id, {group[1]});
  });
  align_.sendGoal(lightLamps());
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(asked_, 2) << "the group, and the lamp that can't be lit beside the one that matters";
  for (const Candidate& candidate : result.candidates) {
    const std::string text = textOf(candidate.fluent);
    if (text != group[0] && text != group[1]) continue;
    EXPECT_EQ(int{candidate.state}, text == group[1] ? Candidate::WANTED : Candidate::NOT_WANTED);
    EXPECT_EQ(candidate.answered_by, "odd");
  }
}

TEST_F(OddDialogue, thatSaysNoToSomeOfAGroupIsAskedAboutTheRest) {
  const Parameter groups("max_group_size", 2);
  std::uint32_t id = 0;
  std::string first;
  answersFirst([&](const Question& question) {
    id = question.question_id;
    first = textOf(question.fluents.at(0));
    return answered(AskHuman::Response::NO, id, {first});
  });
  align_.sendGoal(lightLamps());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_EQ(asked_, 2);
  const auto narrowed = questions_.waitFor(
      [&](const Question& shown) { return shown.question_id == id && shown.fluents.size() == 1; });
  ASSERT_TRUE(narrowed);
  EXPECT_NE(textOf(narrowed->fluents[0]), first);
}

TEST_F(OddDialogue, thatAnswersAfterSomebodyElseDidIsRefused) {
  answersFirst([this](const Question& question) {
    EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
    return answered(AskHuman::Response::YES, question.question_id);
  });
  align_.sendGoal(sweepHall());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS) << "NO was faster";
  EXPECT_TRUE(tellsOfRefusal(""));
  EXPECT_EQ(asked_, 1);
}

}  // namespace
}  // namespace goal_alignment::test
