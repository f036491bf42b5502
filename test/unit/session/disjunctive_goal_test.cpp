// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/validation/execution.h"
#include "samples.h"

/// A goal that leaves a choice: what else can be had depends on the alternative taken.
namespace goal_alignment::session {
namespace {

using samples::code;
using samples::literals;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

// The way forks and leads back nowhere; in the human's eyes one is in all places at once.
std::string forkDomain(const std::string& leave_start) {
  return R"((define (domain fork)
  (:requirements :disjunctive-preconditions)
  (:predicates (start) (left) (right) (lamp) (fire) (fed))
  (:action feed :parameters () :precondition (start) :effect (fed))
  (:action go-left :parameters () :precondition (start) :effect (and (left))" +
         leave_start + R"())
  (:action go-right :parameters () :precondition (start) :effect (and (right))" +
         leave_start + R"())
  (:action light :parameters () :precondition (left) :effect (lamp))
  (:action burn :parameters () :precondition (right) :effect (fire))))";
}

std::string forkProblem(const std::string& init) {
  return "(define (problem one) (:domain fork) (:init " + init +
         ") (:goal (and (fed) (or (left) (right)))))";
}

Input fork(const std::string& robot_init = "(start)") {
  Input input;
  input.robot_domain = {"robot_domain.pddl", forkDomain("(not (start))")};
  input.robot_problem = {"robot_problem.pddl", forkProblem(robot_init)};
  input.human_domain = {"human_domain.pddl", forkDomain("")};
  input.human_problem = {"human_problem.pddl", forkProblem("(start)")};
  for (const char* step : {"(feed)", "(go-left)", "(light)", "(go-right)", "(burn)"})
    input.human_plan.push_back(GroundName::parse(step));
  return input;
}

const std::vector<std::string> kCandidates{"(fire)", "(lamp)", "(left)", "(right)", "(start)"};

bool within(const std::vector<std::string>& wanted, const std::set<std::string>& possible) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const std::string& fluent) { return possible.count(fluent) > 0; });
}

TEST(DisjunctiveGoal, ItsConditionIsShown) {
  Session session{Options{}};
  session.begin(fork());
  session.step();  // the models are read
  EXPECT_EQ(session.snapshot().specified, samples::literals({"(fed)"}));
  EXPECT_EQ(session.snapshot().condition, "(or (left) (right))");
}

TEST(DisjunctiveGoal, ConflictsHoldForEveryAlternative) {
  Session session(options("auto"));
  session.begin(fork());
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  const Snapshot snapshot = session.snapshot();
  EXPECT_TRUE(snapshot.conflicts_complete);
  EXPECT_EQ(snapshot.specified, literals({"(fed)"}));
  std::set<std::vector<Literal>> conflicts;
  for (const ConflictView& conflict : snapshot.conflicts) {
    EXPECT_TRUE(conflict.proven);
    conflicts.insert(conflict.fluents);
  }
  // Staying would be fine, but for the alternatives.
  const std::set<std::vector<Literal>> expected{
      literals({"(start)"}), literals({"(left)", "(right)"}), literals({"(fire)", "(left)"}),
      literals({"(lamp)", "(right)"}), literals({"(fire)", "(lamp)"})};
  EXPECT_EQ(conflicts, expected);
}

TEST(DisjunctiveGoal, EveryPersonGetsTheRightOutcome) {
  const pddl::Model robot = pddl::readModel({"robot_domain.pddl", forkDomain("(not (start))")},
                                            {"robot_problem.pddl", forkProblem("(start)")});
  for (unsigned bits = 0; bits < 1U << kCandidates.size(); ++bits) {
    std::vector<std::string> wanted;
    for (std::size_t i = 0; i < kCandidates.size(); ++i) {
      if ((bits >> i & 1U) != 0) wanted.push_back(kCandidates[i]);
    }
    const bool possible =
        within(wanted, {"(left)", "(lamp)"}) || within(wanted, {"(right)", "(fire)"});
    for (const char* policy : {"auto", "optimal", "ratio", "paper", "ask-all"}) {
      for (const ConflictMode mode : {ConflictMode::Full, ConflictMode::Lazy}) {
        Session session(options(policy, mode));
        session.begin(fork());
        talk(session, wanting(wanted));
        ASSERT_EQ(code(session), possible ? 1 : 52)
            << policy << ", " << bits << ": " << session.outcome().message;
        if (!possible) continue;
        // This looks at the alternatives as well.
        EXPECT_EQ(validation::fault(robot, session.outcome().plan.steps, literals(wanted)),
                  std::nullopt);
      }
    }
  }
}

TEST(DisjunctiveGoal, AGoalGivenByHandTakesItsPlace) {
  Input input = fork();
  input.goal = literals({"(fed)"});
  Session session(options("auto"));
  session.begin(std::move(input));
  talk(session, wanting({"(start)"}));
  EXPECT_EQ(code(session), 1) << session.outcome().message;
}

TEST(DisjunctiveGoal, IsNamedWhereItCanNotBeHad) {
  Session session(options("auto"));
  session.begin(fork("(fed)"));
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 51);
  EXPECT_EQ(session.outcome().message,
            "no plan can achieve what was asked for: (fed), (or (left) (right))");
}

}  // namespace
}  // namespace goal_alignment::session
