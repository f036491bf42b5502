// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/step_mapping.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "goal_alignment/any_message/message_codec.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/execution/simulated_frames.h"

namespace goal_alignment::execution {
namespace {

constexpr double kLongestTimeout = 86400;  // seconds
constexpr double kLongestStep = 3600;      // seconds
constexpr int kMaxRetries = 1000;
constexpr int kMaxFailures = 1000000;

using Words = std::vector<std::string>;
constexpr const char* kTimeout = "server_timeout";
constexpr const char* kFormerTimeout = "server_patience";             // until the next release
const Words kKinds = {"action", "service", "dispatch", "simulated"};  // as StepKind
// Keys of every kind, and those of each.
const Words kCommonKeys = {"kind", "timeout", "retries", "on_failure", "failure_facts", "duration"};
const std::vector<Words> kKeys = {{"name", "type", "goal", "success_field", kTimeout},
                                  {"name", "type", "request", "success_field", kTimeout},
                                  {kTimeout},
                                  {"failure_probability", "moves"}};

/// Fills a StepMapping from YAML and knows, for its errors, where everything stands.
class MappingReader : private YamlReader {
 public:
  MappingReader(const std::string& source, any_message::MessageTypes& types,
                std::optional<StepKind> default_kind)
      : YamlReader(source), types_(types) {
    mapping_.source = source;
    if (default_kind) mapping_.fallback.emplace().kind = *default_kind;
  }

  StepMapping read(const std::string& text) {
    load(text, [this](const YAML::Node& root) { readSections(root); });
    return std::move(mapping_);
  }

 private:
  [[noreturn]] void fail(const YAML::Node& at, const std::string& message) const {
    failAt(at.Mark(), message);
  }

  [[noreturn]] void expect(const YAML::Node& found, const std::string& expected) const {
    YamlReader::fail(found.Mark(), expected, describe(found));
  }

  int whole(const YAML::Node& node, int low, int high) const {
    int value = 0;
    if (!node.IsScalar() || !YAML::convert<int>::decode(node, value) || value < low ||
        value > high) {
      expect(node, fmt::format("a whole number from {} to {}", low, high));
    }
    return value;
  }

  std::size_t word(const YAML::Node& node, const Words& words) const {
    const auto found = std::find(words.begin(), words.end(), node.IsScalar() ? node.Scalar() : "");
    if (found == words.end()) expect(node, fmt::format("one of {}", fmt::join(words, ", ")));
    return static_cast<std::size_t>(found - words.begin());
  }

  /// Each key once, and one of `keys`; empty: any.
  void checkMap(const YAML::Node& map, const std::string& what, const Words& keys) const {
    if (!map.IsMap()) expect(map, what);
    std::set<std::string> seen;
    for (const auto& entry : map) {
      const std::string key = text(entry.first, "a key");
      if (!seen.insert(toLower(key)).second) fail(entry.first, inQuotes(key) + " stands twice");
      if (keys.empty() || std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      fail(entry.first,
           fmt::format("unknown key {}: expected one of {}", inQuotes(key), fmt::join(keys, ", ")));
    }
  }

  void readSections(const YAML::Node& root) {
    checkMap(root, "a map of tables, default, actions, frames and failures",
             {"tables", "default", "actions", "frames", "failures"});
    readTables(root["tables"]);
    const YAML::Node fallback = root["default"];
    if (isGiven(fallback))
      mapping_.fallback =
          rule(fallback, mapping_.fallback.value_or(StepRule{}), mapping_.fallback.has_value());
    const YAML::Node actions = root["actions"];
    if (isGiven(actions)) checkMap(actions, "a map from actions to how they are carried out", {});
    for (const auto& entry : actions) {
      StepRule& found = mapping_.rules[toLower(entry.first.Scalar())];
      found =
          rule(entry.second, mapping_.fallback.value_or(StepRule{}), mapping_.fallback.has_value());
      found.key.reset(entry.first);
    }
    readFrames(root["frames"]);
    readFailures(root["failures"]);
  }

  static bool isGiven(const YAML::Node& node) { return node.IsDefined() && !node.IsNull(); }

  void readTables(const YAML::Node& tables) {
    if (!isGiven(tables)) return;
    checkMap(tables, "a map from names to tables", {});
    for (const auto& table : tables)
      checkMap(table.second, "a map from objects to what they stand for", {});
    mapping_.tables = tables;
  }

  /// What is not said is as in `inherited`, whose kind counts where `has_kind`.
  StepRule rule(const YAML::Node& node, const StepRule& inherited, bool has_kind) {
    if (!node.IsMap()) expect(node, "a map that says how the action is carried out");
    const YAML::Node kind = node["kind"];
    if (!kind.IsDefined() && !has_kind) fail(node, "no `kind`, and none in `default`");
    StepRule rule;
    rule.kind = kind.IsDefined() ? static_cast<StepKind>(word(kind, kKinds)) : inherited.kind;
    if (rule.kind == inherited.kind) {
      rule = inherited;
    } else {
      rule.timeout = inherited.timeout;
      rule.retries = inherited.retries;
      rule.server_timeout = inherited.server_timeout;
      rule.stop_on_failure = inherited.stop_on_failure;
      rule.duration = inherited.duration;
    }
    Words keys = kCommonKeys;
    const Words& more = kKeys[static_cast<std::size_t>(rule.kind)];
    keys.insert(keys.end(), more.begin(), more.end());
    if (node[kFormerTimeout] && keys.back() == kTimeout) keys.emplace_back(kFormerTimeout);
    checkMap(node, "a map", keys);
    readCommon(node, rule);
    readServer(node, rule);
    readSimulation(node, rule);
    return rule;
  }

  void readCommon(const YAML::Node& node, StepRule& rule) {
    if (const auto timeout = node["timeout"])
      rule.timeout = number(timeout, "a number", 0, kLongestTimeout);
    if (const auto retries = node["retries"]) rule.retries = whole(retries, 0, kMaxRetries);
    readServerTimeout(node, rule);
    if (const auto on_failure = node["on_failure"])
      rule.stop_on_failure = word(on_failure, {"replan", "stop"}) == 1;
    if (const auto duration = node["duration"])
      rule.duration = number(duration, "a number", 0, kLongestStep);
    if (const auto facts = node["failure_facts"]) {
      expectList(facts, "a list of texts such as \"(not (open {door}))\"");
      rule.failure_facts.clear();
      for (const auto& fact : facts) {
        text(fact, "a text such as \"(not (open {door}))\"");
        rule.failure_facts.push_back(fact);
      }
    }
  }

  void readServerTimeout(const YAML::Node& node, StepRule& rule) {
    for (const char* key : {kFormerTimeout, kTimeout}) {
      if (const auto timeout = node[key])
        rule.server_timeout = number(timeout, "a number", 0, kLongestTimeout);
    }
    if (const auto former = node[kFormerTimeout]) {
      mapping_.warnings.push_back(
          fmt::format("{}: {} is now called {}; the name {} will be removed in the next release",
                      place(former.Mark()), kFormerTimeout, kTimeout, kFormerTimeout));
    }
  }

  void readServer(const YAML::Node& node, StepRule& rule) {
    const bool is_action = rule.kind == StepKind::Action;
    if (!is_action && rule.kind != StepKind::Service) return;
    if (const auto name = node["name"]) {
      text(name, "the name of the server");
      rule.name.reset(name);  // assigned, it would become that of the rule it is inherited from
    } else if (!rule.name.IsScalar()) {
      fail(node, "no `name` of a server");
    }
    try {
      if (const auto type = node["type"]) readType(text(type, "package/Name"), rule);
    } catch (const any_message::TypeError& error) {
      fail(node["type"], error.what());
    }
    if (!rule.action && !rule.service) fail(node, "no `type` of the server: package/Name");
    const any_message::MessageDefinition& sent =
        is_action ? rule.action->goal : rule.service->request;
    if (const auto fields = node[is_action ? "goal" : "request"]) rule.fields.reset(fields);
    check(types_, sent, rule.fields, mapping_.source);
    readSuccess(node["success_field"], is_action ? rule.action->result : rule.service->response,
                rule);
  }

  void readType(const std::string& type, StepRule& rule) {
    if (rule.kind == StepKind::Action) {
      rule.action = types_.action(type);
    } else {
      rule.service = types_.service(type);
    }
  }

  /// The name of a field that must be true, or a map from fields to what they must be.
  void readSuccess(const YAML::Node& node, const any_message::MessageDefinition& definition,
                   StepRule& rule) {
    if (!isGiven(node)) return;
    rule.success.clear();
    if (node.IsScalar()) {
      rule.success.emplace_back(node.Scalar(), YAML::Node("true"));
    } else {
      checkMap(node, "a field of " + definition.type + ", or a map from fields to values", {});
      for (const auto& entry : node)
        rule.success.emplace_back(entry.first.Scalar(), entry.second);
    }
    for (const auto& [path, expected] : rule.success) {
      if (!expected.IsScalar()) expect(expected, "a single value");
      try {
        const std::string type = any_message::typeAt(types_, definition, path);
        if (node.IsScalar() && type != "bool")
          fail(node, fmt::format("{} is a {}: expected a field that is true or false", path, type));
      } catch (const any_message::TypeError& error) {
        fail(node, error.what());
      }
    }
  }

  void readSimulation(const YAML::Node& node, StepRule& rule) const {
    if (const auto probability = node["failure_probability"])
      rule.failure_probability = number(probability, "a number", 0, 1);
    const YAML::Node moves = node["moves"];
    if (!isGiven(moves)) return;
    expectList(moves, "a list of moves {frame, to, parent}");
    rule.moves.clear();
    for (const auto& move : moves) {
      checkMap(move, "a map of frame, to and parent", {"frame", "to", "parent"});
      if (!move["frame"]) fail(move, "no `frame` to move");
      if (!move["to"] && !move["parent"]) fail(move, "neither `to` nor `parent`");
      text(move["frame"], "the name of a frame");
      FrameMove entry;
      entry.frame = move["frame"];
      if (move["parent"]) {
        text(move["parent"], "the name of a frame");
        entry.parent = move["parent"];
      }
      if (move["to"]) entry.to = move["to"];
      rule.moves.push_back(entry);
    }
  }

  void readFrames(const YAML::Node& frames) {
    if (!isGiven(frames)) return;
    checkMap(frames, "a map from frames to where they are", {});
    for (const auto& entry : frames) {
      checkMap(entry.second, "a map of parent and pose", {"parent", "pose"});
      const YAML::Node parent = entry.second["parent"];
      if (!parent.IsDefined()) fail(entry.second, "no `parent` of the frame");
      InitialFrame frame{entry.first.Scalar(), text(parent, "the name of a frame"), {}};
      if (const auto pose = entry.second["pose"]) frame.pose = pose;
      poseOf(frame.pose, mapping_.source);
      mapping_.frames.push_back(frame);
    }
    for (const auto& entry : frames)
      refuseCircle(entry.first);
  }

  void refuseCircle(const YAML::Node& name) const {
    std::string at = name.Scalar();
    for (std::size_t i = 0; i <= mapping_.frames.size(); ++i) {
      const auto frame = std::find_if(mapping_.frames.begin(), mapping_.frames.end(),
                                      [&](const InitialFrame& each) { return each.name == at; });
      if (frame == mapping_.frames.end()) return;
      at = frame->parent;
    }
    fail(name, fmt::format("the frame {} hangs from itself", inQuotes(name.Scalar())));
  }

  void readFailures(const YAML::Node& failures) {
    if (!isGiven(failures)) return;
    checkMap(failures, "a map from ground actions to how many tries fail", {});
    for (const auto& entry : failures) {
      const bool always = entry.second.IsScalar() && entry.second.Scalar() == "always";
      const int count = always ? StepRule::kAlways : whole(entry.second, 0, kMaxFailures);
      try {
        mapping_.failures[GroundName::parse(entry.first.Scalar())] = count;
      } catch (const std::invalid_argument& error) {
        fail(entry.first, error.what());
      }
    }
  }

  any_message::MessageTypes& types_;
  StepMapping mapping_;
};

}  // namespace

const StepRule* StepMapping::find(const std::string& action) const {
  const auto found = rules.find(toLower(action));
  if (found != rules.end()) return &found->second;
  return fallback ? &*fallback : nullptr;
}

StepMapping StepMapping::fromYaml(const std::string& text, const std::string& source,
                                  any_message::MessageTypes& types,
                                  std::optional<StepKind> default_kind) {
  return MappingReader(source, types, default_kind).read(text);
}

}  // namespace goal_alignment::execution
