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
  for (const pddl::Atom& atom : relaxed.atoms)
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
  RC_ASSERT(relaxed.ids.size() == relaxed.atoms.size());
  for (AtomId id = 0; id < relaxed.atoms.size(); ++id) {
    RC_ASSERT(relaxed.ids.at(relaxed.atoms[id]) == id);
  }
  RC_ASSERT(relaxed.initial_count == model.init.size());
  for (const pddl::Atom& atom : model.init)
    RC_ASSERT(relaxed.ids.at(atom) < relaxed.initial_count);
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
