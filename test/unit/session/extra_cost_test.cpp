// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/extra_cost.h"

/// What it costs to keep things that nobody asked for.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::code;
using samples::literals;
using samples::talk;
using samples::think;
using samples::wanting;

/// The robot serves where it stands; the lamp that the person expects to be off by then stands five
/// steps away, and the person believes that it can be switched off from anywhere.
Input lamp() {
  const std::string predicates =
      "(define (domain lamp) (:predicates (served) (off) (at ?p) (path ?p ?q))"
      "(:action go :parameters (?p ?q) :precondition (and (at ?p) (path ?p ?q))"
      "  :effect (and (at ?q) (not (at ?p))))"
      "(:action serve :parameters () :effect (served))";
  Input input;
  input.robot_domain = {"robot_domain.pddl",
                        predicates +
                            "(:action switch-off :parameters () :precondition (at p5)"
                            " :effect (off)))"};
  input.human_domain = {"human_domain.pddl",
                        predicates + "(:action switch-off :parameters () :effect (off)))"};
  for (pddl::Source* domain : {&input.robot_domain, &input.human_domain})
    domain->text.insert(domain->text.find("(:predicates"), "(:constants p0 p1 p2 p3 p4 p5)");
  std::string paths;
  for (int i = 0; i < 5; ++i) {
    const std::string p = "p" + std::to_string(i);
    const std::string q = "p" + std::to_string(i + 1);
    paths.append("(path ").append(p).append(" ").append(q).append(")");
    paths.append("(path ").append(q).append(" ").append(p).append(")");
  }
  input.robot_problem = {"problem.pddl", "(define (problem one) (:domain lamp) (:init (at p0)" +
                                             paths + ") (:goal (served)))"};
  input.human_problem = input.robot_problem;
  input.human_plan = {{"serve", {}}, {"switch-off", {}}};
  return input;
}

Session overTheLamp(double most) {
  Options options;
  options.max_extra_cost = most;
  Session session(options);
  session.begin(lamp());
  think(session);
  return session;
}

TEST(ExtraCost, IsReported) {
  Session session = overTheLamp(Options{}.max_extra_cost);
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(session.outcome().plan.cost, 12);  // there and back, for (at p0) is expected, too
  EXPECT_EQ(session.outcome().plan.extra_cost, 11);
}

TEST(ExtraCost, WhatCostsTooMuchIsAskedAbout) {
  Session session = overTheLamp(3);
  ASSERT_EQ(session.state(), State::AwaitingAnswer);
  EXPECT_EQ(session.question()->fluents, literals({"(off)"}));
  EXPECT_EQ(session.question()->reasons.front().extra_cost, 6);
  EXPECT_TRUE(session.question()->reasons.front().conflict.empty());
  session.answer(literals({"(off)"}), AnswerKind::No, "me");
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(session.outcome().plan.steps, (std::vector<GroundName>{{"serve", {}}}));
  EXPECT_EQ(session.outcome().plan.extra_cost, 0);
  EXPECT_EQ(session.outcome().plan.not_wanted, literals({"(off)"}));
}

TEST(ExtraCost, AYesMakesTheRestCheaperInComparison) {
  Session session = overTheLamp(3);
  session.answer(literals({"(off)"}), AnswerKind::Yes, "me");
  ASSERT_EQ(think(session), State::AwaitingAnswer);  // the way back is five steps long
  EXPECT_EQ(session.question()->fluents, literals({"(at p0)"}));
  EXPECT_EQ(session.question()->reasons.front().extra_cost, 5);
  session.answer(literals({"(at p0)"}), AnswerKind::No, "me");
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(session.outcome().plan.cost, 7);
  EXPECT_EQ(session.outcome().plan.extra_cost, 0);
}

TEST(ExtraCost, ABoundThatSufficesAsksNothing) {
  Session session = overTheLamp(11);
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(session.outcome().plan.cost, 12);
}

// All of it can be had, and yet there is something to choose.
TEST(ExtraCost, WhatCostsTooMuchCanBeGivenUp) {
  for (const OutcomeCode end :
       {OutcomeCode::Declined, OutcomeCode::UnsureBlocks, OutcomeCode::QuestionLimit}) {
    Options options;
    options.max_extra_cost = 3;
    options.unsure_policy = UnsurePolicy::Abort;
    if (end == OutcomeCode::QuestionLimit) options.max_questions = 0;
    Session session(options);
    session.begin(lamp());
    if (think(session) == State::AwaitingAnswer) {
      const bool declines = end == OutcomeCode::Declined;
      session.answer(literals({"(off)"}), declines ? AnswerKind::Decline : AnswerKind::Unsure,
                     "me");
    }
    ASSERT_EQ(session.outcome().code, end) << session.outcome().message;
    ASSERT_EQ(session.outcome().alternatives.size(), 1U);
    EXPECT_EQ(session.outcome().alternatives.front().given_up, literals({"(off)"}));
    session.resume({});
    const bool unsure = end == OutcomeCode::UnsureBlocks;
    EXPECT_TRUE((unsure ? session.revise(literals({"(off)"}), AnswerKind::No, "me")
                        : session.answer(literals({"(off)"}), AnswerKind::No, "me"))
                    .accepted);
    EXPECT_EQ(think(session), State::Done);
    EXPECT_EQ(code(session), 1);
    EXPECT_EQ(session.outcome().plan.cost, 1);
  }
}

RC_GTEST_PROP(ExtraCost, WhatIsKeptUnaskedIsCheapEnough, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Options chosen = samples::anyOptions(random);
  chosen.max_extra_cost = static_cast<double>(random.below(3));
  Session session(chosen);
  session.begin(hagl.input);
  const std::vector<Literal> asked = talk(session, samples::honest(hagl));
  RC_ASSERT(std::set<Literal>(asked.begin(), asked.end()).size() == asked.size());
  RC_ASSERT(code(session) == samples::expectedCode(hagl));
  RC_PRE(code(session) == 1);
  const FinalPlan& plan = session.outcome().plan;
  const std::vector<Literal> goal(hagl.true_goal.begin(), hagl.true_goal.end());
  RC_ASSERT(!validation::fault(hagl.robot, plan.steps, goal).has_value());
  const oracles::LiftedSpace space(hagl.robot, 10'000);
  const auto least = space.cheapest(plan.guaranteed);
  RC_ASSERT(least.has_value());
  for (const Literal& fluent : plan.kept_unasked) {
    std::vector<Literal> with = plan.guaranteed;
    with.push_back(fluent);
    RC_ASSERT(static_cast<double>(*space.cheapest(with) - *least) <= chosen.max_extra_cost);
  }
  RC_ASSERT(plan.extra_cost <= plan.cost - *least);
  RC_ASSERT(plan.extra_cost >= 0);
}

TEST(ExtraCost, IsNoMatterWhereAnyIsLetPass) {
  Options options;
  EXPECT_FALSE(costsMatter(options));
  options.max_extra_cost = 0;
  EXPECT_TRUE(costsMatter(options));
}

TEST(ExtraCost, OfAPlanIsWhatHoldsAtItsEnd) {
  samples::AnalysedDesk at;
  const auto wanted = at.setOf({"(held a)"});
  const achievability::Check check = at.analysis.robot().check(wanted, at.budget.limits());
  ASSERT_EQ(check.verdict, achievability::Verdict::Achievable);
  const auto held = trueAtEnd(at.analysis, check.plan);
  EXPECT_TRUE(wanted.is_subset_of(held));
  EXPECT_FALSE(held.intersects(at.setOf({"(free)", "(down a)", "(held b)"})));
}

}  // namespace
}  // namespace goal_alignment::session
