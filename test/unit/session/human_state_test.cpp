// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "samples.h"

/// What is so for the person by now, whatever their problem file says.
namespace goal_alignment::session {
namespace {

using samples::literal;
using samples::think;

constexpr const char* kHumanDomain =
    "(define (domain d) (:predicates (at ?x ?r) (clean ?r) (seen ?x ?r)) "
    "(:action sweep :parameters (?r) :effect (clean ?r)) "
    "(:action show :parameters (?x ?r) :precondition (seen ?x ?r) :effect (clean ?r)) "
    "(:action fetch :parameters (?x ?r) :precondition (at ?x ?r) :effect (not (at ?x ?r))))";
// Other arguments of one predicate, another predicate, an object more.
constexpr const char* kRobotDomain =
    "(define (domain d) (:predicates (at ?x ?r) (clean ?r) (seen ?x) (charged)) "
    "(:action sweep :parameters (?r) :effect (clean ?r)))";
constexpr const char* kHumanProblem =
    "(define (problem p) (:domain d) (:objects toy hall attic) (:init (at toy attic)) "
    "(:goal (clean hall)))";
constexpr const char* kRobotProblem =
    "(define (problem p) (:domain d) (:objects toy hall attic crate) (:init (at toy hall)) "
    "(:goal (clean hall)))";

// What the person expects at the end of their plan.
std::vector<std::string> expectedWith(const std::vector<HumanFact>& facts,
                                      const std::string& first_step = "(sweep attic)") {
  Input input;
  input.robot_domain = {"rd", kRobotDomain};
  input.robot_problem = {"rp", kRobotProblem};
  input.human_domain = {"hd", kHumanDomain};
  input.human_problem = {"hp", kHumanProblem};
  input.human_plan = {GroundName::parse(first_step), GroundName::parse("(sweep hall)")};
  input.human_facts = facts;
  Session session{Options{}};
  session.begin(input);
  think(session);
  std::vector<std::string> texts;
  for (const CandidateView& candidate : session.snapshot().candidates)
    texts.push_back(candidate.fluent.text());
  std::sort(texts.begin(), texts.end());
  return texts;
}

HumanFact reported(const std::string& text) {
  return {literal(text), true};
}

HumanFact told(const std::string& text) {
  return {literal(text), false};
}

using Texts = std::vector<std::string>;

TEST(HumanState, IsThatOfTheFileWithoutNews) {
  EXPECT_EQ(expectedWith({}), (Texts{"(at toy attic)", "(clean attic)"}));
}

TEST(HumanState, FollowsWhatWasReported) {
  EXPECT_EQ(expectedWith({reported("(not (at toy attic))"), reported("(at toy hall)")}),
            (Texts{"(at toy hall)", "(clean attic)"}));
  EXPECT_EQ(expectedWith({reported("(at toy attic)"), reported("(clean attic)")}),
            (Texts{"(at toy attic)", "(clean attic)"}));
}

TEST(HumanState, HasNothingThatItsModelCannotHave) {
  EXPECT_EQ(expectedWith({reported("(at crate hall)"), reported("(charged)"), told("(charged)"),
                          told("(at toy cellar)"), reported("(at toy)")}),
            (Texts{"(at toy attic)", "(clean attic)"}));
}

TEST(HumanState, FollowsPredicatesOfOneNameAndArityAlone) {
  EXPECT_TRUE(expectedWith({reported("(seen toy hall)")}, "(show toy hall)").empty())
      << "the plan does not run";
  EXPECT_FALSE(expectedWith({told("(seen toy hall)")}, "(show toy hall)").empty());
}

TEST(HumanState, OfOneAtomTheLastWordCounts) {
  EXPECT_EQ(expectedWith({told("(at toy hall)"), told("(not (at toy hall))"),
                          reported("(not (at toy attic))"), told("(AT toy attic)")}),
            expectedWith({}));
}

// A button that always sends the same plan.
TEST(HumanState, IsWhatThePlanTakesForGranted) {
  const std::vector<HumanFact> moved = {reported("(not (at toy attic))"), reported("(at toy hall)"),
                                        reported("(clean attic)")};
  EXPECT_EQ(expectedWith(moved, "(fetch toy hall)"), Texts{"(clean attic)"});
  EXPECT_EQ(expectedWith(moved, "(fetch toy attic)"), Texts{"(clean attic)"})
      << "of that predicate the file counts, of others what was reported";
  EXPECT_TRUE(expectedWith({told("(not (at toy attic))")}, "(fetch toy attic)").empty())
      << "who was told so has an invalid plan";
  EXPECT_TRUE(expectedWith(moved, "(fetch toy cellar)").empty());
}

}  // namespace
}  // namespace goal_alignment::session
