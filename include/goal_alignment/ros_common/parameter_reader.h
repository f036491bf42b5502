// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace goal_alignment::ros_common {

/// A parameter of the wrong type or out of its range; what() names key and namespace.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes typed values out of one namespace of the parameter server and remembers which keys it
/// was asked for. Values that are not there leave the default; every other fault throws
/// ParameterError naming key, namespace, what was expected and what was found. A text that is a
/// number counts as one, and so does 2048.0 as a whole one.
class ParameterReader {
 public:
  ParameterReader(XmlRpc::XmlRpcValue values, std::string ns);

  void read(const std::string& key, std::string& value);
  void read(const std::string& key, bool& value);
  void read(const std::string& key, double& value, double low, double high);
  void read(const std::string& key, int& value, int low, int high);
  /// A list of PDDL names; they come out in lower case.
  void read(const std::string& key, std::vector<std::string>& names);
  /// A list of any texts.
  void readTexts(const std::string& key, std::vector<std::string>& texts);
  /// A struct with a text for each PDDL name; the names come out in lower case.
  void read(const std::string& key, std::map<std::string, std::string>& texts);
  /// Index of the word found among `words`; `value` where the key is not there.
  std::size_t readChoice(const std::string& key, const std::vector<std::string>& words,
                         std::size_t value);

  /// A value that stands under the key's former name, and not under its new one, counts for the
  /// new one. Before the key is read.
  void renamed(const std::string& former, const std::string& key);

  /// What the reader would tell the user, one sentence each: keys under their former names, and
  /// keys that were not asked for; namespaces below this one are not looked at.
  std::vector<std::string> warnings() const;

  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& expected,
                           const XmlRpc::XmlRpcValue& found) const;

  // Null where the key is not there.
  XmlRpc::XmlRpcValue* find(const std::string& key);

  XmlRpc::XmlRpcValue values_;
  std::string namespace_;
  std::set<std::string> known_;
  std::map<std::string, std::string> given_as_;  // by key: the former name that its value has
  std::vector<std::string> renamed_;             // warnings
};

}  // namespace goal_alignment::ros_common
