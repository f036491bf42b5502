// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/perturbation.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracles/forgettable.h"
#include "samples.h"

namespace goal_alignment::pddl {
namespace {

using oracles::Forgettable;
using samples::kTeaDomain;

Perturbation forget(const std::string& text, std::size_t preconditions, std::size_t deletes,
                    std::uint64_t seed = 1) {
  RandomSource random(seed);
  return perturb({"d.pddl", text}, preconditions, deletes, random);
}

std::string domainWith(const std::string& action) {
  return "(define (domain d) (:predicates (p) (q ?x))\n  (:action a\n" + action + "))";
}

std::string leftOf(const std::string& action, std::size_t preconditions, std::size_t deletes) {
  const std::string text = forget(domainWith(action), preconditions, deletes).text;
  const std::string frame = domainWith("");
  const std::size_t begin = frame.size() - 2;  // before the two last parentheses
  EXPECT_EQ(text.substr(0, begin), frame.substr(0, begin));
  return text.substr(begin, text.size() - begin - 2);
}

Forgettable countsOf(const std::string& text) {
  return oracles::forgettableOf(parseDomain({"d.pddl", text}));
}

// Every connective, and effects within effects.
const std::string kAdlDomain = domainWith(R"(    :parameters (?x ?y)
    :precondition (and (p) (or (q ?x) (q ?y)) ; either will do
                       (and (not (q ?x)) (forall (?z) (imply (q ?z) (p)))))
    :effect (and (not (p)) (q ?y) (when (p) (not (q ?x)))
                 (forall (?z) (and (when (q ?z) (and (p) (not (q ?z)))) (not (q ?z))))))
  (:action b :precondition (p) :effect (not (p)))");

TEST(Perturbation, TakesOutAsManyAsItIsTold) {
  for (const std::string& domain : {kTeaDomain, kAdlDomain}) {
    const Forgettable all = countsOf(domain);
    for (std::size_t preconditions = 0; preconditions <= all.preconditions; ++preconditions) {
      for (std::size_t deletes = 0; deletes <= all.deletes; ++deletes) {
        const Perturbation human = forget(domain, preconditions, deletes, preconditions);
        const Forgettable left = countsOf(human.text);
        ASSERT_EQ(left.preconditions, all.preconditions - preconditions) << human.text;
        ASSERT_EQ(left.deletes, all.deletes - deletes) << human.text;
        ASSERT_EQ(human.forgotten.size(), preconditions + deletes);
      }
    }
  }
}

TEST(Perturbation, WhatIsLeftIsADomain) {
  // One of the two must stay for ?x to be of the type that the effect needs.
  const std::string narrow =
      "(define (domain d) (:types t) (:predicates (q ?x - t) (r ?x - t) (p))\n (:action a "
      ":parameters "
      "(?x) :precondition (and (q ?x) (p) (r ?x)) :effect (and (q ?x) (not (r ?x)))))";
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::string left = forget(narrow, 2, 1, seed).text;
    EXPECT_NO_THROW(checkDomain(parseDomain({"h.pddl", left}))) << left;
  }
  EXPECT_EQ(samples::errorOf<std::invalid_argument>([&] { forget(narrow, 3, 0); }),
            "d.pddl: can't forget 3 preconditions, 2 is the most that leaves a domain");
}

TEST(Perturbation, ReadsWhatPlanningReads) {
  const std::string untyped =
      "(define (domain d)\n (:predicates (p ?x - t))\n (:action a :precondition (p k)))";
  EXPECT_EQ(samples::errorOf<SemanticError>([&] { forget(untyped, 1, 0); }),
            "d.pddl:2:23: unknown type 't'; the domain declares no types");
  // The problem may declare what the domain names.
  EXPECT_EQ(forget(domainWith(":precondition (q some-object)"), 1, 0).forgotten.size(), 1U);
}

TEST(Perturbation, NothingForgottenIsTheSameText) {
  EXPECT_EQ(forget(kAdlDomain, 0, 0).text, kAdlDomain);
}

TEST(Perturbation, EverythingCanBeForgotten) {
  const Forgettable all = countsOf(kAdlDomain);
  std::set<std::string> forgotten;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Perturbation human = forget(kAdlDomain, 1, 1, seed);
    // Where a piece stands twice, only its place in the text tells one from the other.
    forgotten.insert(human.forgotten[0] + human.text);
  }
  EXPECT_EQ(forgotten.size(), all.preconditions * all.deletes);
}

TEST(Perturbation, SaysWhatIsForgottenInTheTextsOrder) {
  const std::vector<std::string> all = {
      "precondition (at ?k Table) of Heat", "precondition (not (hot ?k)) of Heat",
      "precondition (hot ?k) of pour",      "precondition (not (full ?c)) of pour",
      "delete (not (hot ?k)) of pour",      "precondition (HandEmpty) of move",
      "precondition (at ?v ?from) of move", "precondition (not (= ?from ?to)) of move",
      "delete (not (at ?v ?from)) of move"};
  EXPECT_EQ(forget(kTeaDomain, 7, 2).forgotten, all);
}

TEST(Perturbation, TheSeedAloneDecides) {
  EXPECT_EQ(forget(kTeaDomain, 2, 1, 7).text, forget(kTeaDomain, 2, 1, 7).text);
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    texts.insert(forget(kTeaDomain, 2, 1, seed).text);
  EXPECT_GT(texts.size(), 5U);
}

TEST(Perturbation, WhatIsLeftStandsAsItStood) {
  EXPECT_EQ(leftOf("  :precondition (and\n    (p) ; free\n  )", 1, 0),
            "  :precondition (and\n ; free\n  )");
  EXPECT_EQ(leftOf("  :precondition (and\n    (p)\n    )", 1, 0), "  :precondition (and\n    )");
  EXPECT_EQ(leftOf("  :precondition (and (p)) :effect (p)", 1, 0),
            "  :precondition (and) :effect (p)");
  EXPECT_EQ(leftOf("  :effect (and (p)\r\n    (not (p))\r\n    )", 0, 1),
            "  :effect (and (p)\r\n    )");
  // A comment must not swallow what closes the list.
  EXPECT_EQ(leftOf("  :effect (and (p) ; wet\n    (not (p)))", 0, 1),
            "  :effect (and (p) ; wet\n)");
}

TEST(Perturbation, OutsideOfAConjunctionNothingStandsInItsPlace) {
  EXPECT_EQ(leftOf("  :precondition (p)\n  :effect (not (p))", 1, 1),
            "  :precondition (and)\n  :effect (and)");
  EXPECT_EQ(leftOf("  :EFFECT (AND (When (p) (NOT (p))) (forall (?x) (not (q ?x))))", 0, 2),
            "  :EFFECT (AND (When (p) (and)) (forall (?x) (and)))");
}

TEST(Perturbation, MoreThanThereIsCanNotBeForgotten) {
  const auto error = [](std::size_t preconditions, std::size_t deletes) {
    return samples::errorOf<std::invalid_argument>(
        [&] { forget(kTeaDomain, preconditions, deletes); });
  };
  EXPECT_EQ(error(8, 0), "d.pddl: can't forget 8 preconditions, there are 7");
  EXPECT_EQ(error(0, 3), "d.pddl: can't forget 3 delete effects, there are 2");
}

TEST(Perturbation, ABrokenDomainIsRefused) {
  EXPECT_THROW(forget("(define (domain d) (:action a :precondition (and (p))", 1, 0), SyntaxError);
  EXPECT_THROW(forget("", 0, 0), SyntaxError);
}

}  // namespace
}  // namespace goal_alignment::pddl
