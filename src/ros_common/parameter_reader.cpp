// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/parameter_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::ros_common {

using XmlRpc::XmlRpcValue;

namespace {

// YAML as rosparam reads it takes 1e3 for a text, since no point is in it.
std::optional<double> numberIn(XmlRpcValue value) {
  if (value.getType() == XmlRpcValue::TypeDouble) return static_cast<double&>(value);
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<int&>(value);
  if (value.getType() != XmlRpcValue::TypeString) return std::nullopt;
  const std::string& text = static_cast<std::string&>(value);
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return std::nullopt;
  std::istringstream input(text);
  input.imbue(std::locale::classic());
  double number = 0;
  input >> number;
  if (input.fail() || input.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return number;
}

// What somebody wrote, in their words.
std::string described(XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return "the text " + inQuotes(static_cast<std::string&>(value));
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool&>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return fmt::format("{}", static_cast<int&>(value));
    case XmlRpcValue::TypeDouble:
      return fmt::format("{}", static_cast<double&>(value));
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeStruct:
      return "a namespace with values in it";
    default:
      return "a value of another type";
  }
}

}  // namespace

ParameterReader::ParameterReader(XmlRpcValue values, std::string ns)
    : values_(std::move(values)), namespace_(std::move(ns)) {}

XmlRpcValue* ParameterReader::find(const std::string& key) {
  known_.insert(key);
  const bool present = values_.getType() == XmlRpcValue::TypeStruct && values_.hasMember(key);
  return present ? &values_[key] : nullptr;
}

void ParameterReader::refuse(const std::string& key, const std::string& expected) const {
  const auto given = given_as_.find(key);
  throw ParameterError(fmt::format("parameter {}/{}: expected {}", namespace_,
                                   given == given_as_.end() ? key : given->second, expected));
}

void ParameterReader::refuse(const std::string& key, const std::string& expected,
                             const XmlRpcValue& found) const {
  refuse(key, fmt::format("{}, not {}", expected, described(found)));
}

void ParameterReader::read(const std::string& key, std::string& value) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeString) refuse(key, "a text", *found);
  value = static_cast<std::string&>(*found);
}

void ParameterReader::read(const std::string& key, bool& value) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeBoolean) refuse(key, "true or false", *found);
  value = static_cast<bool&>(*found);
}

void ParameterReader::read(const std::string& key, double& value, double low, double high) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = fmt::format("a number from {} to {}", low, high);
  const std::optional<double> number = numberIn(*found);
  if (!number || !(*number >= low && *number <= high)) refuse(key, expected, *found);
  value = *number;
}

void ParameterReader::read(const std::string& key, int& value, int low, int high) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  const std::optional<double> number = numberIn(*found);
  const bool is_whole = number && std::floor(*number) == *number;
  if (!is_whole || *number < low || *number > high) refuse(key, expected, *found);
  value = static_cast<int>(*number);
}

void ParameterReader::read(const std::string& key, std::vector<std::string>& names) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "a list of names";
  if (found->getType() != XmlRpcValue::TypeArray) refuse(key, expected, *found);
  names.clear();
  for (int i = 0; i < found->size(); ++i) {
    XmlRpcValue& entry = (*found)[i];
    if (entry.getType() != XmlRpcValue::TypeString)
      refuse(key, fmt::format("{}, not one with {}", expected, described(entry)));
    const std::string name = static_cast<std::string&>(entry);
    if (!isName(name)) refuse(key, fmt::format("{}, not {}", expected, inQuotes(name)));
    names.push_back(toLower(name));
  }
}

void ParameterReader::readTexts(const std::string& key, std::vector<std::string>& texts) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "a list of texts";
  if (found->getType() != XmlRpcValue::TypeArray) refuse(key, expected, *found);
  texts.clear();
  for (int i = 0; i < found->size(); ++i) {
    if ((*found)[i].getType() != XmlRpcValue::TypeString)
      refuse(key, fmt::format("{}, not one with {}", expected, described((*found)[i])));
    texts.push_back(static_cast<std::string&>((*found)[i]));
  }
}

void ParameterReader::read(const std::string& key, std::map<std::string, std::string>& texts) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "a map from names to texts";
  if (found->getType() != XmlRpcValue::TypeStruct) refuse(key, expected, *found);
  texts.clear();
  for (auto& [name, text] : *found) {
    const bool is_text = text.getType() == XmlRpcValue::TypeString;
    if (!isName(name) || !is_text || static_cast<std::string&>(text).empty())
      refuse(key, fmt::format("{}, not what stands at {}", expected, inQuotes(name)));
    texts[toLower(name)] = static_cast<std::string&>(text);
  }
}

std::size_t ParameterReader::readChoice(const std::string& key,
                                        const std::vector<std::string>& words, std::size_t value) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return value;
  const std::string expected = fmt::format("one of {}", fmt::join(words, ", "));
  if (found->getType() != XmlRpcValue::TypeString) refuse(key, expected, *found);
  const std::string& given = static_cast<std::string&>(*found);
  const auto word = std::find(words.begin(), words.end(), given);
  if (word == words.end()) refuse(key, fmt::format("{}, not {}", expected, inQuotes(given)));
  return static_cast<std::size_t>(word - words.begin());
}

void ParameterReader::renamed(const std::string& former, const std::string& key) {
  const XmlRpcValue* found = find(former);
  if (found == nullptr) return;
  renamed_.push_back(fmt::format(
      "parameter {0}/{1} is now called {0}/{2}; the name {1} will be removed in the next release",
      namespace_, former, key));
  if (values_.hasMember(key)) return;
  values_[key] = XmlRpcValue(*found);
  given_as_[key] = former;
}

std::vector<std::string> ParameterReader::warnings() const {
  std::vector<std::string> result = renamed_;
  if (values_.getType() != XmlRpcValue::TypeStruct) return result;
  // XmlRpcValue iterates only when it is not const.
  XmlRpcValue values = values_;
  for (auto& [key, value] : values) {
    if (known_.count(key) == 0 && value.getType() != XmlRpcValue::TypeStruct)
      result.push_back(fmt::format("unknown parameter {}/{}", namespace_, key));
  }
  return result;
}

}  // namespace goal_alignment::ros_common
