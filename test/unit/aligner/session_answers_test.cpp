// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/session_answers.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "aligner/align_goal_reader.h"
#include "session_samples.h"

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;
using session::AnswerKind;
using session::CandidateState;

constexpr double kWeek = 604800;  // seconds

class SessionAnswersTest : public testing::Test {
 protected:
  SessionAnswersTest() {
    samples::think(record_);
    journal_.open("key", "s1", kWeek);
  }
  ~SessionAnswersTest() override { fs::remove_all(folder_); }

  static AcceptedAnswer given(const std::string& fluent, AnswerKind kind) {
    return {{Literal::parse(fluent)}, kind, "Ann", 0, ros::Time(12, 34)};
  }

  CandidateState stateOf(const std::string& fluent) const {
    return record_.session->snapshot().candidateOf(Literal::parse(fluent))->state;
  }

  std::vector<JournalAnswer> onRecord() {
    Journal next(folder_, [](const std::string&) {});
    return next.open("key", "s2", kWeek);
  }

  const std::string folder_ =
      fs::temp_directory_path() / ("session_answers_test." + std::to_string(getpid()));
  SessionRecord record_ = samples::deskRecord();
  Journal journal_{folder_, [](const std::string&) {}};
  std::vector<std::string> lines_;
  SessionAnswers answers_{record_, journal_,
                          [this](const std::string& line) { lines_.push_back(line); }};
};

TEST_F(SessionAnswersTest, firstAndRevisedAnswersReachTheSessionAndTheJournal) {
  record_.timeouts = 2;
  answers_.apply(given("(held b)", AnswerKind::No));
  EXPECT_EQ(stateOf("(held b)"), CandidateState::NotWanted);
  EXPECT_EQ(record_.timeouts, 0U) << "somebody is there";
  EXPECT_EQ(record_.answer_times.at(Literal::parse("(held b)")), ros::Time(12, 34));
  answers_.apply(given("(held b)", AnswerKind::Yes));
  EXPECT_EQ(stateOf("(held b)"), CandidateState::Wanted);
  EXPECT_EQ(lines_.size(), 2U);
  ASSERT_EQ(onRecord().size(), 1U);
  EXPECT_EQ(onRecord()[0].kind, AnswerKind::Yes);
}

TEST_F(SessionAnswersTest, restoresAnswersFromTheJournalOnce) {
  record_.journaled = {{Literal::parse("(held a)"), AnswerKind::No, "Ben", ros::Time(5, 6)}};
  answers_.restoreFromJournal();
  EXPECT_EQ(stateOf("(held a)"), CandidateState::NotWanted);
  EXPECT_EQ(record_.answer_times.at(Literal::parse("(held a)")), ros::Time(5, 6));
  EXPECT_TRUE(record_.journaled.empty());
  EXPECT_EQ(lines_.size(), 1U);
  answers_.restoreFromJournal();
  EXPECT_EQ(lines_.size(), 1U);
}

TEST_F(SessionAnswersTest, forgetsUnsureAnswersOnly) {
  answers_.apply(given("(held a)", AnswerKind::No));
  answers_.apply(given("(down a)", AnswerKind::Unsure));
  EXPECT_EQ(onRecord().size(), 2U);
  answers_.forgetUnsureAnswers();
  ASSERT_EQ(onRecord().size(), 1U);
  EXPECT_EQ(onRecord()[0].fluent, Literal::parse("(held a)"));
}

TEST_F(SessionAnswersTest, candidatesHaveToBeOfTheSession) {
  Fluent fluent;
  fluent.name = "held";
  fluent.args = {"b"};
  EXPECT_EQ(answers_.candidatesOf({fluent}, "f").size(), 1U);
  fluent.args = {"c"};
  EXPECT_THROW(answers_.candidatesOf({fluent}, "f"), GoalError);
}

}  // namespace
}  // namespace goal_alignment::aligner
