// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/demo_narrator.h"

#include <gtest/gtest.h>

#include <sstream>

namespace goal_alignment::nodes {
namespace {

Fluent fluent(const std::string& text) {
  Fluent message;
  message.name = text;
  message.text = text;
  return message;
}

Question questionAbout(std::uint32_t id, const std::string& name) {
  Question question;
  question.session_id = "s";
  question.question_id = id;
  question.text = "what about " + name + "?";
  question.why = "because of " + name;
  question.fluents = {fluent(name)};
  return question;
}

AlignmentState stateWith(const std::vector<std::pair<std::string, int>>& candidates) {
  AlignmentState state;
  state.session_id = "s";
  state.human_plan_break = "step 1 fails";
  for (const auto& [name, value] : candidates) {
    Candidate candidate;
    candidate.fluent = fluent(name);
    candidate.state = static_cast<std::uint8_t>(value);
    state.candidates.push_back(candidate);
  }
  return state;
}

class Story : public testing::Test {
 protected:
  // In this order, whatever else stands between.
  void expectInOrder(const std::vector<std::string>& parts) const {
    std::size_t position = 0;
    for (const std::string& part : parts) {
      position = out_.str().find(part, position);
      ASSERT_NE(position, std::string::npos) << part << " is not next in\n" << out_.str();
      position += part.size();
    }
  }

  std::ostringstream out_;
  DemoNarrator story_{out_, {}};
};

TEST_F(Story, keepsItsOrderWhenMessagesOvertakeEachOther) {
  story_.hear(questionAbout(1, "a"));
  EXPECT_EQ(out_.str(), "") << "where the plan breaks is not known yet";
  story_.hear(questionAbout(2, "b"));
  story_.hear(stateWith({{"a", Candidate::ASKED}, {"b", Candidate::OPEN}}));
  EXPECT_EQ(out_.str().find("about b"), std::string::npos) << "a is not answered yet";
  story_.hear(stateWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}}));
  expectInOrder({"breaks for the robot: step 1 fails", "what about a?", "because of a",
                 "answers: yes", "what about b?", "answers: no"});
}

TEST_F(Story, tellsAnAnswerToEachOfAGroup) {
  Question group = questionAbout(1, "a");
  group.fluents.push_back(fluent("b"));
  story_.hear(group);
  story_.hear(stateWith({{"a", Candidate::WANTED}, {"b", Candidate::ASKED}}));
  EXPECT_EQ(out_.str().find("answers"), std::string::npos) << "b is not answered yet";
  story_.hear(stateWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}}));
  expectInOrder({"what about a?", "answers: a: yes", "answers: b: no"});
}

TEST_F(Story, goesOnAfterAQuestionThatWasTakenBack) {
  story_.hear(questionAbout(1, "a"));
  story_.hear(stateWith({{"a", Candidate::ASKED}, {"b", Candidate::OPEN}}));
  story_.hear(questionAbout(2, "b"));
  EXPECT_EQ(out_.str().find("about b"), std::string::npos) << "a may still be answered";
  story_.hear(stateWith({{"a", Candidate::SETTLED}, {"b", Candidate::ASKED}}));
  story_.hear(stateWith({{"a", Candidate::SETTLED}, {"b", Candidate::NOT_WANTED}}));
  expectInOrder({"what about a?", "No answer is needed any more", "what about b?", "answers: no"});
}

TEST_F(Story, tellsAQuestionThatNarrowsOrClosesOnce) {
  story_.hear(questionAbout(1, "a"));
  story_.hear(Question{});
  story_.hear(questionAbout(1, "a"));
  story_.hear(stateWith({{"a", Candidate::WANTED}}));
  EXPECT_EQ(out_.str().find("what about"), out_.str().rfind("what about")) << "told twice";
}

AlignResult resultWith(const std::vector<std::pair<std::string, int>>& candidates,
                       std::uint32_t questions) {
  AlignResult result;
  result.session_id = "s";
  result.outcome = AlignResult::SUCCESS;
  result.candidates = stateWith(candidates).candidates;
  result.questions = questions;
  return result;
}

TEST_F(Story, waitsForTheStateAndTheQuestionsOfAResult) {
  const AlignResult result =
      resultWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}}, 2);
  EXPECT_FALSE(story_.hasHeardAllOf(result)) << "no state yet";
  AlignmentState done = stateWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}});
  done.phase = AlignmentState::DONE;
  done.session_id = "another";
  story_.hear(done);
  story_.hear(questionAbout(1, "a"));
  story_.hear(questionAbout(2, "b"));
  EXPECT_FALSE(story_.hasHeardAllOf(result)) << "the state is another session's";
  done.session_id = "s";
  story_.hear(done);
  EXPECT_TRUE(story_.hasHeardAllOf(result));
  story_.hear(result);
  expectInOrder({"step 1 fails", "what about a?", "answers: yes", "what about b?", "answers: no",
                 "nothing to do"});
}

TEST_F(Story, missesAQuestionWhoseAnswerIsKnown) {
  AlignmentState done = stateWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}});
  done.phase = AlignmentState::DONE;
  story_.hear(questionAbout(1, "a"));
  story_.hear(done);
  // A question was taken back, and "b" is still on its way.
  EXPECT_FALSE(story_.hasHeardAllOf(
      resultWith({{"a", Candidate::WANTED}, {"b", Candidate::NOT_WANTED}}, 1)));
  EXPECT_FALSE(story_.hasHeardAllOf(resultWith({{"a", Candidate::WANTED}}, 2)));
  EXPECT_TRUE(story_.hasHeardAllOf(resultWith({{"a", Candidate::WANTED}}, 1)));
  AlignResult refused;
  EXPECT_TRUE(story_.hasHeardAllOf(refused)) << "there is no session to hear of";
}

TEST_F(Story, anotherEndIsAwaitedWhereTheSessionGoesOn) {
  AlignmentState done = stateWith({{"a", Candidate::WANTED}});
  done.phase = AlignmentState::DONE;
  story_.hear(questionAbout(1, "a"));
  story_.hear(done);
  const AlignResult result = resultWith({{"a", Candidate::WANTED}}, 1);
  story_.hear(result);
  story_.takeUp(AlternativeGoal{});
  EXPECT_FALSE(story_.hasHeardAllOf(resultWith({{"a", Candidate::NOT_WANTED}}, 0)));
  story_.hear(done);
  EXPECT_TRUE(story_.hasHeardAllOf(resultWith({{"a", Candidate::NOT_WANTED}}, 0)));
}

TEST_F(Story, tellsAnswersThatNobodyWasAskedFor) {
  AlignResult result = resultWith({{"a", Candidate::WANTED}, {"b", Candidate::WANTED}}, 0);
  result.candidates[1].answered_by = "assumed";
  story_.hear(result);
  expectInOrder({"has also answered: a: yes", "nothing to do"});
  EXPECT_EQ(out_.str().find("answered: b"), std::string::npos) << "nobody said so";
}

TEST_F(Story, whereADialogueShowsTheQuestionsAnswersNameWhatTheyAreTo) {
  DemoNarrator story(out_, {}, false);
  story.hear(questionAbout(1, "a"));
  story.hear(stateWith({{"a", Candidate::WANTED}}));
  expectInOrder({"answers: a: yes"});
  EXPECT_EQ(out_.str().find("what about"), std::string::npos);
}

TEST_F(Story, tellsAQuestionThatIsPutAgainOnce) {
  story_.hear(questionAbout(1, "a"));
  story_.hear(questionAbout(2, "a"));
  story_.hear(stateWith({{"a", Candidate::WANTED}}));
  expectInOrder({"what about a?", "answers: yes"});
  EXPECT_EQ(out_.str().find("what about"), out_.str().rfind("what about")) << "told twice";
}

TEST_F(Story, tellsWhatIsNotPromisedAndWhatKeepingCosts) {
  AlignResult result;
  result.session_id = "s";
  result.outcome = AlignResult::SUCCESS;
  result.plan.assumed_not_wanted = {fluent("dust")};
  result.plan.extra_cost = 2;
  result.plan.cost = 5;
  story_.hear(result);
  expectInOrder({"nobody was asked about it: dust", "\n2 of its cost of 5 is for things"});
}

TEST_F(Story, countsInSingularAndPlural) {
  AlignResult result;
  result.session_id = "s";
  result.outcome = AlignResult::SUCCESS;
  result.plan.steps.resize(1);
  result.plan.cost = 1;
  result.plan.extra_cost = 1;
  result.plan.not_wanted = {fluent("dust")};
  story_.hear(result);
  expectInOrder({"\nThe robot has a plan of 1 step.\n", "Left out: dust.\n",
                 "1 of the 1 steps is for things you didn't ask for.\n"});
  result.plan.steps.resize(20);
  result.plan.cost = 20;
  result.plan.extra_cost = 5;
  story_.hear(result);
  expectInOrder({"\nThe robot has a plan of 20 steps.\n",
                 "5 of the 20 steps are for things you didn't ask for.\n"});
}

TEST_F(Story, goesOnWithTheAlternativeThatIsTakenUp) {
  HumanTask task;
  task.person = "Ada";
  story_.begin(task);
  AlignResult no_plan;
  no_plan.session_id = "s";
  no_plan.outcome = AlignResult::EXPECTATION_UNACHIEVABLE;
  no_plan.alternatives.resize(1);
  no_plan.alternatives[0].given_up = {fluent("peace"), fluent("quiet")};
  story_.hear(no_plan);
  story_.takeUp(no_plan.alternatives[0]);
  story_.hear(questionAbout(1, "a"));
  story_.hear(stateWith({{"a", Candidate::ASKED}}));
  EXPECT_EQ(out_.str().find("answer"), std::string::npos) << "the question is open";
  AlignResult found;
  found.session_id = "s";
  found.outcome = AlignResult::SUCCESS;
  found.candidates = stateWith({{"a", Candidate::WANTED}}).candidates;
  story_.hear(found);
  expectInOrder({"There is no plan (outcome 52)",
                 "\nAda settles for everything except: peace; quiet.\n", "what about a?",
                 "answers: yes", "nothing to do"});
}

TEST_F(Story, isCompletedByTheResult) {
  story_.hear(questionAbout(1, "a"));
  AlignResult result;
  result.session_id = "s";
  result.outcome = AlignResult::SUCCESS;
  result.candidates = stateWith({{"a", Candidate::UNSURE}}).candidates;
  story_.hear(result);
  expectInOrder({"what about a?", "answers: don't know", "nothing to do"});
}

TEST_F(Story, endsWithTheGuarantee) {
  Plan plan;
  plan.plan_id = 1;
  plan.guaranteed = {fluent("tea"), fluent("peace")};
  for (const char* name : {"boil", "pour"}) {
    ActionDispatch step;
    step.name = name;
    plan.steps.push_back(step);
  }
  story_.hearStep(plan, 0);
  story_.hearStep(plan, 0);
  ExecutePlanResult result;
  result.outcome = ExecutePlanResult::SUCCESS;
  story_.hearEnd(plan, result);
  expectInOrder({"step 1 of 2: ", "step 2 of 2: ", "\nGuaranteed: tea; peace.\n"});
  EXPECT_EQ(out_.str().find("step 1"), out_.str().rfind("step 1")) << "told twice";
}

TEST_F(Story, tellsOfANewPlanAndItsStepsFromTheFirst) {
  Plan plan;
  plan.steps.resize(2);
  plan.steps[0].name = "slide";
  plan.steps[1].name = "walk";
  story_.hearStep(plan, 1);
  story_.hearTrouble("step 1 (walk) failed");
  Plan other = plan;
  other.steps.resize(1);
  story_.hearNewPlan(other);
  story_.hearStep(other, 0);
  expectInOrder({"step 2 of 2: ", "went wrong: step 1 (walk) failed", "a new plan of 1 step,",
                 "step 1 of 1: "});
}

TEST_F(Story, promisesNothingAfterAFailure) {
  ExecutePlanResult result;
  result.outcome = ExecutePlanResult::STEP_FAILED;
  result.reason = "slipped";
  story_.hearEnd(Plan{}, result);
  expectInOrder({"not carried out (outcome 81): slipped"});
  AlignResult no_plan;
  no_plan.outcome = AlignResult::EXPECTATION_UNACHIEVABLE;
  no_plan.message = "too much";
  no_plan.alternatives.resize(4);
  no_plan.alternatives[0].given_up = {fluent("quiet")};
  no_plan.alternatives[3].given_up = {fluent("peace")};
  story_.hear(no_plan);
  expectInOrder({"There is no plan (outcome 52): too much.\n", "everything except: peace"});
  EXPECT_EQ(out_.str().find("except: quiet"), std::string::npos) << "the message says it";
  EXPECT_EQ(out_.str().find("Guaranteed"), std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::nodes
