// SPDX-License-Identifier: BSD-3-Clause
#include "misreading.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "drawing.h"
#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::benchmarks {
namespace {

using Part = std::vector<std::string> ActionParts::*;

void forgetSome(DomainParts& domain, Part part, std::size_t count, RandomSource& random) {
  for (; count > 0; --count) {
    std::vector<ActionParts*> having;
    for (ActionParts& action : domain.actions) {
      if (!(action.*part).empty()) having.push_back(&action);
    }
    if (having.empty()) return;
    std::vector<std::string>& literals = oneOf(having, random)->*part;
    literals.erase(literals.begin() + static_cast<std::ptrdiff_t>(random.below(literals.size())));
  }
}

std::vector<std::string> objectsOf(const Models& models, const std::string& type) {
  std::vector<std::string> names;
  for (const Typed& object : models.problem.objects) {
    if (models.domain.isA(object.type, type)) names.push_back(object.name);
  }
  return names;
}

// Indices into init of the facts that may stand with another last argument.
std::vector<std::size_t> displaceableFacts(const Models& models) {
  std::vector<std::size_t> facts;
  for (std::size_t i = 0; i < models.problem.init.size(); ++i) {
    const std::string name = GroundName::parse(models.problem.init[i]).name;
    const auto& may = models.displaceable;
    if (std::find(may.begin(), may.end(), name) != may.end()) facts.push_back(i);
  }
  return facts;
}

void displaceOne(Models& human, RandomSource& random) {
  const auto facts = displaceableFacts(human);
  if (facts.empty()) return;
  std::string& fact = human.problem.init[oneOf(facts, random)];
  GroundName elsewhere = GroundName::parse(fact);
  const auto places =
      objectsOf(human, human.domain.predicate(elsewhere.name)->parameters.back().type);
  elsewhere.arguments.back() = oneOf(places, random);
  fact = elsewhere.text();
}

std::vector<const PredicateParts*> staticPredicates(const DomainParts& domain) {
  std::set<std::string> changed;
  for (const ActionParts& action : domain.actions) {
    for (const auto* effects : {&action.add, &action.del}) {
      for (const std::string& effect : *effects)
        changed.insert(GroundName::parse(effect).name);
    }
  }
  std::vector<const PredicateParts*> unchanged;
  for (const PredicateParts& predicate : domain.predicates) {
    if (changed.count(predicate.name) == 0) unchanged.push_back(&predicate);
  }
  return unchanged;
}

void believeOneStaticMore(Models& human, RandomSource& random) {
  constexpr int kAttempts = 100;  // most draws of most domains are new
  const auto predicates = staticPredicates(human.domain);
  for (int i = 0; i < kAttempts && !predicates.empty(); ++i) {
    const PredicateParts& predicate = *oneOf(predicates, random);
    GroundName fact = {predicate.name, {}};
    for (const Typed& parameter : predicate.parameters)
      fact.arguments.push_back(oneOf(objectsOf(human, parameter.type), random));
    const bool to_itself = fact.arguments.size() > 1 && fact.arguments[0] == fact.arguments[1];
    std::vector<std::string>& init = human.problem.init;
    if (to_itself || std::find(init.begin(), init.end(), fact.text()) != init.end()) continue;
    init.push_back(fact.text());
    return;
  }
}

// The person takes notice of what an action is done to, and knows of a thing that nobody else does.
void addWords(Models& human, RandomSource& random) {
  ActionParts& action = human.domain.actions[random.below(human.domain.actions.size())];
  human.domain.predicates.push_back({"noticed", {{"x", action.parameters.front().type}}});
  action.add.push_back("(noticed ?" + action.parameters.front().name + ")");

  const auto facts = displaceableFacts(human);
  if (facts.empty()) return;
  GroundName fact = GroundName::parse(human.problem.init[oneOf(facts, random)]);
  const std::string type = human.domain.predicate(fact.name)->parameters.front().type;
  fact.arguments.front() = "heirloom";
  human.problem.objects.push_back({"heirloom", type});
  human.problem.init.push_back(fact.text());
}

}  // namespace

Misreading misreadingOf(const std::string& letters) {
  Misreading result = {false, false, false, false};
  for (const char letter : letters) {
    switch (letter) {
      case 'a':
        result.actions = true;
        break;
      case 'i':
        result.initial_state = true;
        break;
      case 's':
        result.statics = true;
        break;
      case 'v':
        result.vocabulary = true;
        break;
      default:
        throw std::invalid_argument("differences are letters of `aisv`, not `" + letters + "`");
    }
  }
  return result;
}

Models misread(const Models& robot, const Misreading& misreading, RandomSource& random) {
  Models human = robot;
  if (misreading.actions) {
    forgetSome(human.domain, &ActionParts::condition, 1 + random.below(3), random);
    forgetSome(human.domain, &ActionParts::del, random.below(3), random);
  }
  if (misreading.initial_state) displaceOne(human, random);
  if (misreading.statics) believeOneStaticMore(human, random);
  if (misreading.vocabulary) addWords(human, random);
  return human;
}

void forgetCondition(DomainParts& domain, const std::string& action, const std::string& literal) {
  std::vector<std::string>& literals = domain.action(action).condition;
  const auto found = std::find(literals.begin(), literals.end(), literal);
  if (found == literals.end()) throw std::out_of_range(action + " has no " + literal);
  literals.erase(found);
}

void forgetPredicate(Models& models, const std::string& name) {
  const auto drop = [&](std::vector<std::string>& literals) {
    literals.erase(std::remove_if(literals.begin(), literals.end(),
                                  [&](const auto& literal) {
                                    return GroundName::parse(literal).name == name;
                                  }),
                   literals.end());
  };
  for (ActionParts& action : models.domain.actions) {
    drop(action.condition);
    drop(action.add);
    drop(action.del);
  }
  drop(models.problem.init);
  drop(models.problem.goal);
  auto& predicates = models.domain.predicates;
  predicates.erase(std::remove_if(predicates.begin(), predicates.end(),
                                  [&](const auto& known) { return known.name == name; }),
                   predicates.end());
}

}  // namespace goal_alignment::benchmarks
