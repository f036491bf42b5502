// SPDX-License-Identifier: BSD-3-Clause
#include "rule_text.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::spatial_facts {

namespace {

constexpr double kLongestAge = std::numeric_limits<double>::infinity();
constexpr double kShortestAge = 0.01;
constexpr double kLargestMargin = 1000;
constexpr double kLongestReach = 1e6;

constexpr const char* kConditions =
    "'A in REGION', 'A outside REGION', 'A within METRES of B' or 'A beyond METRES of B'";

/// Reads one rule; each part may refer to the variables, which are read first.
class RuleReader {
 public:
  RuleReader(const YamlReader& reader, const Settings& defaults) : reader_(reader) {
    rule_.settings = defaults;
  }

  RuleText read(const YAML::Node& node) {
    const auto fields = reader_.fields(node, "a rule: a map with fact, when, for",
                                       {"fact", "when", "for", "exactly_one", "otherwise",
                                        "horizontal", "max_age", "margin", "unknown"});
    for (const char* name : {"fact", "when"}) {
      if (fields.count(name) == 0)
        reader_.fail(node.Mark(), std::string("a rule with '") + name + "'", "none");
    }
    if (const auto bound = fields.find("for"); bound != fields.end()) readVariables(bound->second);
    readFact(fields.at("fact"));
    readCondition(fields.at("when"));
    readSettings(reader_, fields, rule_.settings);
    if (const auto flat = fields.find("horizontal"); flat != fields.end()) {
      rule_.horizontal = flag(flat->second);
      if (rule_.horizontal && rule_.condition.in_region)
        reader_.fail(flat->second.Mark(), "horizontal only with 'within' or 'beyond'", "a region");
    }
    if (const auto one = fields.find("exactly_one"); one != fields.end())
      readExactlyOne(one->second);
    if (const auto other = fields.find("otherwise"); other != fields.end())
      readOtherwise(other->second);
    checkUse(fields.at("fact"));
    return std::move(rule_);
  }

 private:
  bool flag(const YAML::Node& node) const {
    bool value = false;
    if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value))
      reader_.fail(node.Mark(), "true or false", YamlReader::describe(node));
    return value;
  }

  void readVariables(const YAML::Node& node) {
    reader_.expectMap(node, "for: a map from variables to their objects");
    for (const auto& entry : node) {
      Variable variable;
      variable.name = toLower(reader_.text(entry.first, "a variable's name"));
      if (variable.name.front() == '?') variable.name.erase(0, 1);
      if (find(variable.name))
        reader_.fail(entry.first.Mark(), "each name once", inQuotes(variable.name) + " again");
      readValues(entry.second, variable);
      rule_.variables.push_back(std::move(variable));
    }
  }

  void readValues(const YAML::Node& node, Variable& variable) const {
    if (!node.IsSequence()) {
      variable.values = {readName(reader_, node, "an object or a list of them")};
      return;
    }
    for (const auto& item : node) {
      std::string name = readName(reader_, item, "an object");
      const auto& known = variable.values;
      if (std::find(known.begin(), known.end(), name) != known.end())
        reader_.fail(item.Mark(), "each object once", inQuotes(name) + " again");
      variable.values.push_back(std::move(name));
    }
    if (variable.values.empty()) reader_.fail(node.Mark(), "an object", "none");
  }

  std::optional<std::size_t> find(const std::string& variable) const {
    for (std::size_t i = 0; i < rule_.variables.size(); ++i) {
      if (rule_.variables[i].name == variable) return i;
    }
    return std::nullopt;
  }

  Term term(const YAML::Mark& mark, const std::string& text) const {
    Term result;
    result.name = toLower(text);
    if (result.name.front() != '?') return result;
    result.variable = find(result.name.substr(1));
    if (!result.variable)
      reader_.fail(mark, "a variable that stands in 'for'", inQuotes(result.name));
    return result;
  }

  void readFact(const YAML::Node& node) {
    rule_.mark = node.Mark();
    const char* const what = "fact: an atom such as (at ?who ?room)";
    try {
      rule_.fact = GroundName::parse(reader_.text(node, what));
    } catch (const std::invalid_argument& error) {
      reader_.fail(node.Mark(), what, error.what());
    }
    for (const std::string& argument : rule_.fact.arguments)
      rule_.arguments.push_back(term(node.Mark(), argument));
  }

  void readCondition(const YAML::Node& node) {
    const std::string text = reader_.text(node, kConditions);
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
      words.push_back(std::move(word));
    // "1.2 m of" may be written, too.
    if (words.size() == 6 && words[3] == "m") words.erase(words.begin() + 3);
    Condition& condition = rule_.condition;
    condition.mark = node.Mark();
    if (words.size() == 3 && (words[1] == "in" || words[1] == "outside")) {
      condition.in_region = true;
      condition.negated = words[1] == "outside";
    } else if (words.size() == 5 && (words[1] == "within" || words[1] == "beyond") &&
               words[3] == "of") {
      condition.negated = words[1] == "beyond";
      condition.reach = metres(node, words[2]);
    } else {
      reader_.fail(node.Mark(), kConditions, inQuotes(text));
    }
    condition.subject = term(node.Mark(), words.front());
    condition.other = term(node.Mark(), words.back());
  }

  double metres(const YAML::Node& node, const std::string& word) const {
    double value = 0;
    const bool read = YAML::convert<double>::decode(YAML::Node(word), value);
    if (!read || !(value > 0 && value <= kLongestReach))
      reader_.fail(node.Mark(), "metres, more than 0 and at most 1000000", inQuotes(word));
    return value;
  }

  void readExactlyOne(const YAML::Node& node) {
    std::string name = toLower(reader_.text(node, "exactly_one: a variable"));
    if (name.front() == '?') name.erase(0, 1);
    rule_.exactly_one = find(name);
    const Condition& condition = rule_.condition;
    const bool is_region =
        rule_.exactly_one && condition.in_region && condition.other.variable == rule_.exactly_one;
    if (!is_region || condition.negated)
      reader_.fail(node.Mark(), "exactly_one: the variable behind 'in'", inQuotes(name));
    if (condition.subject.variable == rule_.exactly_one)
      reader_.fail(node.Mark(), "a thing that is no region", inQuotes(name));
  }

  void readOtherwise(const YAML::Node& node) {
    if (!rule_.exactly_one) reader_.fail(node.Mark(), "otherwise only with exactly_one", "none");
    const std::string word = readName(reader_, node, "unknown, nothing, nearest or an object");
    if (word == "unknown") {
      rule_.otherwise = Otherwise::Unknown;
    } else if (word == "nothing") {
      rule_.otherwise = Otherwise::Nothing;
    } else if (word == "nearest") {
      rule_.otherwise = Otherwise::Nearest;
    } else {
      rule_.otherwise = Otherwise::Object;
      rule_.otherwise_object = word;
    }
  }

  // A variable that nobody reads is a slip, and one argument of exactly_one is what it is about.
  void checkUse(const YAML::Node& fact) const {
    for (std::size_t i = 0; i < rule_.variables.size(); ++i) {
      const auto is_it = [i](const Term& term) { return term.variable == i; };
      const auto uses = std::count_if(rule_.arguments.begin(), rule_.arguments.end(), is_it);
      const std::string name = "'?" + rule_.variables[i].name + "'";
      if (uses > 1) reader_.fail(fact.Mark(), "each variable once", name + " again");
      if (uses == 1) continue;
      if (rule_.exactly_one) reader_.fail(fact.Mark(), name + " in the fact", "none");
      if (!is_it(rule_.condition.subject) && !is_it(rule_.condition.other))
        reader_.fail(fact.Mark(), name + " in the fact or in 'when'", "none");
    }
  }

  const YamlReader& reader_;
  RuleText rule_;
};

}  // namespace

std::string readName(const YamlReader& reader, const YAML::Node& node, const std::string& what) {
  const std::string text = reader.text(node, what);
  try {
    GroundName name = GroundName::parse(text);
    if (name.arguments.empty() && name.name == toLower(text) && name.name.front() != '?')
      return name.name;
  } catch (const std::invalid_argument&) {
    // what is no name is refused below, like any other
  }
  reader.fail(node.Mark(), what, inQuotes(text));
}

void readSettings(const YamlReader& reader, const YamlReader::Fields& fields, Settings& settings) {
  if (const auto age = fields.find("max_age"); age != fields.end())
    settings.max_age = reader.number(age->second, "max_age: seconds", kShortestAge, kLongestAge);
  if (const auto margin = fields.find("margin"); margin != fields.end())
    settings.margin = reader.number(margin->second, "margin: metres", 0, kLargestMargin);
  const auto unknown = fields.find("unknown");
  if (unknown == fields.end()) return;
  const std::string word = reader.text(unknown->second, "fail or trust_file");
  if (word != "fail" && word != "trust_file")
    reader.fail(unknown->second.Mark(), "unknown: fail or trust_file", inQuotes(word));
  settings.unknown = word == "fail" ? Unknown::Fail : Unknown::TrustFile;
}

RuleText readRule(const YamlReader& reader, const YAML::Node& node, const Settings& defaults) {
  return RuleReader(reader, defaults).read(node);
}

}  // namespace goal_alignment::spatial_facts
