// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/explanation.h"

#include <gtest/gtest.h>

#include <thread>

namespace goal_alignment::aligner {
namespace {

using session::CandidateState;

Literal literal(const std::string& text) {
  return Literal::parse(text);
}

std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  for (const std::string& text : texts)
    result.push_back(literal(text));
  return result;
}

// (g) is asked for; (a) and (b) can't be had together, nor (c) at all; (d) was answered; (e) is
// free; (a) is the open question.
ExplanationContext sample() {
  ExplanationContext explained;
  auto& snapshot = explained.snapshot;
  snapshot.state = session::State::AwaitingAnswer;
  snapshot.specified = literals({"(g)"});
  const auto add = [&](const std::string& text, CandidateState state, const std::string& by = "") {
    session::CandidateView view;
    view.fluent = literal(text);
    view.state = state;
    view.answered_by = by;
    snapshot.candidates.push_back(view);
  };
  add("(a)", CandidateState::Asked);
  add("(b)", CandidateState::Open);
  add("(c)", CandidateState::Open);
  add("(d)", CandidateState::NotWanted, "Ann");
  add("(e)", CandidateState::Open);
  snapshot.conflicts = {{literals({"(a)", "(b)"}), true, true, true},
                        {literals({"(c)"}), false, false, true},
                        {literals({"(a)", "(d)"}), true, true, false}};
  explained.open_question = literals({"(a)"});
  return explained;
}

bool says(const Explain::Response& response, const std::string& text) {
  return response.text.find(text) != std::string::npos;
}

TEST(ExplainWhy, theOutcomeWhereTheGoalCannotBeHad) {
  ExplanationContext ended = sample();
  ended.open_question.clear();
  ended.snapshot.state = session::State::Done;
  ended.outcome = session::OutcomeCode::GoalUnsolvable;
  ended.human_plan_break = "step 2 (climb) can't be done";
  const auto response = explainWhy(ended, {});
  EXPECT_TRUE(response.known);
  EXPECT_EQ(response.text,
            "I can't do what you asked for: \"g\" holds. That is certain. Your plan does not work "
            "for me: step 2 (climb) can't be done.");
}

TEST(ExplainWhy, theOpenQuestionWhereNothingIsNamed) {
  const auto response = explainWhy(sample(), {});
  EXPECT_TRUE(response.known);
  ASSERT_EQ(response.conflicts.size(), 1U) << "the one that an answer no has settled is no reason";
  EXPECT_EQ(response.conflicts[0].fluents.size(), 2U);
  EXPECT_TRUE(says(response, "I can't have both")) << response.text;
}

TEST(ExplainWhy, theOpenQuestionIsExplainedAsItWasAsked) {
  ExplanationContext explained = sample();
  explained.open_why = "Because. If not, I can do all the rest.";
  explained.open_conflicts = {literals({"(b)", "(a)"}), {}};
  const auto response = explainWhy(explained, {});
  EXPECT_TRUE(response.known);
  EXPECT_EQ(response.text, explained.open_why);
  ASSERT_EQ(response.conflicts.size(), 1U);
  EXPECT_EQ(response.conflicts[0].fluents.size(), 2U);
}

TEST(ExplainWhy, aSuspicionIsNotAProof) {
  const auto response = explainWhy(sample(), literals({"(c)"}));
  EXPECT_TRUE(response.known);
  EXPECT_TRUE(says(response, "could not find out")) << response.text;
  ASSERT_EQ(response.conflicts.size(), 1U);
  EXPECT_FALSE(response.conflicts[0].proven);
}

TEST(ExplainWhy, eachKindOfFluentHasItsAnswer) {
  EXPECT_TRUE(says(explainWhy(sample(), literals({"(g)"})), "You asked"));
  EXPECT_TRUE(says(explainWhy(sample(), literals({"(z)"})), "don't expect"));
  const auto answered = explainWhy(sample(), literals({"(d)"}));
  EXPECT_TRUE(says(answered, "answered no by Ann")) << answered.text;
  EXPECT_EQ(answered.conflicts.size(), 1U) << "what the answer has settled";
}

TEST(ExplainWhy, whatMayStillComeUpIsNotKnown) {
  ExplanationContext explained = sample();
  EXPECT_FALSE(explainWhy(explained, literals({"(e)"})).known);
  EXPECT_FALSE(explainWhy(explained, literals({"(a)", "(e)"})).known);
  explained.snapshot.conflicts_complete = true;
  const auto response = explainWhy(explained, literals({"(e)"}));
  EXPECT_TRUE(response.known);
  EXPECT_TRUE(says(response, "can't change")) << response.text;
}

TEST(ExplainWhy, oneConflictIsToldOnce) {
  EXPECT_EQ(explainWhy(sample(), literals({"(a)", "(b)"})).conflicts.size(), 1U);
}

TEST(ExplainWhy, whatIsAssumedNobodyHasSaid) {
  ExplanationContext explained = sample();
  explained.snapshot.candidates[3].assumed = true;
  explained.snapshot.candidates[3].answered_by.clear();
  const auto response = explainWhy(explained, literals({"(d)"}));
  EXPECT_TRUE(response.known);
  EXPECT_TRUE(says(response, "Nobody is asked")) << response.text;
  EXPECT_TRUE(says(response, "I take it that it doesn't")) << response.text;
}

TEST(ExplainWhy, theOutcomeWhereNoQuestionIsOpen) {
  ExplanationContext explained = sample();
  explained.open_question.clear();
  EXPECT_FALSE(explainWhy(explained, {}).known) << "it is still thinking";
  explained.snapshot.state = session::State::Done;
  EXPECT_TRUE(explainWhy(explained, {}).known);
  EXPECT_TRUE(explainWhy(explained, {}).conflicts.empty());
  explained.outcome_conflict = literals({"(b)", "(a)"});
  EXPECT_EQ(explainWhy(explained, {}).conflicts.size(), 1U);
}

TEST(ExplainWhyNot, eachKindOfFluentHasItsAnswer) {
  ExplanationContext explained = sample();
  explained.snapshot.candidates[1].conflicts = {0};
  const std::vector<std::pair<std::string, std::string>> table = {
      {"(g)", "you asked for it"},
      {"(z)", "you don't expect it"},
      {"(a)", "I do ask whether it matters"},
      {"(b)", "I have not asked yet"},
      {"(d)", "answered no by Ann"},
  };
  for (const auto& [fluent, part] : table) {
    const auto response = explainWhyNot(explained, literals({fluent}));
    EXPECT_TRUE(response.known) << fluent;
    EXPECT_TRUE(says(response, part)) << response.text;
  }
  const auto later = explainWhyNot(explained, literals({"(b)"}));
  ASSERT_EQ(later.conflicts.size(), 1U);
  EXPECT_EQ(later.conflicts[0].fluents.size(), 2U);
}

TEST(ExplainWhyNot, whatNeedNotBeAskedIsKnownWhenAllConflictsAre) {
  ExplanationContext explained = sample();
  EXPECT_FALSE(explainWhyNot(explained, literals({"(e)"})).known);
  explained.snapshot.conflicts_complete = true;
  EXPECT_TRUE(says(explainWhyNot(explained, literals({"(e)"})), "can't change what I do"));
  explained.snapshot.candidates[0].state = CandidateState::Settled;
  explained.snapshot.conflicts[0].live = false;
  const auto settled = explainWhyNot(explained, literals({"(a)"}));
  EXPECT_TRUE(says(settled, "what stood against it")) << settled.text;
  EXPECT_EQ(settled.conflicts.size(), 2U);
}

TEST(ExplainWhyNot, afterTheOutcomeThePlanIsSpokenOf) {
  ExplanationContext explained = sample();
  explained.snapshot.state = session::State::Done;
  explained.snapshot.candidates[4].state = CandidateState::Settled;
  explained.outcome = session::OutcomeCode::Success;
  EXPECT_TRUE(says(explainWhyNot(explained, literals({"(e)"})), "My plan keeps it so."));
  EXPECT_FALSE(says(explainWhyNot(explained, literals({"(d)"})), "keeps"));
  explained.outcome = session::OutcomeCode::QuestionLimit;
  explained.snapshot.candidates[1].conflicts = {0};
  const auto unasked = explainWhyNot(explained, literals({"(b)"}));
  EXPECT_TRUE(says(unasked, "ended before I asked")) << unasked.text;
}

TEST(ExplainWhyNot, whyTheHumanPlanIsNotFollowed) {
  ExplanationContext explained = sample();
  EXPECT_TRUE(says(explainWhyNot(explained, {}), "no plan to follow"));
  explained.human_plan = {GroundName::parse("(sweep hall)")};
  EXPECT_FALSE(explainWhyNot(explained, {}).known) << "the robot's model is not known yet";
  explained.snapshot.robot_known = true;
  EXPECT_TRUE(says(explainWhyNot(explained, {}), "Each step of your plan works for me."));
  explained.outcome = session::OutcomeCode::Success;
  explained.plan = explained.human_plan;
  EXPECT_EQ(explainWhyNot(explained, {}).text, "I do follow your plan.");
  explained.plan.push_back(GroundName::parse("(sweep den)"));
  EXPECT_TRUE(says(explainWhyNot(explained, {}), "another one, of 2 steps"));
  explained.human_plan_break = "step 1 fails";
  const auto broken = explainWhyNot(explained, {});
  EXPECT_EQ(broken.text, "Your plan does not work for me: step 1 fails.");
  EXPECT_TRUE(broken.known);
  EXPECT_FALSE(explainWhyNot(ExplanationContext{}, {}).known);
}

}  // namespace
}  // namespace goal_alignment::aligner
