// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/relaxed_reachability.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>

#include "goal_alignment/common/exceptions.h"
#include "oracles/lifted_space.h"
#include "oracles/random_pddl.h"
#include "oracles/seeds.h"

namespace goal_alignment::grounding {
namespace {

GroundName nameOf(const pddl::Model& model, const RelaxedReachability& relaxed,
                  const Instantiation& instantiation) {
  const Rule& rule = relaxed.rules.at(instantiation.rule);
  GroundName name{model.schemas.at(static_cast<std::size_t>(rule.schema)).name.name, {}};
  for (const pddl::ObjectId object : instantiation.arguments) {
    name.arguments.push_back(model.objects.at(static_cast<std::size_t>(object)).name.name);
  }
  return name;
}

RC_GTEST_PROP(RelaxedReachability, EqualsTheNaiveFixpoint, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSketch(random);
  const pddl::Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const RelaxedReachability relaxed = relaxedReachability(model, {});
  const oracles::RelaxedGrounding naive = oracles::groundNaively(model);

  oracles::Atoms atoms;
  for (const pddl::AtomView atom : relaxed.atoms)
    atoms.insert(model.name(atom));
  RC_ASSERT(atoms == naive.atoms);
  RC_ASSERT(atoms.size() == relaxed.atoms.size());
  std::set<GroundName> expected;
  for (const oracles::GroundAction& action : naive.actions)
    expected.insert(action.name);
  std::set<GroundName> found;
  for (const Instantiation& instantiation : relaxed.instantiations) {
    RC_ASSERT(found.insert(nameOf(model, relaxed, instantiation)).second);  // each once
  }
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(RelaxedReachability, IndexesItsAtoms, ()) {
  RandomSource random = oracles::anySource();
  const pddl::Model model = oracles::randomSketch(random).model();
  const RelaxedReachability relaxed = relaxedReachability(model, {});
  for (AtomId id = 0; id < relaxed.atoms.size(); ++id) {
    RC_ASSERT(relaxed.atoms.find(relaxed.atoms[id]) == id);
  }
  RC_ASSERT(relaxed.initial_count == model.init.size());
  for (const pddl::Atom& atom : model.init)
    RC_ASSERT(relaxed.atoms.find(atom) < relaxed.initial_count);
}

pddl::Model chain(int length) {
  std::string objects;
  std::string init;
  for (int i = 0; i < length; ++i) {
    objects += " n" + std::to_string(i);
    if (i > 0) init += " (next n" + std::to_string(i - 1) + " n" + std::to_string(i) + ")";
  }
  return pddl::readModel(
      {"chain.pddl",
       "(define (domain chain) (:predicates (at ?x) (next ?x ?y)) (:action go :parameters (?x ?y) "
       ":precondition (and (at ?x) (next ?x ?y)) :effect (and (at ?y) (not (at ?x)))))"},
      {"p.pddl", "(define (problem p) (:domain chain) (:objects" + objects + ") (:init (at n0)" +
                     init + ") (:goal (and)))"});
}

TEST(RelaxedReachability, FollowsALongChain) {
  const RelaxedReachability relaxed = relaxedReachability(chain(300), {});
  EXPECT_EQ(relaxed.instantiations.size(), 299U);
  EXPECT_EQ(relaxed.atoms.size(), 599U);
}

std::string objects(int count) {
  std::string text = "(:objects";
  for (int i = 0; i < count; ++i)
    text += " n" + std::to_string(i);
  return text + ")";
}

pddl::Model read(const std::string& domain, const std::string& problem) {
  return pddl::readModel(
      {"d.pddl", "(define (domain d) " + domain + ")"},
      {"p.pddl", "(define (problem p) (:domain d) " + problem + "(:goal (and)))"});
}

std::string atom(const std::string& predicate, int a, int b) {
  return "(" + predicate + " n" + std::to_string(a) + " n" + std::to_string(b) + ")";
}

/// (s0 ?0 ?1) … (s6 ?6 ?7): eight parameters.
const std::string kPath =
    "(s0 ?0 ?1) (s1 ?1 ?2) (s2 ?2 ?3) (s3 ?3 ?4) (s4 ?4 ?5) (s5 ?5 ?6) (s6 ?6 ?7)";
const std::string kPathPredicates =
    "(:predicates (at ?x) (s0 ?x ?y) (s1 ?x ?y) (s2 ?x ?y) (s3 ?x ?y) (s4 ?x ?y) (s5 ?x ?y)"
    " (s6 ?x ?y)";

// Ten ways on from every object but the last relation's, which leads on from one of a hundred only:
// 10^6 partial paths from each object, of which every hundredth leads on.
TEST(RelaxedReachability, ChainsOfStaticAtomsAreNotWalkedInVain) {
  std::string init = "(:init (at n0)";
  for (int relation = 0; relation < 6; ++relation) {
    for (int i = 0; i < 100; ++i) {
      for (int step = 0; step < 10; ++step)
        init += atom("s" + std::to_string(relation), i, (10 * i + step) % 100);
    }
  }
  init += "(s6 n77 n1))";
  const RelaxedReachability relaxed =
      relaxedReachability(read(kPathPredicates +
                                   ") (:action go :parameters (?0 ?1 ?2 ?3 ?4 ?5 ?6 ?7)"
                                   " :precondition (and (at ?0) " +
                                   kPath + ") :effect (at ?7))",
                               objects(100) + init),
                          {});
  // Two atoms are ever `at`; a path's last but one digits are given, which leaves 10^4 paths each.
  EXPECT_EQ(relaxed.instantiations.size(), 20'000U);
  EXPECT_LT(relaxed.match_attempts, 20 * relaxed.instantiations.size());
}

TEST(RelaxedReachability, AChainThatEndsNowhereCostsNothing) {
  std::string init = "(:init (at n0)";
  for (int relation = 0; relation < 6; ++relation) {
    for (int i = 0; i < 50; ++i) {
      for (int j = 0; j < 50; ++j)
        init += atom("s" + std::to_string(relation), i, j);
    }
  }
  init += ")";
  const RelaxedReachability relaxed =
      relaxedReachability(read(kPathPredicates +
                                   ") (:action go :parameters (?0 ?1 ?2 ?3 ?4 ?5 ?6 ?7)"
                                   " :precondition (and (at ?0) " +
                                   kPath + ") :effect (at ?7))",
                               objects(50) + init),
                          {});
  EXPECT_TRUE(relaxed.instantiations.empty());
  EXPECT_EQ(relaxed.match_attempts, 0U);
}

// A star: the centre's six neighbours are decided one by one, each through an index on the centre
// and, once both are known, on both.
TEST(RelaxedReachability, StarsAreJoinedThroughTheirCentre) {
  std::string init = "(:init";
  for (int i = 0; i < 100; ++i) {
    init += " (at n" + std::to_string(i) + ")";
    for (int relation = 0; relation < 6; ++relation)
      init += atom("s" + std::to_string(relation), i, (i + relation) % 100);
  }
  init += ")";
  const RelaxedReachability relaxed = relaxedReachability(
      read(kPathPredicates +
               " (done ?x)) (:action go :parameters (?0 ?1 ?2 ?3 ?4 ?5 ?6) :precondition"
               " (and (s0 ?0 ?1) (s1 ?0 ?2) (s2 ?0 ?3) (s3 ?0 ?4) (s4 ?0 ?5) (s5 ?0 ?6) (at ?0)"
               " (at ?1) (at ?2) (at ?3)) :effect (and (done ?0) (not (at ?1))))",
           objects(100) + init),
      {});
  EXPECT_EQ(relaxed.instantiations.size(), 100U);
  // Each is met once from each of its four `at`s, and each meeting takes at most ten matches.
  EXPECT_LE(relaxed.match_attempts, 4 * 10 * relaxed.instantiations.size());
}

// Parameters of which only the type is known come last: nothing is tried for them before the rest
// is certain to match.
TEST(RelaxedReachability, ParametersThatNoAtomMentionsComeLast) {
  const RelaxedReachability relaxed = relaxedReachability(
      read("(:types thing key) (:predicates (at ?x) (locked ?x) (open ?x - thing ?k - key))"
           "(:action unlock :parameters (?k - key ?a ?b - thing)"
           " :precondition (and (at ?a) (at ?b) (locked ?a) (locked ?b) (not (= ?a ?b)))"
           " :effect (open ?a ?k))",
           "(:objects k0 k1 k2 - key a b c d e f g h - thing) (:init (at a) (at b) (at c) (at d)"
           " (at e) (at f) (at g) (at h) (locked a) (locked b))"),
      {});
  EXPECT_EQ(relaxed.instantiations.size(), 6U);
  EXPECT_LT(relaxed.match_attempts, 30U);
}

TEST(RelaxedReachability, WitnessesThatNeverChangeAreOne) {
  const RelaxedReachability relaxed = relaxedReachability(
      read("(:predicates (road ?x ?y) (at ?x)) (:action rest :parameters (?x)"
           " :precondition (and (at ?x) (exists (?y) (road ?x ?y))) :effect (not (at ?x)))",
           objects(9) + "(:init (at n0) (road n0 n1) (road n0 n2) (road n0 n3) (at n5))"),
      {});
  EXPECT_EQ(relaxed.instantiations.size(), 1U);
}

// An effect's condition is joined from the action that was reached, not with all objects.
TEST(RelaxedReachability, ConditionalEffectsAreJoinedAfterTheirAction) {
  std::string init = "(:init (at n0)";
  for (int i = 0; i < 100; ++i)
    init += atom("in", (i * 7) % 100, i) + atom("next", i, (i + 1) % 100);
  init += ")";
  const RelaxedReachability relaxed = relaxedReachability(
      read("(:predicates (at ?x) (in ?x ?y) (next ?x ?y)) (:action go :parameters (?x ?y)"
           " :precondition (and (at ?x) (next ?x ?y)) :effect (and (at ?y) (forall (?z)"
           " (when (in ?z ?x) (and (in ?z ?y) (not (in ?z ?x)))))))",
           objects(100) + init),
      {});
  EXPECT_EQ(relaxed.atoms.size(), 100U + 100U + 100U * 100U);
  EXPECT_EQ(relaxed.instantiations.size(), 100U + 100U * 100U);
  EXPECT_LT(relaxed.match_attempts, 6 * relaxed.instantiations.size());
}

TEST(RelaxedReachability, StopsAtACancelADeadlineAndBytes) {
  const pddl::Model model = chain(300);
  const auto reason = [&](const Limits& limits) {
    try {
      relaxedReachability(model, limits);
    } catch (const LimitReached& reached) {
      return reached.reason();
    }
    return LimitReason::None;
  };
  CancelToken token;
  token.cancel();
  Limits cancelled;
  cancelled.cancel = &token;
  EXPECT_EQ(reason(cancelled), LimitReason::Cancelled);
  EXPECT_EQ(reason(Limits{}.withSeconds(-1)), LimitReason::Time);
  Limits narrow;
  narrow.bytes = 1000;
  EXPECT_EQ(reason(narrow), LimitReason::Memory);
}

}  // namespace
}  // namespace goal_alignment::grounding
