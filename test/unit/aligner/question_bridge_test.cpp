// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/question_bridge.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::CandidateState;
using Clock = QuestionBridge::Clock;

Literal literal(const std::string& text) {
  return Literal::parse(text);
}

session::Snapshot snapshotWith(
    const std::vector<std::pair<std::string, CandidateState>>& candidates) {
  session::Snapshot snapshot;
  snapshot.specified = {literal("(g)")};
  for (const auto& [text, state] : candidates) {
    session::CandidateView view;
    view.fluent = literal(text);
    view.state = state;
    snapshot.candidates.push_back(view);
  }
  return snapshot;
}

class Bridge : public testing::Test {
 protected:
  Bridge()
      : folder_(std::filesystem::temp_directory_path() /
                ("question_bridge_test." + std::to_string(getpid()))),
        bridge_(
            QuestionIds((folder_ / "ids").string()),
            [this](const std::string& session_id, const std::vector<AcceptedAnswer>& answers) {
              if (while_keeping_) while_keeping_();
              for (const AcceptedAnswer& each : answers)
                kept_.emplace_back(session_id, each.fluents);
            },
            [this] { return now_; }) {
    ros::Time::init();
    bridge_.beginSession("s");
    bridge_.update(snapshotWith({{"(a)", CandidateState::Open},
                                 {"(b)", CandidateState::Open},
                                 {"(c)", CandidateState::Wanted}}));
  }
  ~Bridge() override { std::filesystem::remove_all(folder_); }

  session::SubmitResult submit(int value, std::uint32_t id = 0,
                               const std::vector<std::string>& fluents = {}) {
    return bridge_.submit(request(value, id, fluents));
  }

  static Answer::Request request(int value, std::uint32_t id,
                                 const std::vector<std::string>& fluents) {
    Answer::Request request;
    request.answer = static_cast<std::int8_t>(value);
    request.question_id = id;
    request.fluents = fluents;
    request.answered_by = "Ann";
    return request;
  }

  void pass(double seconds) {
    now_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  std::filesystem::path folder_;
  Clock::time_point now_ = Clock::now();
  std::function<void()> while_keeping_;
  std::vector<std::pair<std::string, std::vector<Literal>>> kept_;
  QuestionBridge bridge_;
};

constexpr int kNo = Answer::Request::NO;
constexpr int kYes = Answer::Request::YES;

TEST_F(Bridge, anAnswerToTheOpenQuestionIsTakenOnce) {
  const std::uint32_t id = bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(kNo, id).accepted);
  EXPECT_EQ(bridge_.openId(), 0U);
  EXPECT_FALSE(submit(kYes, id).accepted);
  EXPECT_EQ(bridge_.wait(Clock::time_point::max()), QuestionBridge::Wake::Answer);
  const auto answers = bridge_.take();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].fluents, std::vector<Literal>{literal("(a)")});
  EXPECT_EQ(answers[0].kind, AnswerKind::No);
  EXPECT_EQ(answers[0].answered_by, "Ann");
  EXPECT_EQ(answers[0].question_id, id);
}

TEST_F(Bridge, refusalsSayWhy) {
  EXPECT_EQ(submit(kNo).message, "no question is open");
  const std::uint32_t id = bridge_.open({literal("(a)")});
  EXPECT_EQ(submit(4, id).message,
            "4 is not an answer: expected NO=0, YES=1, UNSURE=2 or DECLINE=3");
  EXPECT_EQ(submit(-1, id).accepted, false);
  EXPECT_EQ(submit(kNo, id + 5000).message,
            "question " + std::to_string(id + 5000) + " was not asked here");
  EXPECT_EQ(submit(kNo, id, {"(b)"}).message, "(b) is not part of question " + std::to_string(id));
  EXPECT_EQ(submit(kNo, 0, {"(c)"}).message, "(c) is answered already: use ~revise_answer");
  EXPECT_EQ(submit(kNo, 0, {"(g)"}).message, "(g) is part of the specified goal");
  EXPECT_EQ(submit(kNo, 0, {"(x)"}).message, "(x) is outside the state that the person expects");
  EXPECT_FALSE(submit(kNo, 0, {"(a"}).message.empty());
  bridge_.close();
  EXPECT_EQ(submit(kNo, id).message, "question " + std::to_string(id) + " is over");
  EXPECT_TRUE(bridge_.take().empty());
  bridge_.endSession();
  EXPECT_EQ(submit(kNo, 0, {"(a)"}).message, "no alignment is under way");
}

TEST_F(Bridge, beforeTheAnalysisNothingIsKnown) {
  bridge_.beginSession("t");
  EXPECT_EQ(submit(kNo, 0, {"(a)"}).message, "the candidates are not known yet");
}

TEST_F(Bridge, idZeroMustWaitAfterAQuestionReplacedAnother) {
  const std::uint32_t first = bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(kNo, 0).accepted) << "the first question replaces none";
  (void)bridge_.take();
  pass(60);
  const std::uint32_t second = bridge_.open({literal("(b)")});
  EXPECT_NE(first, second);
  pass(0.99);
  EXPECT_FALSE(submit(kNo, 0).accepted);
  EXPECT_TRUE(submit(kNo, 0, {"(a)"}).message.find("answered") != std::string::npos);
  pass(0.02);
  EXPECT_TRUE(submit(kNo, 0).accepted);
}

TEST_F(Bridge, duringTheGraceAnIdOrANamedFluentIsEnough) {
  bridge_.open({literal("(a)")});
  bridge_.close();
  const std::uint32_t second = bridge_.open({literal("(b)")});
  EXPECT_FALSE(submit(kNo, 0).accepted);
  EXPECT_TRUE(submit(kNo, 0, {"(a)"}).accepted) << "volunteered";
  EXPECT_TRUE(submit(kNo, second).accepted);
}

TEST_F(Bridge, aNewSessionsFirstQuestionReplacesOnlyOneThatHasJustVanished) {
  const auto openIn = [this](const std::string& session) {
    bridge_.endSession();
    bridge_.beginSession(session);
    bridge_.update(snapshotWith({{"(a)", CandidateState::Open}}));
    bridge_.open({literal("(a)")});
  };
  openIn("t");
  EXPECT_TRUE(submit(kNo, 0).accepted);
  openIn("u");
  EXPECT_TRUE(submit(kNo, 0).accepted) << "the one before was answered";
  openIn("v");
  openIn("w");
  EXPECT_FALSE(submit(kNo, 0).accepted) << "the one before was taken away";
  bridge_.endSession();
  pass(2);
  openIn("x");
  EXPECT_TRUE(submit(kNo, 0).accepted) << "the one before is long gone";
}

TEST_F(Bridge, whatIsAcceptedIsKeptBeforeItsGiverHearsOfIt) {
  const auto id = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(Answer::Request::YES, id, {"(a)"}).accepted);
  EXPECT_FALSE(submit(Answer::Request::YES, id, {"(a)"}).accepted);
  EXPECT_TRUE(bridge_.revise(request(Answer::Request::NO, 0, {"(c)"})).receipt.accepted);
  const std::vector<std::pair<std::string, std::vector<Literal>>> expected = {
      {"s", {literal("(a)")}}, {"s", {literal("(b)")}}, {"s", {literal("(c)")}}};
  EXPECT_EQ(kept_, expected);
}

TEST_F(Bridge, whatIsAcceptedIsKeptBeforeItIsTakenAndOneAfterTheOther) {
  const std::uint32_t id = bridge_.open({literal("(a)")});
  std::atomic<int> keeping = 0;
  while_keeping_ = [&] {
    EXPECT_EQ(++keeping, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));  // a slow disk
    --keeping;
  };
  std::thread giver([&] { EXPECT_TRUE(submit(kYes, id).accepted); });
  EXPECT_EQ(bridge_.wait(Clock::time_point::max()), QuestionBridge::Wake::Answer);
  EXPECT_EQ(bridge_.take().size(), 1U);
  EXPECT_EQ(kept_.size(), 1U);
  giver.join();

  const auto revise = [this](int value) {
    EXPECT_TRUE(bridge_.revise(request(value, 0, {"(a)"})).receipt.accepted);
  };
  std::thread one(revise, kNo);
  std::thread other(revise, kYes);
  one.join();
  other.join();
  EXPECT_EQ(kept_.size(), 3U);
}

TEST_F(Bridge, ofAGroupYesToSomeIsNoToTheRest) {
  const std::uint32_t id = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(kYes, id, {"(a)", "(A)"}).accepted);
  EXPECT_EQ(bridge_.openId(), 0U);
  const auto answers = bridge_.take();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].fluents, std::vector<Literal>{literal("(a)")});
  EXPECT_EQ(answers[0].kind, AnswerKind::Yes);
  EXPECT_EQ(answers[1].fluents, std::vector<Literal>{literal("(b)")});
  EXPECT_EQ(answers[1].kind, AnswerKind::No);
  EXPECT_EQ(answers[1].answered_by, "Ann");
  EXPECT_NE(submit(kYes, 0, {"(b)"}).message.find("answered already"), std::string::npos);
}

TEST_F(Bridge, ofAGroupYesToAllSaysNoToNone) {
  for (const bool named : {true, false}) {
    const std::uint32_t id = bridge_.open({literal("(a)"), literal("(b)")});
    const auto receipt =
        named ? submit(kYes, id, {"(b)", "(a)"}) : submit(kYes, id, std::vector<std::string>{});
    EXPECT_TRUE(receipt.accepted) << receipt.message;
    const auto answers = bridge_.take();
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers[0].fluents.size(), 2U);
    bridge_.update(snapshotWith({{"(a)", CandidateState::Open}, {"(b)", CandidateState::Open}}));
  }
}

TEST_F(Bridge, ofAGroupAVolunteeredYesLeavesTheRestOpen) {
  const std::uint32_t id = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(kYes, 0, {"(a)"}).accepted);
  EXPECT_EQ(bridge_.openId(), id);
  EXPECT_EQ(bridge_.take().size(), 1U);
  EXPECT_NE(submit(kYes, id, {"(a)"}).message.find("answered already"), std::string::npos);
  EXPECT_TRUE(submit(kNo, id).accepted);
  const auto answers = bridge_.take();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].fluents, std::vector<Literal>{literal("(b)")});
  EXPECT_EQ(bridge_.openId(), 0U);
}

TEST_F(Bridge, whatIsAssumedCanBeVolunteeredAndRevised) {
  session::Snapshot snapshot =
      snapshotWith({{"(a)", CandidateState::Unsure}, {"(b)", CandidateState::NotWanted}});
  for (auto& candidate : snapshot.candidates)
    candidate.assumed = true;
  bridge_.update(snapshot);
  EXPECT_TRUE(submit(kNo, 0, {"(a)"}).accepted);
  EXPECT_FALSE(submit(kYes, 0, {"(a)"}).accepted) << "now it is answered";
  EXPECT_TRUE(bridge_.revise(request(kYes, 0, {"(b)"})).receipt.accepted);
}

TEST_F(Bridge, aQuestionThatReplacesTheOpenOneEndsIt) {
  const std::uint32_t first = bridge_.open({literal("(a)")});
  const std::uint32_t second = bridge_.open({literal("(b)")});
  EXPECT_EQ(submit(kNo, first).message, "question " + std::to_string(first) + " is over");
  EXPECT_FALSE(submit(kNo, 0).accepted) << "nobody can have read it";
  EXPECT_TRUE(submit(kNo, second).accepted);
}

TEST_F(Bridge, opensNothingBeforeAcceptedAnswersAreTaken) {
  const std::uint32_t first = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(kNo, first, {"(a)"}).accepted);
  EXPECT_EQ(bridge_.open({literal("(a)")}), 0U);
  EXPECT_EQ(bridge_.openId(), first) << "the rest of it can still be answered";
  EXPECT_TRUE(submit(kNo, first).accepted);
  EXPECT_EQ(bridge_.open({literal("(b)")}), 0U);
  EXPECT_EQ(bridge_.openId(), 0U);
  EXPECT_EQ(bridge_.take().size(), 2U);
  EXPECT_GT(bridge_.open({literal("(b)")}), first);
}

TEST_F(Bridge, ofAGroupNoToSomeLeavesTheRestOpen) {
  const std::uint32_t id = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(kNo, id, {"(a)"}).accepted);
  EXPECT_EQ(bridge_.openId(), id);
  EXPECT_TRUE(submit(kYes, id).accepted);
  const auto answers = bridge_.take();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[1].fluents, std::vector<Literal>{literal("(b)")});
}

TEST_F(Bridge, acceptedAnswersCountOnANewerSnapshotThatLacksThem) {
  EXPECT_TRUE(submit(kNo, 0, {"(a)"}).accepted);
  bridge_.update(snapshotWith({{"(a)", CandidateState::Open}, {"(b)", CandidateState::Open}}));
  EXPECT_FALSE(submit(kYes, 0, {"(a)"}).accepted);
  EXPECT_TRUE(submit(kYes, 0, {"(b)"}).accepted);
}

TEST_F(Bridge, declineNeedsAnOpenQuestionAndClosesIt) {
  EXPECT_FALSE(submit(Answer::Request::DECLINE, 0, {"(a)"}).accepted);
  const std::uint32_t id = bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(Answer::Request::DECLINE, id).accepted);
  EXPECT_EQ(bridge_.openId(), 0U);
  EXPECT_EQ(bridge_.take().at(0).kind, AnswerKind::Decline);
}

TEST_F(Bridge, revisionsChangeAnswersAndSaySoWhenTheSessionHasToGoOn) {
  auto revision = bridge_.revise(request(kNo, 0, {"(c)"}));
  EXPECT_TRUE(revision.receipt.accepted);
  EXPECT_EQ(revision.continue_session, "") << "the solver thread takes it";
  EXPECT_FALSE(bridge_.endSessionIfIdle());
  (void)bridge_.take();
  EXPECT_TRUE(bridge_.endSessionIfIdle());

  revision = bridge_.revise(request(kYes, 0, {"(c)"}));
  EXPECT_TRUE(revision.receipt.accepted);
  EXPECT_EQ(revision.continue_session, "s");
  bridge_.beginSession("s");
  EXPECT_EQ(bridge_.take().size(), 1U);
  EXPECT_FALSE(bridge_.revise(request(kNo, 0, {})).receipt.accepted);
  EXPECT_FALSE(bridge_.revise(request(Answer::Request::DECLINE, 0, {"(c)"})).receipt.accepted);
}

TEST_F(Bridge, aRevisionIsForgottenWhenAnotherTaskComes) {
  bridge_.endSession();
  EXPECT_TRUE(bridge_.revise(request(kYes, 0, {"(c)"})).receipt.accepted);
  bridge_.beginSession("another");
  EXPECT_TRUE(bridge_.take().empty());
}

TEST_F(Bridge, whatWasAcceptedIsKeptUntilTheSessionGoesOn) {
  const auto id = bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(Answer::Request::NO, 0, {"(b)"}).accepted);
  EXPECT_TRUE(submit(Answer::Request::DECLINE, id).accepted);
  bridge_.endSession();
  EXPECT_TRUE(bridge_.revise(request(Answer::Request::NO, 0, {"(c)"})).receipt.accepted);
  bridge_.beginSession("s");
  bridge_.endSession();  // its goal was displaced at once
  bridge_.beginSession("s");
  const auto kept = bridge_.take();
  ASSERT_EQ(kept.size(), 2U) << "whom it was said to declined the session that has ended";
  EXPECT_EQ(kept[0].fluents, std::vector<Literal>{literal("(b)")});
  EXPECT_EQ(kept[1].fluents, std::vector<Literal>{literal("(c)")});
}

// (a) and (b) as they were published before any answer.
AlignmentState published(const std::string& session_id = "s") {
  AlignmentState state;
  state.session_id = session_id;
  for (const char* name : {"a", "b"}) {
    Candidate candidate;
    candidate.fluent.name = name;
    candidate.state = Candidate::OPEN;
    state.candidates.push_back(candidate);
  }
  return state;
}

TEST_F(Bridge, whatWasAcceptedIsShownBeforeAStateWithItIsPublished) {
  bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(Answer::Request::YES).accepted);
  AlignmentState state = published();
  bridge_.unshown().addTo(state);
  EXPECT_EQ(int{state.candidates[0].state}, int{Candidate::WANTED});
  EXPECT_EQ(state.candidates[0].answered_by, "Ann");
  EXPECT_FALSE(state.candidates[0].answered_at.isZero());
  EXPECT_EQ(int{state.candidates[1].state}, int{Candidate::OPEN});

  (void)bridge_.take();  // the session has it, onlookers don't
  EXPECT_TRUE(bridge_.revise(request(kNo, 0, {"(a)"})).receipt.accepted);
  state = published();
  bridge_.unshown().addTo(state);
  EXPECT_EQ(int{state.candidates[0].state}, int{Candidate::NOT_WANTED}) << "the newest counts";
  AlignmentState other = published("another session");
  bridge_.unshown().addTo(other);
  EXPECT_EQ(int{other.candidates[0].state}, int{Candidate::OPEN});

  (void)bridge_.take();
  bridge_.markShown();
  EXPECT_TRUE(bridge_.unshown().answers.empty());
}

TEST_F(Bridge, whoAnsweredIsANameThatALogCanShow) {
  Answer::Request answer = request(Answer::Request::YES, 0, {"(a)"});
  answer.answered_by = "Ann\n[ERROR] fire\x1b[2J" + std::string(100000, '!');
  EXPECT_TRUE(bridge_.submit(answer).accepted);
  answer.answer = Answer::Request::NO;
  EXPECT_TRUE(bridge_.revise(answer).receipt.accepted);
  const auto accepted = bridge_.take();
  ASSERT_EQ(accepted.size(), 2U);
  for (const AcceptedAnswer& each : accepted) {
    EXPECT_EQ(each.answered_by.rfind("Ann [ERROR] fire [2J!!!", 0), 0U);
    EXPECT_LT(each.answered_by.size(), 300U);
  }
}

TEST_F(Bridge, waitsEndByInterruptAndByTime) {
  EXPECT_EQ(bridge_.wait(Clock::now()), QuestionBridge::Wake::TimedOut);
  std::thread interrupter([this] { bridge_.interrupt(); });
  EXPECT_EQ(bridge_.wait(Clock::time_point::max()), QuestionBridge::Wake::Interrupt);
  interrupter.join();
}

TEST(QuestionIds, neverRepeatAcrossObjectsOfOneFile) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("question_ids_test." + std::to_string(getpid()));
  const std::string file = (folder / "sub" / "ids").string();
  std::set<std::uint32_t> ids;
  for (int run = 0; run < 3; ++run) {
    QuestionIds source(file);
    EXPECT_EQ(source.lastError(), "");
    for (int i = 0; i < 1500; ++i) {
      const std::uint32_t id = source.next();
      EXPECT_NE(id, 0U);
      EXPECT_TRUE(ids.insert(id).second) << id << " came twice";
      EXPECT_TRUE(source.issued(id));
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(QuestionIds, surviveADamagedOrUnusableFile) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("question_ids_test2." + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "ids");  // a folder where the file should be
  QuestionIds unusable((folder / "ids").string());
  EXPECT_NE(unusable.lastError(), "");
  const std::uint32_t first = unusable.next();
  EXPECT_GT(unusable.next(), first);
  std::filesystem::remove_all(folder);
}

TEST_F(Bridge, anInterruptAndANudgeWakeOnce) {
  bridge_.open({literal("(a)")});
  bridge_.wakeUp();
  EXPECT_EQ(bridge_.wait(Clock::time_point::max()), QuestionBridge::Wake::News);
  EXPECT_EQ(bridge_.wait(Clock::now()), QuestionBridge::Wake::TimedOut);
  bridge_.interrupt();
  EXPECT_EQ(bridge_.wait(Clock::time_point::max()), QuestionBridge::Wake::Interrupt);
  EXPECT_EQ(bridge_.wait(Clock::now()), QuestionBridge::Wake::TimedOut);
}

TEST_F(Bridge, aQuestionPutAgainNeedsNoGrace) {
  const std::uint32_t first = bridge_.open({literal("(a)")});
  bridge_.close();
  const std::uint32_t again = bridge_.open({literal("(a)")});
  EXPECT_GT(again, first);
  EXPECT_TRUE(submit(kNo).accepted);
}

TEST_F(Bridge, anAnswerToAnEarlierPutOfTheOpenQuestionCounts) {
  const std::uint32_t first = bridge_.open({literal("(a)"), literal("(b)")});
  bridge_.close();
  const std::uint32_t second = bridge_.open({literal("(b)"), literal("(a)")});
  const std::uint32_t third = bridge_.open({literal("(a)"), literal("(b)")});
  EXPECT_TRUE(submit(kYes, first, {"(a)"}).accepted);
  const auto answers = bridge_.take();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].question_id, third);
  EXPECT_EQ(answers[1].kind, AnswerKind::No) << "of a group, as with the newest id";
  for (const std::uint32_t id : {first, second, third})
    EXPECT_EQ(submit(kNo, id).message, "question " + std::to_string(id) + " is over");
}

TEST_F(Bridge, anEarlierPutIsOverWithAnAnswerAnotherQuestionAndAnotherSession) {
  const std::uint32_t answered = bridge_.open({literal("(a)")});
  EXPECT_TRUE(submit(kNo, answered).accepted);
  (void)bridge_.take();
  bridge_.open({literal("(a)")});  // the session has lost that answer: it asks for a new one
  EXPECT_FALSE(submit(kNo, answered).accepted);
  const std::uint32_t replaced = bridge_.open({literal("(b)")});
  bridge_.open({literal("(a)")});
  bridge_.open({literal("(b)")});
  EXPECT_FALSE(submit(kNo, replaced).accepted) << "another one came in between";
  const std::uint32_t before = bridge_.openId();
  bridge_.endSession();
  bridge_.beginSession("t");
  bridge_.update(snapshotWith({{"(b)", CandidateState::Open}}));
  bridge_.open({literal("(b)")});
  EXPECT_FALSE(submit(kNo, before).accepted);
}

TEST_F(Bridge, remembersWhyAnswersToTheOpenQuestionWereRefused) {
  bridge_.open({literal("(a)")});
  EXPECT_EQ(bridge_.refusals(), "");
  EXPECT_FALSE(submit(9).accepted);
  EXPECT_FALSE(submit(kNo, 0, {"(x"}).accepted);
  EXPECT_FALSE(submit(kNo, 0, {"(g)"}).accepted);
  EXPECT_FALSE(submit(9).accepted);
  EXPECT_FALSE(submit(kNo, 0, {"(c)"}).accepted);
  const std::string nine = "9 is not an answer: expected NO=0, YES=1, UNSURE=2 or DECLINE=3";
  const std::string last = "(g) is part of the specified goal; " + nine +
                           "; (c) is answered already: use ~revise_answer";
  EXPECT_EQ(bridge_.refusals(), last);
  bridge_.open({literal("(a)")});
  EXPECT_EQ(bridge_.refusals(), last) << "it is the same, put again";
  EXPECT_TRUE(submit(kNo, 0, {"(b)"}).accepted);
  EXPECT_EQ(bridge_.refusals(), "");
  EXPECT_FALSE(submit(9).accepted);
  (void)bridge_.take();
  bridge_.open({literal("(b)")});
  EXPECT_EQ(bridge_.refusals(), "") << "they were about another one";
  EXPECT_FALSE(submit(9).accepted);
  bridge_.beginSession("s");
  EXPECT_EQ(bridge_.refusals(), "");
}

}  // namespace
}  // namespace goal_alignment::aligner
