// SPDX-License-Identifier: BSD-3-Clause
// What is told of a precondition that is false: ground literals, whatever the formula is.
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::validation {
namespace {

// The literals that step (a) lacks in the initial state.
std::string missing(const std::string& precondition) {
  const pddl::Model model = pddl::readModel(
      {"d.pddl",
       "(define (domain d) (:requirements :adl) (:types room door)"
       " (:predicates (open ?d - door) (leads ?d - door ?r - room) (lit ?r - room) (on) (off))"
       " (:action a :parameters () :precondition " +
           precondition +
           " :effect (on))"
           " (:action b :parameters (?d - door ?r - room)"
           "  :effect (and (open ?d) (lit ?r) (off))))"},
      {"p.pddl",
       "(define (problem p) (:domain d) (:objects hall den - room front back - door)"
       " (:init (leads front hall) (leads back den) (open back) (lit den)) (:goal (on)))"});
  const Execution execution = execute(model, {GroundName{"a", {}}});
  EXPECT_TRUE(execution.violation.has_value()) << precondition;
  std::string text;
  if (!execution.violation) return text;
  for (const Literal& literal : execution.violation->missing)
    text += (text.empty() ? "" : " ") + literal.text();
  return text;
}

TEST(Evaluation, AFalseLiteralIsMissing) {
  EXPECT_EQ(missing("(on)"), "(on)");
  EXPECT_EQ(missing("(and (lit den) (not (open back)))"), "(not (open back))");
}

TEST(Evaluation, OfADisjunctionEachPartIsMissing) {
  EXPECT_EQ(missing("(or (on) (and (lit den) (off)))"), "(off) (on)");
}

TEST(Evaluation, OfAllThatWhichFailsIsMissing) {
  EXPECT_EQ(missing("(forall (?d - door) (open ?d))"), "(open front)");
  EXPECT_EQ(missing("(forall (?d - door) (imply (leads ?d hall) (open ?d)))"), "(open front)")
      << "that the door leads there can't be changed";
}

TEST(Evaluation, OfSomeEachOneIsMissing) {
  EXPECT_EQ(missing("(exists (?r - room) (and (lit ?r) (not (lit ?r))))"),
            "(not (lit den)) (lit hall)");
  EXPECT_EQ(missing("(exists (?d - door) (and (leads ?d hall) (open ?d)))"), "(open front)")
      << "the other door does not lead there";
}

TEST(Evaluation, WhatCantBeChangedIsToldWhereThereIsNothingElse) {
  EXPECT_EQ(missing("(or (leads front den) (leads back hall))"),
            "(leads back hall) (leads front den)");
  EXPECT_EQ(missing("(or (= hall den) (leads front den))"), "(leads front den)");
  EXPECT_EQ(missing("(exists (?r - room) (not (= ?r ?r)))"), "");
}

}  // namespace
}  // namespace goal_alignment::validation
