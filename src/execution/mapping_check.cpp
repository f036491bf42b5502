// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/mapping_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::execution {
namespace {

using Names = std::vector<std::string>;

constexpr std::size_t kMaxNamed = 5;  // of objects that a table lacks

template <typename Things>
Names namesOf(const Things& things) {
  Names names;
  for (const auto& thing : things)
    names.push_back(thing.name.name);
  return names;
}

/// Goes through a mapping with the robot's model at hand.
class MappingCheck {
 public:
  MappingCheck(const StepMapping& mapping, const pddl::Model& robot)
      : mapping_(mapping), robot_(robot), reader_(mapping.source) {}

  Names run() {
    for (const auto& [action, rule] : mapping_.rules)
      checkRule(action, rule);
    for (const pddl::Schema& schema : robot_.schemas)
      checkSchema(schema);
    for (const auto& failure : mapping_.failures)
      checkFailure(failure.first);
    return std::move(misfits_);
  }

 private:
  void say(const YAML::Node& at, const std::string& what) {
    const std::string text = reader_.place(at.Mark()) + ": " + what;
    if (said_.insert(text).second) misfits_.push_back(text);
  }

  void checkRule(const std::string& action, const StepRule& rule) {
    const auto id = robot_.findSchema(action);
    if (!id) {
      say(rule.key, fmt::format("the robot's domain has no action {}{}", inQuotes(action),
                                pddl::suggestion(action, namesOf(robot_.schemas))));
      return;
    }
    const pddl::Schema& schema = robot_.schemas[*id];
    checkTexts(rule.name, schema);
    checkTexts(rule.fields, schema);
    for (const auto& success : rule.success)
      checkTexts(success.second, schema);
    for (const FrameMove& move : rule.moves) {
      for (const YAML::Node& text : {move.frame, move.parent, move.to})
        checkTexts(text, schema);
    }
    for (const YAML::Node& fact : rule.failure_facts) {
      checkTexts(fact, schema);
      checkFact(fact, schema);
    }
  }

  void checkSchema(const pddl::Schema& schema) {
    const std::string& action = schema.name.name;
    if (mapping_.find(action) != nullptr) return;
    Names known;
    for (const auto& rule : mapping_.rules) {
      if (!robot_.findSchema(rule.first)) known.push_back(rule.first);
    }
    misfits_.push_back(fmt::format("{}nothing says how to carry out the robot's action {}{}",
                                   mapping_.source.empty() ? "" : mapping_.source + ": ",
                                   inQuotes(action), pddl::suggestion(action, known)));
  }

  void checkFailure(const GroundName& action) {
    if (robot_.findSchema(action.name)) return;
    misfits_.push_back(fmt::format("{}: in failures: the robot's domain has no action {}{}",
                                   mapping_.source, inQuotes(action.name),
                                   pddl::suggestion(action.name, namesOf(robot_.schemas))));
  }

  void checkTexts(const YAML::Node& node, const pddl::Schema& schema) {
    if (node.IsScalar()) {
      for (const std::string& name : any_message::Arguments::namesIn(node.Scalar()))
        checkName(name, node, schema);
    } else if (node.IsDefined()) {
      for (const auto& part : node)
        checkTexts(node.IsMap() ? part.second : static_cast<const YAML::Node&>(part), schema);
    }
  }

  /// `to`, `0`, `action` or one of these behind `table:`.
  void checkName(const std::string& name, const YAML::Node& node, const pddl::Schema& schema) {
    const std::size_t colon = name.find(':');
    const std::string key = toLower(colon == std::string::npos ? name : name.substr(colon + 1));
    const pddl::Parameter* found = nullptr;
    for (std::size_t i = 0; i < schema.parameters.size(); ++i) {
      if (key == schema.parameters[i].name || key == std::to_string(i))
        found = &schema.parameters[i];
    }
    if (found == nullptr && key != "action") {
      Names known;
      for (const pddl::Parameter& parameter : schema.parameters)
        known.push_back(parameter.name);
      say(node, fmt::format("the action {} has no parameter {}, but {}{}", schema.name.name,
                            inQuotes(key),
                            known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")),
                            pddl::suggestion(key, known)));
    } else if (colon != std::string::npos) {
      checkTable(name.substr(0, colon), node, found, schema);
    }
  }

  void checkTable(const std::string& table, const YAML::Node& node, const pddl::Parameter* of,
                  const pddl::Schema& schema) {
    const YAML::Node& tables = mapping_.tables;  // a const one is not changed by looking
    const YAML::Node entries = tables.IsMap() ? tables[table] : YAML::Node();
    if (!entries.IsDefined() || !entries.IsMap()) {
      Names known;
      for (const auto& entry : tables)
        known.push_back(entry.first.Scalar());
      say(node,
          fmt::format("there is no table {}{}", inQuotes(table), pddl::suggestion(table, known)));
    } else if (of != nullptr) {
      checkEntries(table, entries, node, *of, schema);
    }
  }

  void checkEntries(const std::string& table, const YAML::Node& entries, const YAML::Node& node,
                    const pddl::Parameter& of, const pddl::Schema& schema) {
    if (!checked_.insert({table, of.type}).second) return;
    std::set<std::string> known;
    Names strangers;
    for (const auto& entry : entries) {
      known.insert(toLower(entry.first.Scalar()));
      if (!robot_.findObject(toLower(entry.first.Scalar())))
        strangers.push_back(entry.first.Scalar());
    }
    Names missing;
    for (const pddl::Object& object : robot_.objects) {
      const bool is_needed = robot_.isSubtype(object.type, of.type);
      if (is_needed && known.count(object.name.name) == 0) missing.push_back(object.name.name);
    }
    if (missing.empty()) return;
    const std::string near = pddl::suggestion(missing.front(), strangers);
    const std::size_t more = missing.size() - std::min(missing.size(), kMaxNamed);
    missing.resize(missing.size() - more);
    say(node,
        fmt::format("table {} has no entry for {}{}, which ?{} of {} may be{}", inQuotes(table),
                    fmt::join(missing, ", "), more > 0 ? fmt::format(" and {} more", more) : "",
                    of.name, schema.name.name, near));
    sayStrangers(entries, strangers, missing);
  }

  void sayStrangers(const YAML::Node& entries, const Names& strangers, const Names& missing) {
    for (const auto& entry : entries) {
      const std::string name = entry.first.Scalar();
      const bool is_stranger =
          std::find(strangers.begin(), strangers.end(), name) != strangers.end();
      const std::string near = is_stranger ? pddl::suggestion(name, missing) : "";
      if (!near.empty())
        say(entry.first, fmt::format("no object is called {}{}", inQuotes(name), near));
    }
  }

  /// With some object for each parameter: which one does not matter for what is looked at.
  void checkFact(const YAML::Node& node, const pddl::Schema& schema) {
    ActionDispatch step;
    step.name = schema.name.name;
    for (const pddl::Parameter& parameter : schema.parameters) {
      step.parameters.emplace_back();
      step.parameters.back().key = parameter.name;
      step.parameters.back().value = someObject(parameter.type);
    }
    Literal fact;
    try {
      fact =
          Literal::parse(any_message::Arguments(step, mapping_.tables, mapping_.source).fill(node));
    } catch (const YamlError&) {
      return;  // of a parameter or a table that is not there, which is said already
    } catch (const std::invalid_argument& error) {
      return say(node, error.what());
    }
    checkAtom(fact.atom, node);
  }

  void checkAtom(const GroundName& atom, const YAML::Node& node) {
    const auto id = robot_.findPredicate(atom.name);
    if (!id) {
      return say(node, fmt::format("the robot's domain has no predicate {}{}", inQuotes(atom.name),
                                   pddl::suggestion(atom.name, namesOf(robot_.predicates))));
    }
    const std::size_t takes = robot_.predicates[*id].parameter_types.size();
    if (takes != atom.arguments.size()) {
      return say(node, fmt::format("{} takes {} {}, found {}", inQuotes(atom.name), takes,
                                   takes == 1 ? "argument" : "arguments", atom.arguments.size()));
    }
    for (const std::string& argument : atom.arguments) {
      if (argument == kNobody || robot_.findObject(argument)) continue;
      say(node, fmt::format("the robot's problem has no object {}{}", inQuotes(argument),
                            pddl::suggestion(argument, namesOf(robot_.objects))));
    }
  }

  std::string someObject(pddl::TypeId type) const {
    for (const pddl::Object& object : robot_.objects) {
      if (robot_.isSubtype(object.type, type)) return object.name.name;
    }
    return kNobody;
  }

  static constexpr const char* kNobody = "?";

  const StepMapping& mapping_;
  const pddl::Model& robot_;
  YamlReader reader_;
  std::set<std::pair<std::string, pddl::TypeId>> checked_;  // tables
  std::set<std::string> said_;
  Names misfits_;
};

}  // namespace

std::vector<std::string> misfits(const StepMapping& mapping, const pddl::Model& robot) {
  return MappingCheck(mapping, robot).run();
}

}  // namespace goal_alignment::execution
