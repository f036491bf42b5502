// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_instance.h"

#include <algorithm>
#include <set>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/validation/execution.h"
#include "home.h"
#include "single_call.h"

namespace goal_alignment::benchmarks {
namespace {

// States, not seconds: the instance must not depend on the machine.
constexpr std::uint64_t kStatesForAPlan = 200'000;

std::vector<GroundName> planOf(const Models& models) {
  const SingleCall call =
      singleCall({"domain", models.domain.text()}, {"problem", models.problemText()},
                 CallKind::First, Limits().withStates(kStatesForAPlan));
  return call.plan;
}

std::vector<Literal> expectedAtTheEnd(const AlignmentInstance& instance) {
  const pddl::Model model = pddl::readModel({"human_domain", instance.human.domain.text()},
                                            {"human_problem", instance.human.problemText()});
  const validation::Execution execution = validation::execute(model, instance.human_plan);
  std::vector<Literal> fluents;
  for (const pddl::Atom& fact : execution.finalState())
    fluents.push_back({model.name(fact), false});
  std::sort(fluents.begin(), fluents.end());  // a hash set's order is no order
  return fluents;
}

// The goal of both models becomes `stated`; the true goal is that, with `left_out` or with what the
// dice say.
void settleGoals(AlignmentInstance& instance, const std::vector<std::string>& stated,
                 const std::vector<std::string>& left_out, const Truth& truth,
                 RandomSource& random) {
  instance.robot.problem.goal = instance.human.problem.goal = stated;
  std::set<Literal> wanted;
  for (const std::string& fact : stated)
    wanted.insert(Literal::parse(fact));
  if (truth.wanted < 0) {
    for (const std::string& fact : left_out)
      wanted.insert(Literal::parse(fact));
  } else {
    for (const Literal& fluent : expectedAtTheEnd(instance)) {
      if (random.unit() < truth.wanted) wanted.insert(fluent);
    }
  }
  instance.true_goal.assign(wanted.begin(), wanted.end());
}

// The person names every other fact of the goal.
void sayHalf(AlignmentInstance& instance, const Truth& truth, RandomSource& random) {
  std::vector<std::string> stated;
  std::vector<std::string> left_out;
  for (const std::string& fact : instance.robot.problem.goal)
    (stated.size() <= left_out.size() ? stated : left_out).push_back(fact);
  settleGoals(instance, stated, left_out, truth, random);
}

// What the person never saw they know nothing about.
void forgetDishesFrom(Models& human, int first, int end) {
  std::set<std::string> unknown;
  for (int i = first; i < end; ++i)
    unknown.insert(numbered("dish", i));
  auto& objects = human.problem.objects;
  objects.erase(std::remove_if(objects.begin(), objects.end(),
                               [&](const Typed& it) { return unknown.count(it.name) > 0; }),
                objects.end());
  auto& init = human.problem.init;
  init.erase(std::remove_if(init.begin(), init.end(),
                            [&](const std::string& fact) {
                              const GroundName it = GroundName::parse(fact);
                              return !it.arguments.empty() && unknown.count(it.arguments[0]) > 0;
                            }),
             init.end());
}

}  // namespace

session::Input AlignmentInstance::input() const {
  session::Input input;
  input.robot_domain = {"robot_domain.pddl", robot.domain.text()};
  input.robot_problem = {"robot_problem.pddl", robot.problemText()};
  input.human_domain = {"human_domain.pddl", human.domain.text()};
  input.human_problem = {"human_problem.pddl", human.problemText()};
  input.human_plan = human_plan;
  return input;
}

AlignmentInstance alignmentOf(const Models& robot, const Misreading& misreading, const Truth& truth,
                              RandomSource& random) {
  constexpr int kDraws = 50;
  for (int draw = 0; draw < kDraws; ++draw) {
    AlignmentInstance instance = {robot, misread(robot, misreading, random), {}, {}};
    instance.human_plan = planOf(instance.human);
    if (instance.human_plan.empty()) continue;
    std::vector<std::string> stated = robot.problem.goal;
    std::vector<std::string> left_out;
    if (stated.size() > 1) {
      const auto at = stated.begin() + static_cast<std::ptrdiff_t>(random.below(stated.size()));
      left_out = {*at};
      stated.erase(at);
    }
    settleGoals(instance, stated, left_out, truth, random);
    return instance;
  }
  throw Exception("no person drawn has a plan");
}

AlignmentInstance householdAlignment(const HouseholdSize& size, int known, const Truth& truth,
                                     RandomSource& random) {
  AlignmentInstance instance = {household(size, random), {}, {}, {}};
  Models human = instance.robot;
  forgetPredicate(human, "bare");
  forgetCondition(human.domain, "set-down", "(in-reach ?p)");
  forgetCondition(human.domain, "set-down", "(light ?d)");
  forgetCondition(human.domain, "take-out", "(in-reach ?p)");
  forgetDishesFrom(human, std::max(known, size.laid), size.dishes);
  const Misreading besides = {false, true, true, true};
  human = misread(human, besides, random);
  instance.human = human;
  instance.human_plan = planOf(instance.human);
  if (instance.human_plan.empty()) throw Exception("the person has no plan for the household");
  sayHalf(instance, truth, random);
  return instance;
}

AlignmentInstance homeAlignment(int size, const Truth& truth, RandomSource& random) {
  Home home = drawnHome(size, random);
  AlignmentInstance instance = {home.robot, home.human, home.human_plan, {}};
  sayHalf(instance, truth, random);
  return instance;
}

AlignmentInstance largeHome(std::uint64_t seed) {
  constexpr int kKnown = 72;
  HouseholdSize size;
  size.rooms = 10;
  size.cupboards = 20;
  size.stands = 20;
  size.dishes = 175;
  size.laid = 10;
  RandomSource random(seed);
  Truth truth;
  truth.wanted = 0.2;
  return householdAlignment(size, kKnown, truth, random);
}

}  // namespace goal_alignment::benchmarks
