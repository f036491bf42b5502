// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/spatial_facts/rules.h"
#include "region_reader.h"
#include "rule_text.h"

namespace goal_alignment::spatial_facts {

namespace {

/// Of all rules together: far more than a robot looks at, and aliases could make a small file many.
constexpr std::size_t kMaxAtoms = 100'000;
constexpr std::size_t kMaxRules = 1000;
constexpr std::size_t kMaxRegions = 1000;

bool overlap(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  if (a.empty() || b.empty()) return true;  // all objects
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) {
    return std::find(b.begin(), b.end(), name) != b.end();
  });
}

bool overlap(const Rule& a, const Rule& b) {
  if (a.pattern.name != b.pattern.name || a.owned.size() != b.owned.size()) return false;
  for (std::size_t i = 0; i < a.owned.size(); ++i) {
    if (!overlap(a.owned[i], b.owned[i])) return false;
  }
  return true;
}

}  // namespace

/// Fills Rules from a YAML document: each rule is written out for all values of its variables.
class RulesReader : private YamlReader {
 public:
  using YamlReader::YamlReader;

  std::shared_ptr<const Rules> read(const std::string& text) {
    rules_->text_ = text;
    load(text, [this](const YAML::Node& document) { readSections(document); });
    return std::move(rules_);
  }

 private:
  using Binding = std::vector<std::size_t>;  // by variable, the index of its value

  void readSections(const YAML::Node& root) {
    const Fields sections = fields(root, "a map with defaults, frames, regions, rules",
                                   {"defaults", "frames", "regions", "rules"});
    const auto section = [&](const char* name, void (RulesReader::*reader)(const YAML::Node&)) {
      const auto found = sections.find(name);
      if (found != sections.end()) (this->*reader)(found->second);
    };
    section("defaults", &RulesReader::readDefaults);
    section("frames", &RulesReader::readFrames);
    section("regions", &RulesReader::readRegions);
    section("rules", &RulesReader::readRules);
  }

  void readDefaults(const YAML::Node& node) {
    const Fields defaults = fields(node, "a map with frame, max_age, margin, unknown",
                                   {"frame", "max_age", "margin", "unknown"});
    if (const auto frame = defaults.find("frame"); frame != defaults.end())
      defaults_.frame = readFrame(*this, frame->second);
    readSettings(*this, defaults, defaults_);
  }

  void readFrames(const YAML::Node& node) {
    expectMap(node, "a map from objects to tf frames");
    for (const auto& entry : node) {
      const std::string object = readName(*this, entry.first, "an object's name");
      if (!frames_.emplace(object, readFrame(*this, entry.second)).second)
        fail(entry.first.Mark(), "each object once", inQuotes(object) + " again");
    }
  }

  void readRegions(const YAML::Node& node) {
    expectMap(node, "a map from names to regions");
    if (node.size() > kMaxRegions)
      fail(node.Mark(), fmt::format("at most {} regions", kMaxRegions),
           fmt::format("{}", node.size()));
    for (const auto& entry : node) {
      const std::string name = readName(*this, entry.first, "a region's name");
      if (!region_ids_.emplace(name, rules_->regions_.size()).second)
        fail(entry.first.Mark(), "each region once", inQuotes(name) + " again");
      rules_->regions_.push_back(readRegion(*this, entry.second, defaults_.frame));
    }
  }

  void readRules(const YAML::Node& node) {
    expectList(node, "a list of rules");
    if (node.size() > kMaxRules)
      fail(node.Mark(), fmt::format("at most {} rules", kMaxRules), fmt::format("{}", node.size()));
    for (const auto& item : node) {
      const RuleText text = readRule(*this, item, defaults_);
      Rule rule = ruleOf(text);
      for (const Rule& other : rules_->rules_) {
        if (overlap(rule, other))
          failAt(text.mark,
                 fmt::format("{} and {} ({}) own the same atoms", inQuotes(rule.pattern.text()),
                             inQuotes(other.pattern.text()), other.place));
      }
      rules_->rules_.push_back(std::move(rule));
    }
  }

  Rule ruleOf(const RuleText& text) {
    Rule rule;
    rule.place = place(text.mark);
    rule.pattern = text.fact;
    rule.exactly_one = text.exactly_one.has_value();
    rule.otherwise = text.otherwise;
    rule.otherwise_object = text.otherwise_object;
    rule.max_age = text.settings.max_age;
    rule.margin = text.settings.margin;
    rule.unknown = text.settings.unknown;
    for (std::size_t i = 0; i < text.arguments.size(); ++i) {
      const Term& argument = text.arguments[i];
      rule.owned.push_back(ownedBy(text, argument));
      if (rule.exactly_one && argument.variable == text.exactly_one) rule.slot = i;
    }
    writeOut(text, rule);
    return rule;
  }

  // A thing that is in none of the regions is not in one that has no shape, either.
  static std::vector<std::string> ownedBy(const RuleText& text, const Term& argument) {
    if (!argument.variable) return {argument.name};
    const Condition& condition = text.condition;
    if (condition.in_region && condition.other.variable == argument.variable) return {};
    return text.variables[*argument.variable].values;
  }

  void writeOut(const RuleText& text, Rule& rule) {
    for (const Variable& variable : text.variables) {
      if (variable.values.size() > kMaxAtoms) refuseSize(text);
    }
    std::map<GroundName, std::size_t> groups;  // by key
    Binding binding(text.variables.size(), 0);
    do {
      if (++atoms_ > kMaxAtoms) refuseSize(text);
      addTo(rule, groups, text, binding);
    } while (next(text, binding));
  }

  [[noreturn]] void refuseSize(const RuleText& text) const {
    fail(text.mark, fmt::format("at most {} atoms of all rules", kMaxAtoms), "more");
  }

  // The next binding, as an odometer counts; false after the last.
  static bool next(const RuleText& text, Binding& binding) {
    for (std::size_t i = binding.size(); i-- > 0;) {
      if (++binding[i] < text.variables[i].values.size()) return true;
      binding[i] = 0;
    }
    return false;
  }

  static std::string valueOf(const RuleText& text, const Term& term, const Binding& binding) {
    return term.variable ? text.variables[*term.variable].values[binding[*term.variable]]
                         : term.name;
  }

  void addTo(Rule& rule, std::map<GroundName, std::size_t>& groups, const RuleText& text,
             const Binding& binding) {
    GroundName atom{text.fact.name, {}};
    for (const Term& argument : text.arguments)
      atom.arguments.push_back(valueOf(text, argument, binding));
    const std::string subject = valueOf(text, text.condition.subject, binding);
    const std::string other = valueOf(text, text.condition.other, binding);
    // Nothing is near itself, nor far from it.
    if (!text.condition.in_region && frameOf(text, subject) == frameOf(text, other)) return;
    const Probe probe = probeOf(text, subject, other);
    const auto [known, is_new] = groups.emplace(rule.key(atom), rule.groups.size());
    if (is_new) rule.groups.emplace_back();
    Group& group = rule.groups[known->second];
    if (rule.exactly_one) {
      group.subject = fmt::format("{} (frame {})", subject, frameOf(text, subject));
      group.options.push_back({std::move(atom), {probe}, other});
    } else if (is_new) {
      group.options.push_back({std::move(atom), {probe}, ""});
    } else {
      group.options.front().probes.push_back(probe);
    }
  }

  Probe probeOf(const RuleText& text, const std::string& subject, const std::string& other) {
    Probe probe;
    probe.negated = text.condition.negated;
    if (text.condition.in_region) {
      const auto region = region_ids_.find(other);
      if (region == region_ids_.end())
        fail(text.condition.mark, "a name that stands in 'regions'", inQuotes(other));
      probe.region = region->second;
      probe.subject = pair(rules_->regions_[region->second].frame, frameOf(text, subject));
      return probe;
    }
    probe.reach = text.condition.reach;
    if (text.horizontal) {
      probe.subject = pair(defaults_.frame, frameOf(text, subject));
      probe.other = pair(defaults_.frame, frameOf(text, other));
    } else {
      probe.subject = pair(frameOf(text, other), frameOf(text, subject));
    }
    return probe;
  }

  const std::string& frameOf(const RuleText& text, const std::string& thing) const {
    const auto frame = frames_.find(thing);
    if (frame == frames_.end())
      fail(text.condition.mark, "a name that stands in 'frames'", inQuotes(thing));
    return frame->second;
  }

  std::size_t pair(const std::string& in, const std::string& of) {
    const auto [known, is_new] = pair_ids_.emplace(std::make_pair(in, of), rules_->pairs_.size());
    if (is_new) rules_->pairs_.push_back({in, of});
    return known->second;
  }

  std::shared_ptr<Rules> rules_ = std::make_shared<Rules>();
  Settings defaults_;
  std::map<std::string, std::string> frames_;      // by object
  std::map<std::string, std::size_t> region_ids_;  // by name
  std::map<std::pair<std::string, std::string>, std::size_t> pair_ids_;
  std::size_t atoms_ = 0;
};

std::shared_ptr<const Rules> Rules::fromYaml(const std::string& text,
                                             const std::string& source_name) {
  try {
    return RulesReader(source_name).read(text);
  } catch (const YamlError& error) {
    const std::string message = error.what();
    if (message.find("unknown token") == std::string::npos) throw;
    // yaml-cpp's whole answer to a plain `?who` inside of braces.
    throw YamlError(message + "; inside of { } and [ ] it wants quotes around a text with '?'");
  }
}

}  // namespace goal_alignment::spatial_facts
