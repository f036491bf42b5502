// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/explanation.h"

#include <gtest/gtest.h>

#include <thread>

namespace goal_alignment::ros_interface {
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
Explained sample() {
  Explained explained;
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

TEST(ExplainWhy, theOpenQuestionWhereNothingIsNamed) {
  const auto response = explainWhy(sample(), {});
  EXPECT_TRUE(response.known);
  ASSERT_EQ(response.conflicts.size(), 1U) << "the one that an answer no has settled is no reason";
  EXPECT_EQ(response.conflicts[0].fluents.size(), 2U);
  EXPECT_TRUE(says(response, "I can't have both")) << response.text;
}

TEST(ExplainWhy, aSuspicionIsNotAProof) {
  const auto response = explainWhy(sample(), literals({"(c)"}));
  EXPECT_TRUE(response.known);
  EXPECT_TRUE(says(response, "could not make sure")) << response.text;
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
  Explained explained = sample();
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

TEST(ExplainWhy, theOutcomeWhereNoQuestionIsOpen) {
  Explained explained = sample();
  explained.open_question.clear();
  EXPECT_FALSE(explainWhy(explained, {}).known) << "it is still thinking";
  explained.snapshot.state = session::State::Done;
  EXPECT_TRUE(explainWhy(explained, {}).known);
  EXPECT_TRUE(explainWhy(explained, {}).conflicts.empty());
  explained.outcome_conflict = literals({"(b)", "(a)"});
  EXPECT_EQ(explainWhy(explained, {}).conflicts.size(), 1U);
}

Explain::Request why(const std::vector<std::string>& fluents, int kind = Explain::Request::WHY) {
  Explain::Request request;
  request.kind = static_cast<std::uint8_t>(kind);
  request.fluents = fluents;
  return request;
}

constexpr std::chrono::duration<double> kNone{0};
constexpr std::chrono::duration<double> kLong{60};

TEST(Explainer, refusesWhatItCannotRead) {
  Explainer explainer;
  explainer.show(sample());
  EXPECT_FALSE(explainer.explain(why({"(((("}), kLong).known);
  EXPECT_TRUE(says(explainer.explain(why({}, 9), kLong), "expected WHY=0"));
  EXPECT_TRUE(
      says(explainer.explain(why({}, Explain::Request::WHAT_IF), kLong), "not supported yet"));
}

TEST(Explainer, doesNotWaitForATask) {
  EXPECT_FALSE(Explainer().explain(why({}), kLong).known);
}

TEST(Explainer, waitsForTheReasonToComeUp) {
  Explainer explainer;
  Explained explained = sample();
  explainer.show(explained);
  EXPECT_FALSE(explainer.explain(why({"(e)"}), kNone).known);
  std::thread solver([&] {
    explainer.show(explained);  // nothing new
    explained.snapshot.conflicts_complete = true;
    explainer.show(explained);
  });
  EXPECT_TRUE(explainer.explain(why({"(E)"}), kLong).known);
  solver.join();
}

}  // namespace
}  // namespace goal_alignment::ros_interface
