// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "goal_alignment/validation/execution.h"
#include "samples.h"

namespace goal_alignment::session {
namespace {

using samples::atFirstQuestion;
using samples::desk;
using samples::literal;
using samples::literals;
using samples::talk;
using samples::think;
using samples::wanting;

struct DeskPerson {
  bool wants(const Literal& fluent) const { return fluent == literal("(held a)"); }
};

// The worked example of session.h, to the letter but for the last line.
TEST(Session, TheWorkedExampleOfItsHeaderRuns) {
  const DeskPerson person;
  const Input input = desk();
  std::vector<GroundName> executed;
  const auto execute = [&](const std::vector<GroundName>& steps) { executed = steps; };

  Session session{Options{}};
  session.begin(input);
  while (session.step() != State::Done) {
    if (session.state() == State::AwaitingAnswer) {
      for (const Literal& fluent : session.question()->fluents) {
        session.answer({fluent}, person.wants(fluent) ? AnswerKind::Yes : AnswerKind::No, "me");
      }
    }
  }
  execute(session.outcome().plan.steps);  // if outcome().code is Success

  EXPECT_EQ(session.outcome().code, OutcomeCode::Success);
  EXPECT_EQ(validation::fault(goal_alignment::samples::deskRobot(), executed,
                              literals({"(down b)", "(held a)"})),
            std::nullopt);
}

TEST(Session, GoesThroughItsStates) {
  Session session{Options{}};
  EXPECT_EQ(session.state(), State::Idle);
  EXPECT_EQ(session.step(), State::Idle);
  session.begin(desk());
  EXPECT_EQ(session.state(), State::Analysing);
  EXPECT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_TRUE(session.question().has_value());
  EXPECT_EQ(session.step(), State::AwaitingAnswer);  // nothing to do, nothing changes
  talk(session, wanting({}));
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_FALSE(session.question().has_value());
  EXPECT_EQ(session.step(), State::Done);
}

// The conflicts of the desk, worked out in unit/alignment/samples.h: {held b}, {held a, free},
// {held a, down a}. The single one is asked first.
TEST(Session, AsksAboutTheDeskWithReasons) {
  Session session = atFirstQuestion();
  const QuestionView first = *session.question();
  EXPECT_EQ(first.fluents, literals({"(held b)"}));
  EXPECT_EQ(first.reasons.front().conflict, literals({"(held b)"}));
  EXPECT_TRUE(first.reasons.front().proven);
  EXPECT_EQ(first.asked, 0U);
  EXPECT_EQ(first.max_remaining, 4U);  // (down a) (free) (held a) (held b)
  EXPECT_FALSE(first.bound_is_provisional);
  const std::vector<Literal> asked = talk(session, wanting({"(held a)"}));
  EXPECT_EQ(asked.size(), 4U);
  EXPECT_EQ(session.outcome().plan.steps, (std::vector<GroundName>{{"take", {"a"}}}));
  EXPECT_EQ(session.outcome().plan.not_wanted, literals({"(down a)", "(free)", "(held b)"}));
  EXPECT_EQ(session.outcome().plan.guaranteed, literals({"(down b)", "(held a)"}));
  EXPECT_EQ(session.outcome().plan.kept_unasked, literals({"(down c)", "(red a)"}));
}

TEST(Session, NoPlanNamesTheConflictAndWhatCouldBeHadInstead) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)", "(free)"}));
  const Outcome& outcome = session.outcome();
  EXPECT_EQ(outcome.code, OutcomeCode::ExpectationUnachievable);
  EXPECT_EQ(outcome.conflict, literals({"(free)", "(held a)"}));
  EXPECT_NE(outcome.message.find("(held A)"), std::string::npos) << outcome.message;
  ASSERT_EQ(outcome.alternatives.size(), 2U);
  EXPECT_EQ(outcome.alternatives[0].given_up.size(), 1U);
  EXPECT_GE(outcome.alternatives[0].probability, outcome.alternatives[1].probability);
}

TEST(Session, AnUnsolvableSpecifiedGoalNeedsNoQuestion) {
  Input input = desk();
  input.goal = literals({"(held a)", "(held b)"});
  Session session{Options{}};
  session.begin(input);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(session.outcome().code, OutcomeCode::GoalUnsolvable);
  EXPECT_TRUE(session.questions().empty());
}

TEST(Session, PrefersTheHumansOwnPlanWhereItGivesAll) {
  Input input = desk();
  // A detour that a planner would not take.
  input.human_plan = {{"take", {"c"}}, {"put", {"c"}}, {"take", {"c"}}, {"put", {"c"}}};
  input.human_domain.text = input.robot_domain.text;
  Session session{Options{}};
  session.begin(input);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(session.outcome().code, OutcomeCode::Success);
  EXPECT_EQ(session.outcome().plan.steps, input.human_plan);
  EXPECT_EQ(session.outcome().plan.cost, 4);
  EXPECT_EQ(session.humanPlanInRobotModel(), "");
}

TEST(Session, TellsWhereTheHumansPlanBreaks) {
  const Session session = atFirstQuestion();
  EXPECT_NE(session.humanPlanInRobotModel().find("(take B)"), std::string::npos);
}

TEST(Session, SpellsNamesAsTheirWritersDid) {
  const Session session = atFirstQuestion();
  EXPECT_EQ(session.spelling(literal("(held a)")), "(held A)");
  EXPECT_EQ(session.spelling(literal("(not (held a))")), "(not (held A))");
  EXPECT_EQ(session.spelling(GroundName{"take", {"b"}}), "(take B)");
  EXPECT_EQ(session.parameterNames("take"), std::vector<std::string>{"x"});
  EXPECT_TRUE(session.parameterNames("fly").empty());
}

TEST(Session, RefusesOptionsOutOfTheirRange) {
  const auto refused = [](const auto& change) {
    Options options;
    change(options);
    EXPECT_THROW(Session{options}, std::invalid_argument);
  };
  refused([](Options& o) { o.policy = "pepper"; });
  refused([](Options& o) { o.belief.beta = -1; });
  refused([](Options& o) { o.belief.beta = std::numeric_limits<double>::infinity(); });
  refused([](Options& o) { o.belief.beta = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Options& o) { o.belief.kappa = 0; });
  refused([](Options& o) { o.belief.kappa = std::numeric_limits<double>::infinity(); });
  refused([](Options& o) { o.belief.flat = 1.5; });
  refused([](Options& o) { o.time_limit = 0; });
  refused([](Options& o) { o.memory_limit = 0; });
  refused([](Options& o) { o.max_questions = -2; });
}

TEST(Session, BeginForgetsWhatWasBefore) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)", "(free)"}));
  session.begin(desk());
  EXPECT_TRUE(session.questions().empty());
  EXPECT_EQ(session.outcome().code, OutcomeCode::None);
  EXPECT_EQ(talk(session, wanting({"(held a)"})).size(), 4U);
  EXPECT_EQ(session.outcome().code, OutcomeCode::Success);
}

TEST(Session, CanBeMoved) {
  Session session = atFirstQuestion();
  Session moved = std::move(session);
  talk(moved, wanting({"(held a)"}));
  EXPECT_EQ(moved.outcome().code, OutcomeCode::Success);
}

TEST(Session, CountsItsTimeByPhases) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)"}));
  const Statistics& times = session.statistics();
  for (const double part :
       {times.parse, times.ground, times.belief, times.conflicts, times.questions, times.plan}) {
    EXPECT_GE(part, 0);
  }
  EXPECT_NEAR(
      times.parse + times.ground + times.belief + times.conflicts + times.questions + times.plan,
      times.total, 1e-6);
  EXPECT_GT(times.planner_calls, 0U);
}

TEST(Session, OptimalPlansSayThatTheyAre) {
  Options options;
  options.plan = PlanMode::Optimal;
  Session session = atFirstQuestion(options);
  talk(session, wanting({"(held a)"}));
  EXPECT_TRUE(session.outcome().plan.optimal);
  EXPECT_EQ(session.outcome().plan.cost, 1);
}

}  // namespace
}  // namespace goal_alignment::session
