// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/message_conversion.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"

namespace goal_alignment::ros_common {
namespace {

using session::CandidateState;
using session::OutcomeCode;

Fluent fluent(const std::string& name, const std::vector<std::string>& args, bool negated = false) {
  Fluent message;
  message.name = name;
  message.args = args;
  message.negated = negated;
  return message;
}

TEST(MessageConversion, fluentsBecomeLiteralsInLowerCase) {
  const Literal literal = toLiteral(fluent("On", {"A", "b"}, true));
  EXPECT_EQ(literal.text(), "(not (on a b))");
}

TEST(MessageConversion, literalsComeBackAsTheyWere) {
  const Literal literal = Literal::parse("(not (on a b))");
  const Fluent message = toMessage(literal, {});
  EXPECT_EQ(toLiteral(message), literal);
  EXPECT_FALSE(message.text.empty());
}

TEST(MessageConversion, whatIsNoNameIsRefusedWithItsField) {
  for (const char* name :
       {"", " ", "a b", "(on", "on)", "a;b", "caf\xe9", "a\n", "a–b", "a\u00a0b"}) {
    EXPECT_THROW(toLiteral(fluent(name, {})), std::invalid_argument) << name;
    EXPECT_THROW(toLiteral(fluent("on", {name})), std::invalid_argument) << name;
  }
  try {
    toLiterals({fluent("on", {"a"}), fluent("on", {""})}, "task.goal");
    FAIL() << "an empty argument was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "task.goal[1]: argument 0 of 'on' is empty");
  }
}

TEST(MessageConversion, namesMayHaveLettersBeyondAscii) {
  EXPECT_EQ(toLiteral(fluent("Liegt-In", {"Küche", "お茶"})).text(), "(liegt-in küche お茶)");
}

TEST(MessageConversion, planStepsBecomeActions) {
  PlanStep step;
  step.name = "STACK";
  step.args = {"a", "B"};
  EXPECT_EQ(toActions({step}, "task.plan").at(0).text(), "(stack a b)");
  step.name.clear();
  EXPECT_THROW(toAction(step), std::invalid_argument);
}

TEST(MessageConversion, textsBecomeLiterals) {
  EXPECT_EQ(toLiterals({"(on A b)", "(not (on a b))"}).at(1).negated, true);
  EXPECT_THROW(toLiterals(std::vector<std::string>{"(on a"}), std::invalid_argument);
}

TEST(MessageConversion, candidatesKeepTheirStateAndTime) {
  session::CandidateView view;
  view.fluent = Literal::parse("(on a b)");
  view.state = CandidateState::Wanted;
  view.probability = 0.25;
  view.achievable = false;
  view.conflicts = {3, 70000};
  view.answered_by = "Ann";
  const Candidate message = toMessage(view, {}, {{view.fluent, ros::Time(5, 6)}});
  EXPECT_EQ(int{message.state}, Candidate::WANTED);
  EXPECT_EQ(message.probability, 0.25);
  EXPECT_FALSE(message.achievable);
  EXPECT_EQ(message.conflicts, (std::vector<std::uint16_t>{3, 65535}));
  EXPECT_EQ(message.answered_by, "Ann");
  EXPECT_EQ(message.answered_at, ros::Time(5, 6));
}

TEST(MessageConversion, numbersOfTheCoreAreThoseOfTheMessages) {
  EXPECT_EQ(int{Candidate::SPECIFIED}, static_cast<int>(CandidateState::Specified));
  EXPECT_EQ(int{Candidate::OPEN}, static_cast<int>(CandidateState::Open));
  EXPECT_EQ(int{Candidate::ASKED}, static_cast<int>(CandidateState::Asked));
  EXPECT_EQ(int{Candidate::WANTED}, static_cast<int>(CandidateState::Wanted));
  EXPECT_EQ(int{Candidate::NOT_WANTED}, static_cast<int>(CandidateState::NotWanted));
  EXPECT_EQ(int{Candidate::UNSURE}, static_cast<int>(CandidateState::Unsure));
  EXPECT_EQ(int{Candidate::SETTLED}, static_cast<int>(CandidateState::Settled));

  const std::vector<std::pair<int, OutcomeCode>> outcomes = {
      {AlignResult::NONE, OutcomeCode::None},
      {AlignResult::SUCCESS, OutcomeCode::Success},
      {AlignResult::CANCELED, OutcomeCode::Canceled},
      {AlignResult::GOAL_UNSOLVABLE, OutcomeCode::GoalUnsolvable},
      {AlignResult::EXPECTATION_UNACHIEVABLE, OutcomeCode::ExpectationUnachievable},
      {AlignResult::TIME_LIMIT, OutcomeCode::TimeLimit},
      {AlignResult::MEMORY_LIMIT, OutcomeCode::MemoryLimit},
      {AlignResult::BUDGET_LIMIT, OutcomeCode::BudgetLimit},
      {AlignResult::NO_ANSWER, OutcomeCode::NoAnswer},
      {AlignResult::DECLINED, OutcomeCode::Declined},
      {AlignResult::QUESTION_LIMIT, OutcomeCode::QuestionLimit},
      {AlignResult::CONTRADICTION, OutcomeCode::Contradiction},
      {AlignResult::UNSURE_BLOCKS, OutcomeCode::UnsureBlocks},
      {AlignResult::BUSY, OutcomeCode::Busy},
      {AlignResult::INVALID_MODEL, OutcomeCode::InvalidModel},
      {AlignResult::HUMAN_PLAN_INVALID, OutcomeCode::HumanPlanInvalid},
      {AlignResult::GOAL_NOT_EXPECTED, OutcomeCode::GoalNotExpected},
      {AlignResult::STATE_UNKNOWN, OutcomeCode::StateUnknown},
      {AlignResult::INTERNAL, OutcomeCode::Internal}};
  for (const auto& [number, code] : outcomes)
    EXPECT_EQ(number, static_cast<int>(code));
}

TEST(MessageConversion, outcomesBecomeResults) {
  session::Outcome outcome;
  outcome.code = OutcomeCode::HumanPlanInvalid;
  outcome.message = "why";
  outcome.failing_step = 2;
  outcome.conflict = {Literal::parse("(a)")};
  outcome.alternatives = {{{Literal::parse("(b)")}, 0.5}};
  const AlignResult result = toMessage(outcome, {});
  EXPECT_EQ(result.outcome, AlignResult::HUMAN_PLAN_INVALID);
  EXPECT_EQ(result.message, "why");
  EXPECT_EQ(result.failing_step, 2);
  EXPECT_EQ(result.conflict.at(0).name, "a");
  EXPECT_EQ(result.alternatives.at(0).given_up.at(0).name, "b");
  EXPECT_EQ(result.alternatives.at(0).probability, 0.5);
}

session::QuestionView questionAbout(const std::vector<std::string>& texts) {
  session::QuestionView view;
  for (const std::string& text : texts) {
    const Literal fluent = Literal::parse(text);
    view.fluents.push_back(fluent);
    view.reasons.push_back({{fluent, Literal::parse("(on b a)")}, true, 0});
    view.probabilities.push_back(0.5);
  }
  view.asked = 2;
  view.max_remaining = 3;
  view.bound_is_provisional = true;
  return view;
}

TEST(MessageConversion, questionsCarryTheirReason) {
  const Question question = toMessage(questionAbout({"(on a b)"}), {});
  EXPECT_EQ(question.fluents.size(), 1U);
  EXPECT_EQ(question.conflict.size(), 2U);
  EXPECT_FALSE(question.text.empty());
  EXPECT_NE(question.why.find("I can't have both"), std::string::npos) << question.why;
  EXPECT_EQ(question.asked, 2U);
  EXPECT_EQ(question.max_remaining, 3U);
  EXPECT_TRUE(question.bound_is_provisional);
}

TEST(MessageConversion, questionsSayWhatFollows) {
  session::QuestionView view = questionAbout({"(on a b)"});
  view.bound_is_provisional = false;
  view.if_no.ending = questions::AnswerEffect::Ending::Plan;
  view.if_yes.ending = questions::AnswerEffect::Ending::NoPlan;
  const std::string why = toMessage(view, {}).why;
  EXPECT_NE(why.find("If not, I can do all the rest."), std::string::npos) << why;
  EXPECT_NE(why.find("If it does, I can't do everything you want."), std::string::npos) << why;
}

TEST(MessageConversion, aGroupHasAProbabilityForEachAndTheFirstConflict) {
  session::QuestionView view = questionAbout({"(p)", "(q)"});
  view.reasons[0] = {{}, true, 4};
  const Question question = toMessage(view, {});
  ASSERT_EQ(question.fluents.size(), 2U);
  EXPECT_EQ(question.probabilities.size(), 2U);
  EXPECT_EQ(question.conflict.at(0).name, "q") << "the first reason that is one";
  EXPECT_NE(question.text.find("Which of these"), std::string::npos) << question.text;
}

TEST(MessageConversion, whatIsAssumedWasAnsweredByNobody) {
  session::CandidateView view;
  view.fluent = Literal::parse("(p)");
  view.state = CandidateState::Unsure;
  view.assumed = true;
  EXPECT_EQ(toMessage(view, {}, {}).answered_by, "assumed");
}

// The sums of rosplan_dispatch_msgs of ROSPlan's repository: executors compare nothing else.
TEST(MessageConversion, dispatchMessagesAreFieldIdenticalToThoseOfRosplan) {
  EXPECT_STREQ(ros::message_traits::md5sum<ActionDispatch>(), "9d0c5c1ebcb48d5f31ecc568f41bc70b");
  EXPECT_STREQ(ros::message_traits::md5sum<ActionFeedback>(), "6efa68a42d1d10ddf52cc6b649317f64");
}

}  // namespace
}  // namespace goal_alignment::ros_common
