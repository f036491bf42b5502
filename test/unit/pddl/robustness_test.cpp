// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <functional>
#include <string>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using samples::kTeaDomain;
using samples::kTeaProblem;

const std::string kLiftDomain = R"((define (domain lift)
  (:types person floor - object vip - person)
  (:predicates (in ?x - (either vip person)) (up ?f - floor) (open))
  (:action go :parameters (?f - floor)
    :precondition (or (open) (imply (up ?f) (exists (?p - vip) (not (and (in ?p) (= ?p ?p))))))
    :effect (and (open) (forall (?p - person) (when (not (in ?p)) (and (in ?p) (not (up ?f))))))))
)";
const std::string kLiftProblem = R"((define (problem two) (:domain lift)
  (:objects a - floor b - (either vip person)) (:init (up a))
  (:goal (and (open) (forall (?p - person ?f - floor) (or (in ?p) (not (up ?f))))))))";

/// True where the text is read or refused; any other exception goes through and fails the test.
bool isReadOrRefused(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& refused) {
    return refused.position().line > 0;
  }
  return true;
}

/// The text after some bytes were deleted, doubled or replaced, the favourites of PDDL first.
std::string mutated(std::string text) {
  const int slips = *rc::gen::inRange(1, 6);
  for (int i = 0; i < slips && !text.empty(); ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const auto length = *rc::gen::inRange<std::size_t>(1, 12);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text[at] = *rc::gen::elementOf(std::string("()?-:;=. \n5aA"));
        break;
      default:
        text[at] = *rc::gen::arbitrary<char>();
    }
  }
  return text;
}

RC_GTEST_PROP(Robustness, MutatedTasksAreReadOrRefused, ()) {
  const bool in_domain = *rc::gen::arbitrary<bool>();
  const Source domain{"d.pddl", in_domain ? mutated(kTeaDomain) : kTeaDomain};
  const Source problem{"p.pddl", in_domain ? kTeaProblem : mutated(kTeaProblem)};
  RC_ASSERT(isReadOrRefused([&] { readModel(domain, problem); }));
  faults(domain, problem);
}

RC_GTEST_PROP(Robustness, MutatedFormulasAreReadOrRefused, ()) {
  const Source domain{"d.pddl", mutated(kLiftDomain)};
  const Source problem{"p.pddl", mutated(kLiftProblem)};
  RC_ASSERT(isReadOrRefused([&] {
    const Model model = readModel(domain, problem);
    model.goalConditionText();
  }));
  faults(domain, problem);
}

RC_GTEST_PROP(Robustness, CutTasksAreRefused, ()) {
  const auto end = *rc::gen::inRange<std::size_t>(0, kTeaDomain.size() - 1);
  const Source cut{"d.pddl", kTeaDomain.substr(0, end)};
  RC_ASSERT_THROWS_AS(parseDomain(cut), InputError);
}

RC_GTEST_PROP(Robustness, AnyBytesAreReadOrRefused, (const std::string& bytes)) {
  const Source source{"x", bytes};
  RC_ASSERT(isReadOrRefused([&] { parseDomain(source); }));
  RC_ASSERT(isReadOrRefused([&] { parseProblem(source); }));
  RC_ASSERT(isReadOrRefused([&] { parsePlan(source); }));
  RC_ASSERT(isReadOrRefused([&] { parseLiterals(source); }));
}

RC_GTEST_PROP(Robustness, MutatedPlansAreReadOrRefused, ()) {
  const Source plan{"x", mutated("; cost 3\n0: (heat Pot)\n(pour pot mug) [1]\n(move a b c)\n")};
  RC_ASSERT(isReadOrRefused([&] { parsePlan(plan); }));
  RC_ASSERT(isReadOrRefused([&] { parseLiterals(plan); }));
}

std::string repeated(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i)
    text += part;
  return text;
}

TEST(Robustness, AMillionParenthesesAreAnErrorAndNoOverflow) {
  const std::string deep = repeated("(and ", 1'000'000);
  EXPECT_EQ(
      samples::domainError<SyntaxError>("(define (domain d) (:action a\n:precondition " + deep),
      "d.pddl:2:5005: parentheses are nested deeper than 1000");
  EXPECT_EQ(samples::domainError<SyntaxError>("(define (domain d) (:action a\n:effect " + deep)
                .substr(0, 9),
            "d.pddl:2:");
  EXPECT_EQ(samples::domainError<SyntaxError>(repeated("(", 1'000'000)),
            "d.pddl:1:2: expected 'define', found '('");
}

TEST(Robustness, DeepButBoundedNestingIsRead) {
  const std::string text = "(define (domain d) (:action a :precondition " + repeated("(and ", 990) +
                           "(p)" + repeated(")", 990) + "))";
  EXPECT_EQ(parseDomain({"d", text}).actions.at(0).precondition.size(), 1U);
}

TEST(Robustness, DeepFormulasAreLinkedAndTold) {
  const std::string domain = "(define (domain d) (:predicates (p)))";
  const std::string deep = repeated("(not (or (p) ", 490) + "(p)" + repeated("))", 490);
  const Model model =
      readModel({"d", domain}, {"p", "(define (problem p) (:domain d) (:goal " + deep + "))"});
  EXPECT_FALSE(model.goal.empty());
}

TEST(Robustness, LongNamesMakeShortMessages) {
  const std::string message =
      samples::domainError<SyntaxError>("(define (domain d) " + std::string(1'000'000, 'x') + ")");
  EXPECT_EQ(message.substr(0, 46), "d.pddl:1:20: expected '(' or ')', found 'xxxxx");
  EXPECT_LT(message.size(), 200U);
}

TEST(Robustness, LongerNamesThanAnybodyWritesAreRefused) {
  const auto declaring = [](std::size_t length) {
    return "(define (domain d) (:constants " + std::string(length, 'x') + "))";
  };
  EXPECT_EQ(parseDomain({"d", declaring(1000)}).constants.size(), 1U);
  EXPECT_EQ(samples::domainError<SyntaxError>(declaring(1001)),
            "d.pddl:1:32: '" + std::string(60, 'x') + "…' is longer than 1000 characters");
}

TEST(Robustness, DeepHierarchiesOfTypesAreRefused) {
  const auto hierarchy = [](int depth) {
    std::string types;
    for (int i = 0; i < depth; ++i)
      types += "t" + std::to_string(i) + " - t" + std::to_string(i + 1) + "\n";
    return "(define (domain tea) (:types " + types + "))";
  };
  const std::string problem = "(define (problem p) (:domain tea) (:goal ()))";
  EXPECT_EQ(samples::linkError(hierarchy(99), problem), "no error");
  EXPECT_EQ(samples::linkError(hierarchy(100), problem),
            "d.pddl:1:30: types are nested deeper than 100");
}

// Ten megabytes take a fraction of a second; anything quadratic would take hours.
TEST(Robustness, MegabytesAreReadInLinearTime) {
  std::string objects;
  std::string facts;
  for (int i = 0; i < 300'000; ++i) {
    const std::string name = "some-object-" + std::to_string(i);
    objects += name + " ";
    facts += "(p " + name + ")\n";
  }
  const Source domain{"d", "(define (domain d) (:predicates (p ?x)))"};
  const Source problem{"p", "(define (problem p) (:domain d) (:objects " + objects + ") (:init " +
                                facts + ") (:goal ()))"};
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(readModel(domain, problem).init.size(), 300'000U);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace goal_alignment::pddl
