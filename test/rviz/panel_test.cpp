// SPDX-License-Identifier: BSD-3-Clause
// The panel in rviz, before a person with a mouse and a keyboard.
#include <std_msgs/String.h>

#include <QTabWidget>
#include <QTableView>
#include <algorithm>

#include "goal_alignment/AlignResult.h"
#include "rviz_scenario.h"

namespace goal_alignment::test {
namespace {

constexpr int kPhraseColumn = 0;
constexpr int kChangeColumn = 2;
constexpr int kRightButton = 3;

AlignGoal lightInGroups() {
  AlignGoal goal = lightLamps();
  goal.max_group_size = 2;
  return goal;
}

class PanelInRviz : public RvizScenario {
 protected:
  void begin(const std::vector<std::string>& aligners = {"goal_alignment"}) {
    for (const std::string& aligner : aligners) {
      const std::size_t slash = aligner.find('/', 1);
      ASSERT_NO_FATAL_FAILURE(
          startAligner(slash == std::string::npos ? "" : aligner.substr(1, slash - 1)));
    }
    ASSERT_NO_FATAL_FAILURE(startRviz(configFor(aligners)));
    for (std::size_t i = 0; i < aligners.size(); ++i) {
      ASSERT_TRUE(comesTrue([&] {
        return textOf("status", static_cast<int>(i)) == "Waiting for a task";
      })) << textOf("status", static_cast<int>(i)).toStdString();
    }
  }

  void sendAndAwaitQuestion(const AlignGoal& goal) {
    send(goal);
    ASSERT_TRUE(asks("matter"));
  }

  // Answers what is asked until the alignment is over.
  void answerAllWith(const QString& button) {
    ASSERT_TRUE(comesTrue([&] {
      auto* widget = part(button);
      if (widget != nullptr && widget->isVisible() && widget->isEnabled()) clickOn(widget);
      const auto now = state();
      return now && now->phase == AlignmentState::DONE;
    }));
  }

  bool isDone(int outcome) {
    return comesTrue([&] {
      const auto now = state();
      return now && now->phase == AlignmentState::DONE && now->outcome == outcome;
    });
  }

  bool becomes(const std::string& pddl, int expected, const std::string& robot = "") {
    return comesTrue([&] { return candidateState(pddl, robot) == expected; });
  }
};

TEST_F(PanelInRviz, aClickOnYesAnswersTheQuestion) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  EXPECT_FALSE(textOf("question_why").isEmpty());
  savePicture("question");
  ASSERT_NO_FATAL_FAILURE(clickOn(part("yes")));
  EXPECT_TRUE(becomes("(quiet hall)", Candidate::WANTED));
  const auto now = state();
  const auto quiet =
      std::find_if(now->candidates.begin(), now->candidates.end(),
                   [](const Candidate& each) { return each.fluent.name == "quiet"; });
  ASSERT_NE(quiet, now->candidates.end());
  EXPECT_EQ(quiet->answered_by, "panel");
  EXPECT_TRUE(isDone(AlignResult::EXPECTATION_UNACHIEVABLE));
  EXPECT_TRUE(comesTrue([this] { return !shows("question_card") && shows("outcome_card"); }));
}

TEST_F(PanelInRviz, keysAnswerFromAnywhereInTheWindow) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  pressKeys("alt+n");
  EXPECT_TRUE(becomes("(quiet hall)", Candidate::NOT_WANTED));
  EXPECT_TRUE(isDone(AlignResult::SUCCESS));
  EXPECT_TRUE(comesTrue([this] { return part<QTabWidget>("tabs")->tabText(2) == "Plan (1)"; }));
}

TEST_F(PanelInRviz, ofAGroupTheTickedOnesMatter) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(lightInGroups()));
  std::vector<std::string> asked;
  for (const char* lamp : {"(lit a1)", "(lit a2)", "(lit b1)", "(lit b2)"})
    if (part(lamp) != nullptr) asked.emplace_back(lamp);
  ASSERT_EQ(asked.size(), 2U);
  const std::string& ticked = asked[0];
  const std::string& left = asked[1];
  ASSERT_FALSE(part("yes")->isEnabled());
  clickAt(part(QString::fromStdString(ticked)), [] { return QPoint(9, 9); });
  ASSERT_TRUE(comesTrue([this] { return part("yes")->isEnabled(); }));
  savePicture("group");
  ASSERT_NO_FATAL_FAILURE(clickOn(part("yes")));
  EXPECT_TRUE(becomes(ticked, Candidate::WANTED));
  EXPECT_TRUE(becomes(left, Candidate::NOT_WANTED));
}

TEST_F(PanelInRviz, whatIsVolunteeredOfAGroupIsAskedNoMoreAndTheRestCanBeAnswered) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(lightInGroups()));
  std::vector<std::string> asked;
  for (const char* lamp : {"(lit a1)", "(lit a2)", "(lit b1)", "(lit b2)"})
    if (part(lamp) != nullptr) asked.emplace_back(lamp);
  ASSERT_EQ(asked.size(), 2U);
  const QString volunteered = QString::fromStdString(asked[0]);
  ASSERT_TRUE(comesTrue([&] { return rowWith("candidates", volunteered) >= 0; }));
  clickCell("candidates", rowWith("candidates", volunteered), kPhraseColumn, kRightButton);
  ASSERT_NO_FATAL_FAILURE(choose("It matters to me"));
  EXPECT_TRUE(becomes(asked[0], Candidate::WANTED));
  EXPECT_TRUE(comesTrue([&] { return part(volunteered) == nullptr; }));
  EXPECT_EQ(candidateState(asked[1]), Candidate::ASKED);
  savePicture("narrowed");
  ASSERT_NO_FATAL_FAILURE(clickOn(part("no")));
  EXPECT_TRUE(becomes(asked[1], Candidate::NOT_WANTED));
}

TEST_F(PanelInRviz, whatNobodyAskedIsVolunteeredFromTheTable) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(lightLamps()));
  std::string other;
  ASSERT_TRUE(comesTrue([&] {
    for (const char* lamp : {"(lit a1)", "(lit b1)", "(lit a2)", "(lit b2)"})
      if (candidateState(lamp) == Candidate::OPEN) other = lamp;
    return !other.empty() && rowWith("candidates", QString::fromStdString(other)) >= 0;
  }));
  clickCell("candidates", rowWith("candidates", QString::fromStdString(other)), kPhraseColumn,
            kRightButton);
  ASSERT_NO_FATAL_FAILURE(choose("It matters to me"));
  EXPECT_TRUE(becomes(other, Candidate::WANTED));
}

TEST_F(PanelInRviz, anAnswerIsChanged) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  ASSERT_NO_FATAL_FAILURE(clickOn(part("yes")));
  ASSERT_TRUE(isDone(AlignResult::EXPECTATION_UNACHIEVABLE));
  ASSERT_TRUE(comesTrue([this] { return rowWith("answers", "(quiet hall)") == 0; }));
  ASSERT_NO_FATAL_FAILURE(openTab(1));
  savePicture("answers");
  ASSERT_NO_FATAL_FAILURE(clickCell("answers", 0, kChangeColumn));
  ASSERT_NO_FATAL_FAILURE(choose("no, it doesn't matter"));
  EXPECT_TRUE(isDone(AlignResult::SUCCESS));
  EXPECT_EQ(candidateState("(quiet hall)"), Candidate::NOT_WANTED);
}

TEST_F(PanelInRviz, anAlternativeIsTakenUp) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  ASSERT_NO_FATAL_FAILURE(clickOn(part("yes")));
  ASSERT_TRUE(comesTrue([this] { return shows("alternative_0"); }));
  EXPECT_TRUE(textOf("conflict").contains("holds for hall"));
  savePicture("alternatives");
  ASSERT_NO_FATAL_FAILURE(clickOn(part("alternative_0")));
  EXPECT_TRUE(isDone(AlignResult::SUCCESS));
  EXPECT_TRUE(comesTrue([this] { return !shows("outcome_card"); }));
  EXPECT_EQ(candidateState("(quiet hall)"), Candidate::NOT_WANTED);
}

TEST_F(PanelInRviz, cancelEndsTheTask) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(lightLamps()));
  ASSERT_NO_FATAL_FAILURE(clickOn(part("cancel")));
  EXPECT_TRUE(isDone(AlignResult::CANCELED));
  EXPECT_TRUE(comesTrue([this] { return !shows("question_card"); }));
  EXPECT_TRUE(comesTrue([this] { return !part("cancel")->isEnabled(); }));
}

TEST_F(PanelInRviz, aRefusalIsShownWithItsReason) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  ASSERT_NO_FATAL_FAILURE(clickOn(part("no")));
  ASSERT_TRUE(isDone(AlignResult::SUCCESS));
  // Nothing is under way any more, so that nothing can be volunteered.
  ASSERT_TRUE(comesTrue([this] { return rowWith("candidates", "(room hall)") >= 0; }));
  ASSERT_TRUE(comesTrue([this] { return part<QTabWidget>("tabs")->currentIndex() == 2; }));
  ASSERT_NO_FATAL_FAILURE(openTab(0));
  clickCell("candidates", rowWith("candidates", "(room hall)"), kPhraseColumn, kRightButton);
  ASSERT_NO_FATAL_FAILURE(choose("It matters to me"));
  EXPECT_TRUE(comesTrue([this] { return textOf("notice") == "No alignment is under way"; }))
      << textOf("notice").toStdString();
  EXPECT_TRUE(shows("notice"));
  savePicture("refusal");
}

TEST_F(PanelInRviz, theAlignerDiesAndComesBack) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  ASSERT_NO_FATAL_FAILURE(killAligner());
  EXPECT_TRUE(comesTrue([this] { return textOf("status").contains("is not there"); }));
  EXPECT_FALSE(shows("question_card"));
  EXPECT_FALSE(part("cancel")->isEnabled());
  savePicture("gone");
  ASSERT_NO_FATAL_FAILURE(startAligner());
  EXPECT_TRUE(comesTrue([this] { return textOf("status") == "Waiting for a task"; }));
  EXPECT_FALSE(shows("question_card"));
  ASSERT_NO_FATAL_FAILURE(sendAndAwaitQuestion(sweepHall()));
  ASSERT_NO_FATAL_FAILURE(clickOn(part("no")));
  EXPECT_TRUE(isDone(AlignResult::SUCCESS));
}

// As another panel or display of the same rviz may.
TEST_F(PanelInRviz, aTopicHeardAsAnotherTypeIsSaidAndTheNextAlignerIsHeard) {
  const boost::function<void(const std_msgs::String::ConstPtr&)> hear =
      [](const std_msgs::String::ConstPtr& /*text*/) {};
  const ros::Subscriber other = node_.subscribe<std_msgs::String>("/odd/plan", 1, hear);
  ASSERT_NO_FATAL_FAILURE(startAligner());
  ASSERT_NO_FATAL_FAILURE(startRviz(configFor({"/odd", "/goal_alignment"})));
  EXPECT_TRUE(comesTrue([this] { return textOf("notice").contains("/odd/plan"); }));
  EXPECT_TRUE(shows("notice"));
  savePicture("other_type");
  send(sweepHall());
  EXPECT_TRUE(asks("matter", 1));
}

TEST_F(PanelInRviz, eachPanelSpeaksWithItsOwnRobot) {
  ASSERT_NO_FATAL_FAILURE(begin({"/a/goal_alignment", "/b/goal_alignment"}));
  send(sweepHall(), "a");
  send(sweepHall(), "b");
  ASSERT_TRUE(asks("matter", 0));
  ASSERT_TRUE(asks("matter", 1));
  savePicture("two");
  ASSERT_NO_FATAL_FAILURE(clickOn(part("no", 1)));
  EXPECT_TRUE(becomes("(quiet hall)", Candidate::NOT_WANTED, "b"));
  EXPECT_TRUE(shows("question_card", 0));
  EXPECT_EQ(candidateState("(quiet hall)", "a"), Candidate::ASKED);
  ASSERT_NO_FATAL_FAILURE(clickOn(part("yes", 0)));
  EXPECT_TRUE(becomes("(quiet hall)", Candidate::WANTED, "a"));
  EXPECT_EQ(candidateState("(quiet hall)", "b"), Candidate::NOT_WANTED);
}

}  // namespace
}  // namespace goal_alignment::test
