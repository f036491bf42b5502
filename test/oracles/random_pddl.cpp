// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/random_pddl.h"

#include <algorithm>

#include "oracles/lifted_space.h"
#include "oracles/seeds.h"

namespace goal_alignment::oracles {

namespace {

using Sketch = ModelSketch;

const char* const kTop = "object";
const char* const kEither = "(either t1 t2)";

std::string typedList(const std::vector<Sketch::Typed>& list, bool typed) {
  std::string text;
  for (const Sketch::Typed& entry : list) {
    text += " " + entry.name;
    if (typed && entry.type != kTop) text += " - " + entry.type;
  }
  return text;
}

/// Untyped names must stand last in a typed list, or they would take on the type of those behind.
std::vector<Sketch::Typed> untypedLast(std::vector<Sketch::Typed> list) {
  std::stable_partition(list.begin(), list.end(),
                        [](const Sketch::Typed& entry) { return entry.type != kTop; });
  return list;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += " " + word;
  return text;
}

/// Which terms an atom may take: a condition may name a parameter of a wider type than the
/// predicate's, which then narrows it; an effect may not.
enum class Fit { Strict, Loose };

/// A term that fits the type: one of the parameters, or now and then a constant.
std::string drawTerm(RandomSource& random, const Sketch& sketch, const std::string& type,
                     const std::vector<Sketch::Typed>& parameters, Fit fit) {
  std::vector<std::string> fitting;
  for (const Sketch::Typed& parameter : parameters) {
    const bool wider = fit == Fit::Loose && sketch.isSubtype(type, parameter.type);
    if (wider || sketch.isSubtype(parameter.type, type)) {
      fitting.insert(fitting.end(), 4, "?" + parameter.name);
    }
  }
  for (const Sketch::Typed& constant : sketch.constants) {
    if (sketch.isSubtype(constant.type, type)) fitting.push_back(constant.name);
  }
  return fitting.empty() ? "" : fitting[random.below(fitting.size())];
}

/// An atom over the parameters; empty where nothing fits.
std::string drawAtom(RandomSource& random, const Sketch& sketch,
                     const std::vector<Sketch::Typed>& parameters, std::size_t first_predicate,
                     Fit fit) {
  const std::size_t count = sketch.predicates.size() - first_predicate;
  const Sketch::Predicate& predicate = sketch.predicates[first_predicate + random.below(count)];
  std::string text = "(" + predicate.name;
  for (const std::string& type : predicate.types) {
    const std::string term = drawTerm(random, sketch, type, parameters, fit);
    if (term.empty()) return "";
    text += " " + term;
  }
  return text + ")";
}

void insertUnlessEmpty(std::vector<std::string>& list, std::string text) {
  if (!text.empty()) list.push_back(std::move(text));
}

void addTypesAndObjects(RandomSource& random, Sketch& sketch) {
  sketch.typed = chance(random, 0.6);
  if (sketch.typed) sketch.types = {{"t0", kTop}, {"t1", "t0"}, {"t2", kTop}};
  const auto draw_type = [&]() -> std::string {
    if (!sketch.typed || chance(random, 0.1)) return kTop;
    return sketch.types[random.below(sketch.types.size())].name;
  };
  if (chance(random, 0.4)) sketch.constants.push_back({"k", draw_type()});
  const std::size_t objects = between(random, 1, 3 - sketch.constants.size());
  for (std::size_t i = 0; i < objects; ++i) {
    sketch.objects.push_back({"o" + std::to_string(i), draw_type()});
  }
  const auto draw_parameter_type = [&]() -> std::string {
    return chance(random, 0.5) ? kTop : draw_type();
  };
  sketch.predicates.push_back({"fixed", {draw_parameter_type()}});
  sketch.predicates.push_back({"flag", {}});
  for (const char* name : {"p", "q"})
    sketch.predicates.push_back({name, {draw_parameter_type()}});
  if (chance(random, 0.6)) {
    sketch.predicates.push_back({"link", {draw_parameter_type(), draw_parameter_type()}});
  }
}

void addPreconditions(RandomSource& random, const Sketch& sketch, Sketch::Action& action) {
  for (std::size_t n = random.below(4); n > 0; --n) {
    std::string atom = drawAtom(random, sketch, action.parameters, 0, Fit::Loose);
    if (!atom.empty() && chance(random, 0.3)) atom = "(not " + atom + ")";
    insertUnlessEmpty(action.precondition, std::move(atom));
  }
  if (action.parameters.size() > 1 && chance(random, 0.4)) {
    const std::string equal =
        "(= ?" + action.parameters[0].name + " ?" + action.parameters[1].name + ")";
    action.precondition.push_back(chance(random, 0.8) ? "(not " + equal + ")" : equal);
  }
}

void addAction(RandomSource& random, Sketch& sketch) {
  Sketch::Action action;
  action.name = "act" + std::to_string(sketch.actions.size());
  const char* const names[] = {"x", "y", "z"};
  const std::size_t parameters = between(random, 0, chance(random, 0.2) ? 3 : 2);
  for (std::size_t i = 0; i < parameters; ++i) {
    const bool narrow = sketch.typed && chance(random, 0.4);
    action.parameters.push_back(
        {names[i], narrow ? sketch.types[random.below(sketch.types.size())].name : kTop});
  }
  addPreconditions(random, sketch, action);
  // From the second predicate on: the first one stays static.
  for (std::size_t n = between(random, 1, 2); n > 0; --n) {
    insertUnlessEmpty(action.add, drawAtom(random, sketch, action.parameters, 1, Fit::Strict));
  }
  // Most actions use up what they need, as real ones do: that is what conflicts are made of.
  for (const std::string& needed : action.precondition) {
    const bool may_change = needed.rfind("(not ", 0) != 0 && needed.rfind("(fixed ", 0) != 0 &&
                            needed.rfind("(= ", 0) != 0;
    if (may_change && chance(random, 0.5)) action.del.push_back(needed);
  }
  for (std::size_t n = between(random, 0, 1); n > 0; --n) {
    insertUnlessEmpty(action.del, drawAtom(random, sketch, action.parameters, 1, Fit::Strict));
  }
  if (sketch.metric && !chance(random, 0.1)) {
    const bool weigh = !action.parameters.empty() && chance(random, 0.4);
    action.cost = weigh ? "(weight ?x)" : std::to_string(random.below(4));
  }
  sketch.actions.push_back(std::move(action));
}

/// Formulas and effects over the variables that are known where they stand.
class AdlWriter {
 public:
  AdlWriter(RandomSource& random, const Sketch& sketch) : random_(random), sketch_(sketch) {}

  std::string formula(const std::vector<Sketch::Typed>& scope, int depth) {
    const std::size_t kind = depth == 0 ? 0 : random_.below(10);
    if (kind < 4) return literal(scope);
    if (kind == 4) return "(not " + formula(scope, depth - 1) + ")";
    if (kind == 5) {
      return "(imply " + formula(scope, depth - 1) + " " + formula(scope, depth - 1) + ")";
    }
    if (kind < 8) {
      std::string text = chance(random_, 0.4) ? "(and" : "(or";
      const std::size_t least = chance(random_, 0.1) ? 0 : 1;
      for (std::size_t n = between(random_, least, 3); n > 0; --n)
        text += " " + formula(scope, depth - 1);
      return text + ")";
    }
    const Sketch::Typed variable = drawVariable();
    return std::string("(") + (kind == 8 ? "forall" : "exists") + declared(variable) +
           formula(within(scope, variable), depth - 1) + ")";
  }

  std::string effect(const std::vector<Sketch::Typed>& scope, int depth) {
    const std::size_t kind = depth == 0 ? 0 : random_.below(6);
    if (kind == 0) {
      std::string text = "(and";
      for (std::size_t n = between(random_, 1, 2); n > 0; --n) {
        const std::string atom = drawAtom(random_, sketch_, scope, 1, Fit::Strict);
        if (!atom.empty()) text += chance(random_, 0.5) ? " " + atom : " (not " + atom + ")";
      }
      return text + ")";
    }
    if (kind < 4) return "(when " + formula(scope, 2) + " " + effect(scope, depth - 1) + ")";
    const Sketch::Typed variable = drawVariable();
    return "(forall" + declared(variable) + effect(within(scope, variable), depth - 1) + ")";
  }

 private:
  std::string literal(const std::vector<Sketch::Typed>& scope) {
    std::string text = drawAtom(random_, sketch_, scope, 0, Fit::Loose);
    if (scope.size() > 1 && chance(random_, 0.15)) {
      text = "(= ?" + scope[random_.below(scope.size())].name + " ?" +
             scope[random_.below(scope.size())].name + ")";
    }
    if (text.empty()) return "(and)";
    return chance(random_, 0.4) ? "(not " + text + ")" : text;
  }

  Sketch::Typed drawVariable() {
    const char* const names[] = {"x", "u", "v"};
    Sketch::Typed variable{names[random_.below(3)], kTop};
    if (sketch_.typed && chance(random_, 0.5)) {
      const std::size_t type = random_.below(sketch_.types.size() + 1);
      variable.type = type == sketch_.types.size() ? kEither : sketch_.types[type].name;
    }
    return variable;
  }

  static std::string declared(const Sketch::Typed& variable) {
    return " (?" + variable.name + (variable.type == kTop ? "" : " - " + variable.type) + ") ";
  }

  static std::vector<Sketch::Typed> within(std::vector<Sketch::Typed> scope,
                                           const Sketch::Typed& variable) {
    const auto hidden = [&](const Sketch::Typed& outer) { return outer.name == variable.name; };
    scope.erase(std::remove_if(scope.begin(), scope.end(), hidden), scope.end());
    scope.push_back(variable);
    return scope;
  }

  RandomSource& random_;
  const Sketch& sketch_;
};

/// Puts unions where single types were.
void uniteTypes(RandomSource& random, Sketch& sketch) {
  if (!sketch.typed) return;
  for (Sketch::Typed& object : sketch.objects) {
    if (chance(random, 0.15)) object.type = kEither;
  }
  for (Sketch::Predicate& predicate : sketch.predicates) {
    for (std::string& type : predicate.types) {
      if (chance(random, 0.15)) type = kEither;
    }
  }
}

}  // namespace

std::string ModelSketch::domainText() const {
  std::string text = "(define (domain random)\n";
  if (typed) text += "  (:types" + typedList(untypedLast(types), true) + ")\n";
  if (!constants.empty())
    text += "  (:constants" + typedList(untypedLast(constants), typed) + ")\n";
  text += "  (:predicates";
  for (const Predicate& predicate : predicates) {
    text += " (" + predicate.name;
    for (std::size_t i = 0; i < predicate.types.size(); ++i) {
      text += " ?a" + std::to_string(i);
      if (typed) text += " - " + predicate.types[i];
    }
    text += ")";
  }
  text += ")\n";
  if (metric) text += "  (:functions (total-cost) (weight ?x))\n";
  for (const Action& action : actions) {
    std::string parameters;
    for (const Typed& parameter : action.parameters) {
      parameters += " ?" + parameter.name;
      if (typed) parameters += " - " + parameter.type;
    }
    text += "  (:action " + action.name + " :parameters (" + parameters + ")\n";
    if (!action.precondition.empty()) {
      text += "    :precondition (and" + joined(action.precondition) + ")\n";
    }
    text += "    :effect (and" + joined(action.add);
    for (const std::string& atom : action.del)
      text += " (not " + atom + ")";
    text += joined(action.conditional);
    if (!action.cost.empty()) text += " (increase (total-cost) " + action.cost + ")";
    text += "))\n";
  }
  return text + ")\n";
}

std::string ModelSketch::problemText() const {
  return "(define (problem small) (:domain random)\n  (:objects" +
         typedList(untypedLast(objects), typed) + ")\n  (:init" + joined(init) +
         joined(metric ? init_values : std::vector<std::string>{}) + ")\n  (:goal (and" +
         joined(goal) + "))" + (metric ? "\n  (:metric minimize (total-cost))" : "") + ")\n";
}

pddl::Model ModelSketch::model() const {
  return pddl::readModel({"domain.pddl", domainText()}, {"problem.pddl", problemText()});
}

bool ModelSketch::isSubtype(const std::string& type, const std::string& wanted) const {
  if (wanted == kTop || type == wanted) return true;
  if (type == kEither) return isSubtype("t1", wanted) && isSubtype("t2", wanted);
  if (wanted == kEither) return isSubtype(type, "t1") || isSubtype(type, "t2");
  const auto declared = std::find_if(types.begin(), types.end(),
                                     [&](const Typed& entry) { return entry.name == type; });
  return declared != types.end() && isSubtype(declared->type, wanted);
}

std::vector<std::string> ModelSketch::objectsOf(const std::string& type) const {
  std::vector<std::string> names;
  for (const auto* list : {&constants, &objects}) {
    for (const Typed& object : *list) {
      if (isSubtype(object.type, type)) names.push_back(object.name);
    }
  }
  return names;
}

std::vector<std::string> ModelSketch::atomsOf(const Predicate& predicate) const {
  std::vector<std::string> atoms = {"(" + predicate.name};
  for (const std::string& type : predicate.types) {
    std::vector<std::string> longer;
    for (const std::string& atom : atoms) {
      for (const std::string& object : objectsOf(type))
        longer.push_back(atom + " " + object);
    }
    atoms = std::move(longer);
  }
  for (std::string& atom : atoms)
    atom += ")";
  return atoms;
}

namespace {

void addInit(RandomSource& random, Sketch& sketch) {
  for (const Sketch::Predicate& predicate : sketch.predicates) {
    for (const std::string& atom : sketch.atomsOf(predicate)) {
      if (chance(random, 0.35)) sketch.init.push_back(atom);
    }
  }
  for (const std::string& object : sketch.objectsOf(kTop)) {
    sketch.init_values.push_back("(= (weight " + object + ") " + std::to_string(random.below(4)) +
                                 ")");
  }
}

}  // namespace

ModelSketch randomSketch(RandomSource& random) {
  ModelSketch sketch;
  sketch.metric = chance(random, 0.4);
  addTypesAndObjects(random, sketch);
  const std::size_t actions = between(random, 2, 4);
  while (sketch.actions.size() < actions)
    addAction(random, sketch);
  addInit(random, sketch);
  return sketch;
}

ModelSketch randomAdlSketch(RandomSource& random) {
  ModelSketch sketch;
  sketch.metric = chance(random, 0.4);
  addTypesAndObjects(random, sketch);
  uniteTypes(random, sketch);
  const std::size_t actions = between(random, 1, 3);
  while (sketch.actions.size() < actions) {
    addAction(random, sketch);
    ModelSketch::Action& action = sketch.actions.back();
    AdlWriter writer(random, sketch);
    if (chance(random, 0.6))
      action.precondition.resize(std::min<std::size_t>(action.precondition.size(), 1));
    if (chance(random, 0.7)) action.precondition.push_back(writer.formula(action.parameters, 3));
    for (std::size_t n = random.below(4); n > 0; --n)
      action.conditional.push_back(writer.effect(action.parameters, 3));
  }
  addInit(random, sketch);
  // The problem's objects may stand in its goal as the domain's constants do.
  ModelSketch with_objects = sketch;
  with_objects.constants.insert(with_objects.constants.end(), sketch.objects.begin(),
                                sketch.objects.end());
  AdlWriter writer(random, with_objects);
  for (std::size_t n = between(random, 1, 3); n > 0; --n)
    sketch.goal.push_back(writer.formula({}, 3));
  return sketch;
}

ModelSketch carrySketch(RandomSource& random) {
  ModelSketch sketch;
  sketch.typed = false;
  sketch.predicates = {{"free", {}},     {"soap", {}},     {"held", {kTop}},
                       {"down", {kTop}}, {"used", {kTop}}, {"clean", {kTop}}};
  const std::vector<ModelSketch::Typed> x = {{"x", kTop}};
  sketch.actions = {
      {"take", x, {"(free)", "(down ?x)"}, {"(held ?x)"}, {"(free)", "(down ?x)"}, ""},
      {"put", x, {"(held ?x)"}, {"(down ?x)", "(free)"}, {"(held ?x)"}, ""},
      {"use", x, {"(held ?x)", "(clean ?x)"}, {"(used ?x)"}, {"(clean ?x)"}, ""},
      {"wash", x, {"(held ?x)", "(soap)"}, {"(clean ?x)"}, {"(soap)"}, ""}};
  sketch.init = {"(free)"};
  if (chance(random, 0.7)) sketch.init.push_back("(soap)");
  const std::size_t things = chance(random, 0.8) ? 2 : 3;
  for (std::size_t i = 0; i < things; ++i) {
    const std::string thing = "o" + std::to_string(i);
    sketch.objects.push_back({thing, kTop});
    sketch.init.push_back("(down " + thing + ")");
    if (chance(random, 0.5)) sketch.init.push_back("(clean " + thing + ")");
  }
  return sketch;
}

ModelSketch randomSmallSketch(RandomSource& random, std::size_t most_states) {
  for (;;) {
    ModelSketch sketch = randomSketch(random);
    if (LiftedSpace(sketch.model(), most_states).complete()) return sketch;
  }
}

ModelSketch randomSmallAdlSketch(RandomSource& random, std::size_t most_states) {
  for (;;) {
    // Most random conditions can't be met, so that few states say little: they get fewer turns.
    ModelSketch sketch = randomAdlSketch(random);
    const LiftedSpace space(sketch.model(), most_states);
    if (space.complete() && (space.size() > 5 || chance(random, 0.1))) return sketch;
  }
}

}  // namespace goal_alignment::oracles
