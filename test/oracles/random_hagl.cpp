// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/random_hagl.h"

#include <algorithm>
#include <string>
#include <utility>

#include "oracles/random_pddl.h"
#include "oracles/seeds.h"

namespace goal_alignment::oracles {

namespace {

constexpr std::size_t kMaxStates = 1500;

template <typename List>
void dropSome(RandomSource& random, List& list, double probability) {
  List kept;
  for (auto& entry : list) {
    if (!chance(random, probability)) kept.push_back(std::move(entry));
  }
  list = std::move(kept);
}

/// Adds a predicate that this model alone knows, true of some objects, and made true by an action.
void addOwnPredicate(RandomSource& random, ModelSketch& sketch, const std::string& name) {
  sketch.predicates.push_back({name, {"object"}});
  for (const std::string& atom : sketch.atomsOf(sketch.predicates.back())) {
    if (chance(random, 0.5)) sketch.init.push_back(atom);
  }
  ModelSketch::Action& action = sketch.actions[random.below(sketch.actions.size())];
  if (!action.parameters.empty() && chance(random, 0.7)) {
    action.add.push_back("(" + name + " ?" + action.parameters[0].name + ")");
  }
}

ModelSketch humanOf(RandomSource& random, const ModelSketch& robot) {
  ModelSketch human = robot;
  for (ModelSketch::Action& action : human.actions) {
    dropSome(random, action.precondition, 0.25);
    dropSome(random, action.del, 0.5);
  }
  if (chance(random, 0.5)) return human;
  dropSome(random, human.init, 0.1);
  for (const ModelSketch::Predicate& predicate : human.predicates) {
    for (const std::string& atom : human.atomsOf(predicate)) {
      const bool known = std::count(human.init.begin(), human.init.end(), atom) > 0;
      if (!known && chance(random, 0.1)) human.init.push_back(atom);
    }
  }
  if (human.objects.size() + human.constants.size() < 3 && chance(random, 0.2)) {
    human.objects.push_back({"imagined", "object"});
    human.init_values.push_back("(= (weight imagined) 1)");
    for (const ModelSketch::Predicate& predicate : human.predicates) {
      if (predicate.types != std::vector<std::string>{"object"}) continue;
      human.init.push_back("(" + predicate.name + " imagined)");
    }
  }
  return human;
}

/// A random walk; the plan and where it ends.
std::pair<std::vector<GroundName>, Atoms> walk(RandomSource& random, const pddl::Model& model) {
  std::vector<GroundName> plan;
  Atoms atoms = initialAtoms(model);
  const std::vector<GroundAction> actions = allActions(model);
  for (std::size_t steps = random.below(8); steps > 0; --steps) {
    std::vector<const GroundAction*> applicable;
    for (const GroundAction& action : actions) {
      if (holds(action.precondition, atoms)) applicable.push_back(&action);
    }
    if (applicable.empty()) break;
    const GroundAction& action = *applicable[random.below(applicable.size())];
    plan.push_back(action.name);
    atoms = successor(action, atoms);
  }
  return {plan, atoms};
}

std::vector<Literal> drawSpecified(RandomSource& random, const Atoms& expected,
                                   const pddl::Model& human) {
  std::vector<Literal> specified;
  const double share = chance(random, 0.5) ? 0.15 : 0.35;
  for (const GroundName& atom : expected) {
    if (chance(random, share)) specified.push_back({atom, false});
  }
  if (chance(random, 0.15)) {
    for (const GroundAction& action : allActions(human)) {
      for (const GroundName& atom : action.add) {
        if (expected.count(atom) > 0 || !chance(random, 0.3)) continue;
        specified.push_back({atom, true});
      }
    }
  }
  std::sort(specified.begin(), specified.end());
  specified.erase(std::unique(specified.begin(), specified.end()), specified.end());
  return specified;
}

bool knowsAll(const pddl::Model& model, const std::vector<Literal>& literals) {
  return std::all_of(literals.begin(), literals.end(), [&](const Literal& literal) {
    return model.resolve(literal.atom).has_value();
  });
}

/// One try; nothing where the problem came out too large.
std::optional<Hagl> tryHagl(RandomSource& random, std::size_t most_candidates) {
  ModelSketch robot =
      chance(random, 0.5) ? carrySketch(random) : randomSmallSketch(random, kMaxStates);
  ModelSketch human = humanOf(random, robot);
  if (chance(random, 0.3)) addOwnPredicate(random, human, "humans");
  if (chance(random, 0.2)) addOwnPredicate(random, robot, "robots");

  Hagl hagl;
  auto [plan, expected] = walk(random, human.model());
  hagl.specified = drawSpecified(random, expected, human.model());
  for (const GroundName& atom : expected) {
    const Literal fluent = {atom, false};
    if (std::count(hagl.specified.begin(), hagl.specified.end(), fluent) == 0) {
      hagl.candidates.push_back(fluent);
    }
  }
  if (hagl.size() > most_candidates) return std::nullopt;
  hagl.true_goal.insert(hagl.specified.begin(), hagl.specified.end());
  const double share = chance(random, 0.5) ? 0.25 : 0.7;
  for (const Literal& fluent : hagl.candidates) {
    if (chance(random, share)) hagl.true_goal.insert(fluent);
  }

  // A goal that the robot can't name can't stand in its problem file.
  if (chance(random, 0.5) && !hagl.specified.empty()) hagl.input.goal = hagl.specified;
  if (!knowsAll(robot.model(), hagl.specified)) hagl.input.goal = hagl.specified;
  if (hagl.input.goal.empty()) {
    for (const Literal& literal : hagl.specified) {
      robot.goal.push_back(literal.text());
      human.goal.push_back(literal.text());
    }
  }
  hagl.robot = robot.model();
  hagl.human = human.model();
  if (!LiftedSpace(hagl.robot, kMaxStates).complete()) return std::nullopt;
  if (!LiftedSpace(hagl.human, kMaxStates).complete()) return std::nullopt;
  hagl.input.robot_domain = {"robot_domain.pddl", robot.domainText()};
  hagl.input.robot_problem = {"robot_problem.pddl", robot.problemText()};
  hagl.input.human_domain = {"human_domain.pddl", human.domainText()};
  hagl.input.human_problem = {"human_problem.pddl", human.problemText()};
  hagl.input.human_plan = std::move(plan);
  return hagl;
}

}  // namespace

void Hagl::analyse() {
  const LiftedSpace space(robot, kMaxStates);
  alone_ = space.fluentsWith({}, candidates);
  // Achievability is downward closed: from each achieved set to all with one candidate less.
  achievable_.assign(all() + 1, false);
  for (const CandidateBits set : space.fluentsWith(specified, candidates))
    achievable_[set] = true;
  for (CandidateBits set = all() + 1; set-- > 0;) {
    if (!achievable_[set]) continue;
    for (std::size_t f = 0; f < size(); ++f)
      achievable_[set & ~(CandidateBits{1} << f)] = true;
  }
}

std::vector<Literal> Hagl::fluents(CandidateBits set) const {
  std::vector<Literal> result;
  for (std::size_t f = 0; f < size(); ++f) {
    if (((set >> f) & 1U) != 0) result.push_back(candidates[f]);
  }
  return result;
}

CandidateBits Hagl::bits(const std::vector<Literal>& fluents) const {
  CandidateBits set = 0;
  for (const Literal& fluent : fluents) {
    const auto found = std::find(candidates.begin(), candidates.end(), fluent);
    set |= CandidateBits{1} << (found - candidates.begin());
  }
  return set;
}

CandidateBits Hagl::wanted() const {
  CandidateBits set = 0;
  for (std::size_t f = 0; f < size(); ++f) {
    if (wants(candidates[f])) set |= CandidateBits{1} << f;
  }
  return set;
}

bool Hagl::achievableAlone(std::size_t candidate) const {
  return std::any_of(alone_.begin(), alone_.end(),
                     [&](CandidateBits set) { return ((set >> candidate) & 1U) != 0; });
}

std::set<CandidateBits> Hagl::minimalConflicts() const {
  std::set<CandidateBits> conflicts;
  for (CandidateBits set = 0; set <= all(); ++set) {
    bool minimal = !achievable(set);
    for (std::size_t f = 0; f < size(); ++f) {
      const CandidateBits without = set & ~(CandidateBits{1} << f);
      if (without != set && !achievable(without)) minimal = false;
    }
    if (minimal) conflicts.insert(set);
  }
  return conflicts;
}

std::vector<double> Hagl::costDifferences() const {
  const LiftedSpace space(human, kMaxStates);
  std::vector<double> differences;
  for (const Literal& fluent : candidates) {
    std::vector<Literal> goal = specified;
    goal.push_back(fluent);
    const auto plan_cost = static_cast<double>(input.human_plan.size());
    differences.push_back(plan_cost - static_cast<double>(space.cheapest(goal).value()));
  }
  return differences;
}

Hagl randomHagl(RandomSource& random, std::size_t most_candidates) {
  for (;;) {
    if (auto hagl = tryHagl(random, most_candidates)) {
      hagl->analyse();
      return std::move(*hagl);
    }
  }
}

Hagl randomDisputedHagl(RandomSource& random, std::size_t most_candidates) {
  for (;;) {
    Hagl hagl = randomHagl(random, most_candidates);
    if (hagl.achievable(0) && !hagl.achievable(hagl.all())) return hagl;
  }
}

}  // namespace goal_alignment::oracles
