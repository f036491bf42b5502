// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/parameter_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {

using XmlRpc::XmlRpcValue;

ParameterReader::ParameterReader(XmlRpcValue values, std::string ns)
    : values_(std::move(values)), namespace_(std::move(ns)) {}

XmlRpcValue* ParameterReader::find(const std::string& key) {
  known_.insert(key);
  const bool present = values_.getType() == XmlRpcValue::TypeStruct && values_.hasMember(key);
  return present ? &values_[key] : nullptr;
}

void ParameterReader::refuse(const std::string& key, const std::string& expected) const {
  throw ParameterError(fmt::format("parameter {}/{}: expected {}", namespace_, key, expected));
}

void ParameterReader::read(const std::string& key, std::string& value) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeString) refuse(key, "a text");
  value = static_cast<std::string&>(*found);
}

void ParameterReader::read(const std::string& key, bool& value) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeBoolean) refuse(key, "true or false");
  value = static_cast<bool&>(*found);
}

void ParameterReader::read(const std::string& key, double& value, double low, double high) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = fmt::format("a number from {} to {}", low, high);
  double number = 0;
  if (found->getType() == XmlRpcValue::TypeDouble) {
    number = static_cast<double&>(*found);
  } else if (found->getType() == XmlRpcValue::TypeInt) {
    number = static_cast<int&>(*found);
  } else {
    refuse(key, expected);
  }
  if (!(number >= low && number <= high)) refuse(key, fmt::format("{}, not {}", expected, number));
  value = number;
}

void ParameterReader::read(const std::string& key, int& value, int low, int high) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  if (found->getType() != XmlRpcValue::TypeInt) refuse(key, expected);
  const int number = static_cast<int&>(*found);
  if (number < low || number > high) refuse(key, fmt::format("{}, not {}", expected, number));
  value = number;
}

void ParameterReader::read(const std::string& key, std::vector<std::string>& names) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "a list of names";
  if (found->getType() != XmlRpcValue::TypeArray) refuse(key, expected);
  names.clear();
  for (int i = 0; i < found->size(); ++i) {
    XmlRpcValue& entry = (*found)[i];
    if (entry.getType() != XmlRpcValue::TypeString) refuse(key, expected);
    const std::string name = static_cast<std::string&>(entry);
    if (!isName(name)) refuse(key, fmt::format("{}, not {}", expected, inQuotes(name)));
    names.push_back(toLower(name));
  }
}

void ParameterReader::readTexts(const std::string& key, std::vector<std::string>& texts) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "a list of texts";
  if (found->getType() != XmlRpcValue::TypeArray) refuse(key, expected);
  texts.clear();
  for (int i = 0; i < found->size(); ++i) {
    if ((*found)[i].getType() != XmlRpcValue::TypeString) refuse(key, expected);
    texts.push_back(static_cast<std::string&>((*found)[i]));
  }
}

void ParameterReader::read(const std::string& key, std::map<std::string, std::string>& texts) {
  XmlRpcValue* found = find(key);
  if (found == nullptr) return;
  const std::string expected = "texts by names";
  if (found->getType() != XmlRpcValue::TypeStruct) refuse(key, expected);
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
  if (found->getType() != XmlRpcValue::TypeString) refuse(key, expected);
  const std::string& given = static_cast<std::string&>(*found);
  const auto word = std::find(words.begin(), words.end(), given);
  if (word == words.end()) refuse(key, fmt::format("{}, not {}", expected, inQuotes(given)));
  return static_cast<std::size_t>(word - words.begin());
}

std::vector<std::string> ParameterReader::unknown() const {
  std::vector<std::string> keys;
  if (values_.getType() != XmlRpcValue::TypeStruct) return keys;
  // XmlRpcValue iterates only when it is not const.
  XmlRpcValue values = values_;
  for (auto& [key, value] : values) {
    if (known_.count(key) == 0 && value.getType() != XmlRpcValue::TypeStruct) keys.push_back(key);
  }
  return keys;
}

}  // namespace goal_alignment::ros_interface
