// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/message_definition.h"

#include <fmt/format.h>
#include <ros/package.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/listed.h"
#include "goal_alignment/common/quote.h"
#include "md5.h"

namespace goal_alignment::any_message {
namespace {

constexpr std::size_t kDeepest = 50;            // messages within messages
constexpr std::size_t kLineOfDefinitions = 80;  // signs between the definitions of a text

std::string trimmedText(std::string_view text) {
  return std::string(trimmed(text));
}

// A definition's parts stand between lines of three dashes.
std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (trimmed(line) == "---") {
      parts.emplace_back();
    } else {
      parts.back() += line + "\n";
    }
  }
  return parts;
}

std::pair<std::string, std::string> splitType(const std::string& type) {
  const std::size_t slash = type.find('/');
  const auto isName = [](const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_';
    });
  };
  if (slash == std::string::npos || !isName(type.substr(0, slash)) ||
      !isName(type.substr(slash + 1))) {
    throw TypeError(fmt::format("{} is no type's name: expected package/Name", inQuotes(type)));
  }
  return {type.substr(0, slash), type.substr(slash + 1)};
}

// "float64[3]" becomes float64 and 3.
MessageField fieldOf(const std::string& declared, const std::string& name,
                     const std::string& package) {
  MessageField field;
  field.name = name;
  field.type = declared;
  const std::size_t bracket = declared.find('[');
  if (bracket != std::string::npos) {
    field.type = declared.substr(0, bracket);
    const std::string length = declared.substr(bracket + 1, declared.size() - bracket - 2);
    field.length = length.empty() ? MessageField::kAnyLength : std::atoi(length.c_str());
  }
  if (field.type == "Header") {
    field.type = "std_msgs/Header";
  } else if (field.builtin() && !sizeOfBuiltin(field.type)) {
    field.type = package + "/" + field.type;
  }
  return field;
}

}  // namespace

const MessageField* MessageDefinition::find(const std::string& name) const {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const MessageField& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

std::string MessageDefinition::fieldNames() const {
  if (fields.empty()) return "none";
  return listed(fields, [](const MessageField& field) { return field.name; });
}

std::optional<std::size_t> sizeOfBuiltin(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"bool", 1},    {"int8", 1},  {"uint8", 1},    {"byte", 1},  {"char", 1},   {"int16", 2},
      {"uint16", 2},  {"int32", 4}, {"uint32", 4},   {"int64", 8}, {"uint64", 8}, {"float32", 4},
      {"float64", 8}, {"time", 8},  {"duration", 8}, {"string", 0}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? std::nullopt : std::make_optional(found->second);
}

MessageTypes::MessageTypes(Source source) : source_(std::move(source)) {}

std::string MessageTypes::textOf(const std::string& type, const std::string& folder) const {
  const auto [package, name] = splitType(type);
  if (const auto text = source_(package, folder, name)) return *text;
  throw TypeError(fmt::format("the type {} is not known: no {}/{}.{} of package {} is installed",
                              type, folder, name, folder, package));
}

const MessageDefinition& MessageTypes::message(const std::string& type) {
  const auto known = messages_.find(type);
  if (known != messages_.end()) return known->second;
  const std::string text = textOf(type, "msg");
  if (under_way_.size() > kDeepest ||
      std::find(under_way_.begin(), under_way_.end(), type) != under_way_.end()) {
    throw TypeError(fmt::format("the type {} contains itself", type));
  }
  under_way_.push_back(type);
  try {
    MessageDefinition definition = parse(type, splitType(type).first, text);
    under_way_.pop_back();
    return messages_.emplace(type, std::move(definition)).first->second;
  } catch (...) {
    under_way_.clear();
    throw;
  }
}

// The md5 is that of a normal form (genmsg.gentools): first the constants, then the fields, with
// the md5 of other messages in place of their types.
MessageDefinition MessageTypes::parse(const std::string& type, const std::string& package,
                                      const std::string& text) {
  MessageDefinition definition;
  definition.type = type;
  definition.text = text;
  std::string constants;
  std::string fields;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = trimmedText(std::string_view(line).substr(0, line.find('#')));
    if (code.empty()) continue;
    std::istringstream words(code);
    std::string declared;
    std::string name;
    words >> declared >> name;
    const std::size_t equals = code.find('=');
    if (equals != std::string::npos) {
      name = trimmedText(std::string_view(code).substr(declared.size(), equals - declared.size()));
      // Of a text all of the line is the value, comments too.
      const std::string value =
          trimmedText(std::string_view(declared == "string" ? line : code)
                          .substr((declared == "string" ? line : code).find('=') + 1));
      constants += fmt::format("{} {}={}\n", declared, name, value);
      continue;
    }
    std::string more;
    if (name.empty() || words >> more) {
      throw TypeError(fmt::format("{}: {} is no field of a message", type, inQuotes(code)));
    }
    const MessageField field = fieldOf(declared, name, package);
    fields += (field.builtin() ? declared : message(field.type).md5) + " " + name + "\n";
    definition.fields.push_back(field);
  }
  definition.normal_form = trimmedText(constants + fields);
  definition.md5 = md5Of(definition.normal_form);
  return definition;
}

ServiceDefinition MessageTypes::service(const std::string& type) {
  const std::vector<std::string> parts = partsOf(textOf(type, "srv"));
  if (parts.size() != 2) throw TypeError(fmt::format("{} is no service: no line of ---", type));
  const std::string package = splitType(type).first;
  ServiceDefinition service;
  service.type = type;
  service.request = parse(type + "Request", package, parts[0]);
  service.response = parse(type + "Response", package, parts[1]);
  service.md5 = md5Of(service.request.normal_form + service.response.normal_form);
  return service;
}

ActionDefinition MessageTypes::action(const std::string& type) {
  const auto [package, name] = splitType(type);
  ActionDefinition action;
  action.type = type;
  // A definition file of the action, or the messages that were made of it.
  if (const auto text = source_(package, "action", name)) {
    const std::vector<std::string> parts = partsOf(*text);
    if (parts.size() != 3) throw TypeError(fmt::format("{} is no action: not three parts", type));
    action.goal = parse(type + "Goal", package, parts[0]);
    action.result = parse(type + "Result", package, parts[1]);
  } else {
    action.goal = message(type + "Goal");
    action.result = message(type + "Result");
  }
  action.goal_message_text =
      "std_msgs/Header header\nactionlib_msgs/GoalID goal_id\n" + type + "Goal goal\n";
  for (const MessageDefinition* part :
       {&message("std_msgs/Header"), &message("actionlib_msgs/GoalID"),
        static_cast<const MessageDefinition*>(&action.goal)}) {
    appendPart(*part, action.goal_message_text);
  }
  action.goal_message_md5 =
      md5Of(message("std_msgs/Header").md5 + " header\n" + message("actionlib_msgs/GoalID").md5 +
            " goal_id\n" + action.goal.md5 + " goal");
  return action;
}

// With those of its parts; each once.
void MessageTypes::appendPart(const MessageDefinition& definition, std::string& text) {
  const std::string title = "MSG: " + definition.type + "\n";
  if (text.find(title) != std::string::npos) return;
  text += std::string(kLineOfDefinitions, '=') + "\n" + title + definition.text;
  for (const MessageField& field : definition.fields) {
    if (!field.builtin()) appendPart(message(field.type), text);
  }
}

std::optional<std::string> installedDefinition(const std::string& package,
                                               const std::string& folder, const std::string& name) {
  std::vector<std::string> places;
  const char* prefixes = std::getenv("CMAKE_PREFIX_PATH");
  std::istringstream split(prefixes == nullptr ? "" : prefixes);
  for (std::string prefix; std::getline(split, prefix, ':');)
    places.push_back(prefix + "/share/" + package);
  const std::string own = ros::package::getPath(package);
  if (!own.empty()) places.push_back(own);
  for (const std::string& place : places) {
    std::ifstream file(place + "/" + folder + "/" + name + "." + folder);
    if (!file) continue;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  return std::nullopt;
}

}  // namespace goal_alignment::any_message
