// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

/// Good PDDL beyond what we treat: refused with its name and place, never misread.
struct Refused {
  std::string text;
  std::string message;  ///< after `x.pddl:line:column: not supported yet: `
  std::string position;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.text;
}

std::string expected(const std::string& file, const Refused& refused) {
  return file + ":" + refused.position + ": not supported yet: " + refused.message;
}

class RefusedInAction : public testing::TestWithParam<Refused> {};

TEST_P(RefusedInAction, IsNamedWithItsPlace) {
  const std::string domain = "(define (domain d)\n(:action go\n" + GetParam().text + "))";
  EXPECT_EQ(samples::domainError<UnsupportedError>(domain), expected("d.pddl", GetParam()));
}

const std::string kInPrecondition = ", at the precondition of action 'go'";
const std::string kInEffect = ", at the effect of action 'go'";

INSTANTIATE_TEST_SUITE_P(
    Preconditions, RefusedInAction,
    testing::Values(
        Refused{":precondition (preference a (p))", "'preference' (a soft goal)" + kInPrecondition,
                "3:16"},
        Refused{":precondition (>= (fuel ?x) 3)", "'>=' (a numeric condition)" + kInPrecondition,
                "3:16"},
        Refused{":precondition (< 3 (fuel ?x))", "'<' (a numeric condition)" + kInPrecondition,
                "3:16"},
        Refused{":precondition (= (fuel ?x) 3)",
                "'=' over functions (a numeric or object fluent)" + kInPrecondition, "3:16"},
        Refused{":precondition (or (p) (forall (?x) (> (fuel ?x) 3)))",
                "'>' (a numeric condition)" + kInPrecondition, "3:37"},
        Refused{":vars (?x)", "':vars' (variables beside parameters), at action 'go'", "3:1"}));

INSTANTIATE_TEST_SUITE_P(
    Effects, RefusedInAction,
    testing::Values(
        Refused{":effect (when (p) (increase (total-cost) 1))",
                "a cost inside of 'forall' or 'when'" + kInEffect, "3:20"},
        Refused{":effect (forall (?x) (assign (fuel ?x) 1))",
                "'assign' (a numeric effect)" + kInEffect, "3:23"},
        Refused{":effect (decrease (fuel) 1)", "'decrease' (a numeric effect)" + kInEffect, "3:10"},
        Refused{":effect (assign (fuel) 1)", "'assign' (a numeric effect)" + kInEffect, "3:10"},
        Refused{":effect (scale-up (fuel) 1)", "'scale-up' (a numeric effect)" + kInEffect, "3:10"},
        Refused{":effect (oneof (p) (q))", "'oneof' (a nondeterministic effect)" + kInEffect,
                "3:10"},
        Refused{":effect (increase (fuel ?x) 1)",
                "'increase' of 'fuel' (a numeric fluent)" + kInEffect, "3:20"},
        Refused{":effect (increase (total-cost) 2.5)", "fractional action cost '2.5'" + kInEffect,
                "3:32"},
        Refused{":effect (increase (total-cost) (+ 1 2))",
                "arithmetic in an action cost" + kInEffect, "3:33"},
        Refused{":effect (increase (total-cost) (total-cost))",
                "'total-cost' as an action cost" + kInEffect, "3:33"},
        Refused{":effect (increase (total-cost) total-cost)",
                "'total-cost' as an action cost" + kInEffect, "3:32"},
        Refused{":effect (increase fuel 1)", "'increase' of 'fuel' (a numeric fluent)" + kInEffect,
                "3:19"}));

const std::string kInAction = ", at action 'go'";

INSTANTIATE_TEST_SUITE_P(
    Keywords, RefusedInAction,
    testing::Values(Refused{":Observe (p)", "':observe' (sensing)" + kInAction, "3:1"},
                    Refused{":parameters (?x) :duration (= ?duration 3)",
                            "':duration' (a durative action)" + kInAction, "3:18"},
                    Refused{":expansion (series)",
                            "':expansion' (hierarchical planning)" + kInAction, "3:1"},
                    Refused{":agent ?a", "':agent' (several agents)" + kInAction, "3:1"}));

TEST(RefusedInAction, WhatGrowsWithItsNestingIsBounded) {
  std::string effect = "(p)";
  for (int i = 0; i < 11; ++i)
    effect = "(when (q) " + effect + ")";
  EXPECT_EQ(samples::domainError<UnsupportedError>("(define (domain d) (:action go :effect " +
                                                   effect + "))"),
            "d.pddl:1:141: not supported yet: 'forall' and 'when' nested deeper than 10, at the "
            "effect of action 'go'");
  std::string costs;
  for (int i = 0; i < 101; ++i)
    costs += "(increase (total-cost) 1)";
  EXPECT_EQ(samples::domainError<UnsupportedError>("(define (domain d) (:action go :effect (and " +
                                                   costs + ")))"),
            "d.pddl:1:2546: not supported yet: more than 100 costs of one action, at the effect of "
            "action 'go'");
  std::string types = "either";
  for (int i = 0; i < 101; ++i)
    types += " t";
  EXPECT_EQ(samples::domainError<UnsupportedError>("(define (domain d) (:constants a - (" + types +
                                                   ")))"),
            "d.pddl:1:37: not supported yet: 'either' of more than 100 types, at :constants");
}

class RefusedInDomain : public testing::TestWithParam<Refused> {};

TEST_P(RefusedInDomain, IsNamedWithItsPlace) {
  const std::string domain = "(define (domain d)\n" + GetParam().text + ")";
  EXPECT_EQ(samples::domainError<UnsupportedError>(domain), expected("d.pddl", GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Sections, RefusedInDomain,
    testing::Values(
        Refused{"(:durative-action a)", "':durative-action', at domain 'd'", "2:2"},
        Refused{"(:derived (p) (q))", "':derived', at domain 'd'", "2:2"},
        Refused{"(:Axiom a)", "':axiom', at domain 'd'", "2:2"},
        Refused{"(:constraints (and))", "':constraints', at domain 'd'", "2:2"},
        Refused{"(:process a)", "':process', at domain 'd'", "2:2"},
        Refused{"(:event a)", "':event', at domain 'd'", "2:2"},
        Refused{"(:task t :parameters ())", "':task' (hierarchical planning), at domain 'd'",
                "2:2"},
        Refused{"(:METHOD m)", "':method' (hierarchical planning), at domain 'd'", "2:2"},
        Refused{"( ; calls\n:modules m)", "':modules' (calls to modules), at domain 'd'", "3:1"},
        Refused{"(:stream s :inputs (?x))", "':stream' (PDDLStream), at domain 'd'", "2:2"},
        Refused{"(:sensor s)", "':sensor' (sensing), at domain 'd'", "2:2"},
        Refused{"(:types a - (either b c))", "'either' (a union of types) as a parent, at :types",
                "2:14"},
        Refused{"(:functions (loc ?x) - place)",
                "a function to 'place' (an object fluent), at :functions", "2:24"}));

class RefusedInProblem : public testing::TestWithParam<Refused> {};

TEST_P(RefusedInProblem, IsNamedWithItsPlace) {
  const std::string problem = "(define (problem p) (:domain d)\n" + GetParam().text + ")";
  EXPECT_EQ(samples::problemError<UnsupportedError>(problem), expected("p.pddl", GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Sections, RefusedInProblem,
    testing::Values(
        Refused{"(:goal (preference a (p)))", "'preference' (a soft goal), at :goal", "2:9"},
        Refused{"(:goal (> (f) 1))", "'>' (a numeric condition), at :goal", "2:9"},
        Refused{"(:init (at 5 (p)))", "a timed initial literal, at :init", "2:9"},
        Refused{"(:init (AT 5.5 (not (p))))", "a timed initial literal, at :init", "2:9"},
        Refused{"(:init (= (loc a) b))", "a function to an object (an object fluent), at :init",
                "2:9"},
        Refused{"(:init (= (f a) 2.5))", "fractional action cost '2.5', at :init", "2:17"},
        Refused{"(:init (and (p)))", "'and' (list the facts themselves), at :init", "2:9"},
        Refused{"(:init (oneof (p) (q)))", "'oneof' (a nondeterministic effect), at :init", "2:9"},
        Refused{"(:metric maximize (total-cost))", "'maximize', at :metric", "2:10"},
        Refused{"(:metric minimize (total-time))", "minimising 'total-time', at :metric", "2:20"},
        Refused{"(:metric minimize total-time)", "minimising 'total-time', at :metric", "2:19"},
        Refused{"(:METRIC MINIMIZE\r\n\tTotal-Time)", "minimising 'Total-Time', at :metric", "3:2"},
        Refused{"(:metric maximize total-time)", "'maximize', at :metric", "2:10"},
        Refused{"(:init (= a b))", "a function to an object (an object fluent), at :init", "2:9"},
        Refused{"(:htn :ordered-subtasks (t))", "':htn' (hierarchical planning), at problem 'p'",
                "2:2"},
        Refused{"(:belief (p))", "':belief' (sensing), at problem 'p'", "2:2"},
        Refused{"(:metric minimize (+ (total-cost) 1))", "minimising '+', at :metric", "2:20"},
        Refused{"(:constraints (and))", "':constraints', at problem 'p'", "2:2"},
        Refused{"(:length (:serial 5))", "':length', at problem 'p'", "2:2"}));

}  // namespace
}  // namespace goal_alignment::pddl
