// SPDX-License-Identifier: BSD-3-Clause
// Dialogues that were broken off and go on: what was answered is not asked again.
#include <std_srvs/Trigger.h>

#include <csignal>
#include <filesystem>

#include "generated_tasks.h"
#include "own_aligner.h"

namespace goal_alignment::test {
namespace {

namespace fs = std::filesystem;

class JournalScenario : public OwnAligner {
 protected:
  void SetUp() override {
    ros::param::del("/goal_alignment/journal_expiry");
    OwnAligner::SetUp();
  }

  void TearDown() override {
    OwnAligner::TearDown();
    ros::param::del("/goal_alignment/journal_expiry");
  }

  std::vector<fs::path> journalFiles(const std::string& suffix) const {
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(journalFolder(), none))
      if (entry.path().extension() == suffix) files.push_back(entry.path());
    return files;
  }

  std::size_t entries() const { return journalFiles(".json").size(); }

  // Answers the first of two or more questions with NO and returns both.
  std::pair<Question, Question> answerTheFirst(const AlignGoal& goal) {
    const Question first = sendAndAwaitQuestion(goal);
    EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted);
    return {first, awaitQuestionAfter(first.question_id)};
  }

  // Leaves the entry of a dialogue behind whose first question is answered.
  std::pair<Question, Question> abort(const AlignGoal& goal) {
    const auto questions = answerTheFirst(goal);
    cancelTheGoal();
    return questions;
  }

  void cancelTheGoal() {
    cancelKnownGoal(align_);
    EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
    EXPECT_TRUE(questionIsClosed());
  }

  std_srvs::TriggerResponse forget() {
    std_srvs::Trigger call;
    EXPECT_TRUE(callService("/goal_alignment/forget", call));
    return call.response;
  }

  bool wasWarned(const std::string& text) {
    return eventually([&] { return alignersOutput().find(text) != std::string::npos; });
  }
};

bool areAboutTheSame(const Question& one, const Question& other) {
  return one.fluents.at(0).name == other.fluents.at(0).name &&
         one.fluents.at(0).args == other.fluents.at(0).args;
}

Candidate answered(const std::vector<Candidate>& candidates, const Question& question) {
  for (const Candidate& candidate : candidates) {
    if (candidate.fluent.name == question.fluents.at(0).name &&
        candidate.fluent.args == question.fluents.at(0).args) {
      return candidate;
    }
  }
  ADD_FAILURE() << "no candidate " << question.text;
  return {};
}

TEST_F(JournalScenario, aDialogueGoesOnAfterACrash) {
  const auto [first, second] = answerTheFirst(sweepBothRooms());
  const std::string session = second.session_id;
  const auto before = states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == session && state.questions_asked == 2 &&
           state.phase == AlignmentState::AWAITING_ANSWER;
  });
  ASSERT_TRUE(before);
  EXPECT_EQ(entries(), 1U);
  killAligner();
  startAligner();

  const Question again = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(again, second));
  EXPECT_GT(again.question_id, second.question_id) << "ids never repeat";
  EXPECT_NE(again.session_id, session);
  EXPECT_TRUE(events_.waitFor([](const std_msgs::String& line) {
    return line.data.find("answered before this dialogue was broken off") != std::string::npos;
  }));
  EXPECT_TRUE(answer(Answer::Request::NO, again.question_id).accepted);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.questions, 1U);
  const Candidate remembered = answered(result.candidates, first);
  EXPECT_EQ(int{remembered.state}, Candidate::NOT_WANTED);
  EXPECT_EQ(remembered.answered_by, "test");
  EXPECT_FALSE(remembered.answered_at.isZero());
  EXPECT_EQ(remembered.answered_at, answered(before->candidates, first).answered_at);
  EXPECT_EQ(entries(), 0U) << "after the outcome there is nothing to take up again";
}

TEST_F(JournalScenario, whatWasAcceptedSurvivesACrashAtOnce) {
  const Question first = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_TRUE(answer(Answer::Request::NO, first.question_id).accepted);
  killAligner();
  startAligner();
  EXPECT_FALSE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), first));
}

TEST_F(JournalScenario, aCanceledDialogueThatIsSentAgainAsksNothingTwice) {
  const auto [first, second] = abort(sweepBothRooms());
  EXPECT_EQ(entries(), 1U);
  const Question again = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(again, second));
  EXPECT_TRUE(answer(Answer::Request::YES, again.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  EXPECT_EQ(entries(), 0U);

  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), first)) << "a new dialogue";
}

TEST_F(JournalScenario, whatWasAssumedIsNoAnswer) {
  ros::param::set("/goal_alignment/assumed_wanted_predicates", std::vector<std::string>{"room"});
  const auto [first, second] = abort(sweepBothRooms());
  ros::param::del("/goal_alignment/assumed_wanted_predicates");
  ASSERT_EQ(entries(), 1U);
  const std::string text = textOf(journalFiles(".json").front());
  EXPECT_NE(text.find("(quiet "), std::string::npos) << text;
  EXPECT_EQ(text.find("(room "), std::string::npos) << text;
  const Question again = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(again, second));
  cancelTheGoal();
}

TEST_F(JournalScenario, otherPersonsAndOtherPlansHaveOtherEntries) {
  const auto [first, second] = abort(sweepBothRooms());
  AlignGoal others = sweepBothRooms();
  others.task.person = "Bob";
  EXPECT_TRUE(areAboutTheSame(abort(others).first, first));
  EXPECT_EQ(entries(), 2U);

  AlignGoal another_way = sweepBothRooms();
  std::reverse(another_way.task.plan.begin(), another_way.task.plan.end());
  EXPECT_TRUE(areAboutTheSame(abort(another_way).first, first));
  EXPECT_EQ(entries(), 3U);

  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), second));
}

TEST_F(JournalScenario, anotherRobotBelowTheSameFolderKnowsNothingOfIt) {
  const auto [first, second] = abort(sweepBothRooms());
  Program other(NODE_FOLDER "/goal_alignment_node", {"__ns:=/other"}, {{"ROS_HOME", home_.path()}},
                home_.path() + "/other");
  AlignClient client(node_, "/other/goal_alignment/align");
  Topic<Question> questions(node_, "/other/goal_alignment/question");
  ASSERT_TRUE(isLinked(client, "/other/goal_alignment", "/other/goal_alignment/align"));
  client.sendGoal(sweepBothRooms());
  const auto asked = questions.waitFor([](const Question& shown) { return shown.question_id > 0; });
  ASSERT_TRUE(asked) << textOf(home_.path() + "/other");
  EXPECT_TRUE(areAboutTheSame(*asked, first)) << "it was answered to the other robot";
  other.signal(SIGKILL);
  other.exitStatus();
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), second));
}

TEST_F(JournalScenario, aDialogueThatWasDeclinedGoesOn) {
  const auto [first, second] = answerTheFirst(sweepBothRooms());
  EXPECT_TRUE(answer(Answer::Request::DECLINE, second.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::DECLINED);
  EXPECT_EQ(entries(), 1U);
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), second));
}

TEST_F(JournalScenario, aDialogueThatNobodyIsSureOfAsksAboutThatAloneOnceMore) {
  const auto [first, second] = answerTheFirst(sweepBothRooms());
  EXPECT_TRUE(answer(Answer::Request::UNSURE, second.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(entries(), 1U);
  killAligner();
  startAligner();
  const Question asked = sendAndAwaitQuestion(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(asked, second));
  EXPECT_TRUE(answer(Answer::Request::NO, asked.question_id).accepted);
  const AlignResult again = awaitResult();
  EXPECT_EQ(again.outcome, AlignResult::SUCCESS);
  EXPECT_EQ(again.questions, 1U);
  EXPECT_EQ(int{answered(again.candidates, first).state}, Candidate::NOT_WANTED);
}

TEST_F(JournalScenario, anEntryOlderThanJournalExpiryIsDeletedAndAYoungerOneUsed) {
  ros::param::set("/goal_alignment/journal_expiry", 3600.0);
  const auto [first, second] = abort(sweepBothRooms());
  ASSERT_EQ(entries(), 1U);
  const fs::path entry = journalFiles(".json").front();
  const auto minutesAgo = [](int minutes) {
    return fs::file_time_type::clock::now() - std::chrono::minutes(minutes);
  };
  fs::last_write_time(entry, minutesAgo(30));
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), second));
  cancelTheGoal();

  fs::last_write_time(entry, minutesAgo(90));
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), first));
  EXPECT_EQ(entries(), 0U);
}

TEST_F(JournalScenario, forgetDropsTheEntryAndNothingIsWrittenAfterwards) {
  const std_srvs::TriggerResponse without_task = forget();
  EXPECT_FALSE(without_task.success);
  EXPECT_FALSE(without_task.message.empty());

  const auto [first, second] = answerTheFirst(sweepRooms(3));
  ASSERT_EQ(entries(), 1U);
  EXPECT_TRUE(forget().success);
  EXPECT_EQ(entries(), 0U);
  EXPECT_TRUE(answer(Answer::Request::NO, second.question_id).accepted);
  awaitQuestionAfter(second.question_id);
  EXPECT_EQ(entries(), 0U);
  killAligner();
  startAligner();
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepRooms(3)), first));
}

TEST_F(JournalScenario, aDamagedEntryIsSetAsideAndTheDialogueBeginsAnew) {
  const auto [first, second] = abort(sweepBothRooms());
  ASSERT_EQ(entries(), 1U);
  const fs::path entry = journalFiles(".json").front();
  const std::string text = textOf(entry);
  std::string other_version = text;
  const std::string version = "\"version\": 1";
  ASSERT_NE(text.find(version), std::string::npos) << text;
  other_version.replace(text.find(version), version.size(), "\"version\": 2");
  const std::string rubbish("\xff\x00{[", 4);
  for (const std::string& damaged :
       {rubbish, text.substr(0, text.size() / 2), other_version, std::string()}) {
    writeText(entry, damaged);
    EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), first)) << damaged;
    EXPECT_EQ(entries(), 0U);
    ASSERT_EQ(journalFiles(".damaged").size(), 1U);
    EXPECT_EQ(textOf(journalFiles(".damaged").front()), damaged) << "somebody may want to see it";
    EXPECT_TRUE(wasWarned("is damaged and set aside"));
    cancelTheGoal();
  }
  // What was set aside is in nobody's way.
  abort(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), second));
}

TEST_F(JournalScenario, aFolderThatCannotBeWrittenHarmsNothing) {
  fs::create_directories(fs::path(journalFolder()).parent_path());
  writeText(journalFolder(), "no folder");
  const auto [first, second] = abort(sweepBothRooms());
  EXPECT_TRUE(wasWarned("the answers can't be written to the journal"));
  const auto [first_again, second_again] = answerTheFirst(sweepBothRooms());
  EXPECT_TRUE(areAboutTheSame(first_again, first));
  EXPECT_TRUE(forget().success);
  EXPECT_TRUE(answer(Answer::Request::NO, second_again.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_EQ(textOf(journalFolder()), "no folder");
}

TEST_F(JournalScenario, withJournalExpiryZeroNothingIsKept) {
  ros::param::set("/goal_alignment/journal_expiry", 0.0);
  const auto [first, second] = abort(sweepBothRooms());
  EXPECT_FALSE(fs::exists(journalFolder()));
  EXPECT_TRUE(areAboutTheSame(sendAndAwaitQuestion(sweepBothRooms()), first));
}

}  // namespace
}  // namespace goal_alignment::test
