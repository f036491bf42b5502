// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// Message, service and action types that this program was not compiled with: read from their
/// definition files, so that a step of a plan may call any server by its type's name.
namespace goal_alignment::any_message {

/// A type that is not there or can't be read; what() names it.
class TypeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct MessageField {
  static constexpr int kSingle = -1;
  static constexpr int kAnyLength = -2;

  std::string type;  ///< of an element: `float64`, `string` … or `package/Message`
  std::string name;
  int length = kSingle;  ///< ≥ 0: an array of so many

  bool builtin() const { return type.find('/') == std::string::npos; }
};

struct MessageDefinition {
  std::string type;  ///< `package/Message`
  std::vector<MessageField> fields;
  std::string text;         ///< of the file
  std::string normal_form;  ///< what its md5 is of
  std::string md5;

  /// Null where there is none of that name.
  const MessageField* find(const std::string& name) const;
  /// For people: "a, b, c".
  std::string fieldNames() const;
};

struct ServiceDefinition {
  std::string type;  ///< `package/Name`
  MessageDefinition request;
  MessageDefinition response;
  std::string md5;
};

struct ActionDefinition {
  std::string type;  ///< `package/Name`, without "Action"
  MessageDefinition goal;
  MessageDefinition result;
  std::string goal_message_md5;   ///< of `package/NameActionGoal`,
  std::string goal_message_text;  ///< with the definitions of all its parts, as rosbag wants it
};

/// Reads definitions once each. Not thread-safe.
class MessageTypes {
 public:
  /// The text of a definition file, `folder` being msg, srv or action, or nothing.
  using Source = std::function<std::optional<std::string>(
      const std::string& package, const std::string& folder, const std::string& name)>;

  explicit MessageTypes(Source source);

  // The names are `package/Name`. All throw TypeError.
  const MessageDefinition& message(const std::string& type);
  ServiceDefinition service(const std::string& type);
  ActionDefinition action(const std::string& type);

 private:
  MessageDefinition parse(const std::string& type, const std::string& package,
                          const std::string& text);
  std::string textOf(const std::string& type, const std::string& folder) const;
  void appendPart(const MessageDefinition& definition, std::string& text);

  Source source_;
  std::map<std::string, MessageDefinition> messages_;
  std::vector<std::string> under_way_;  // against definitions that contain themselves
};

/// What is installed or built on this machine: `share/PACKAGE/FOLDER/NAME.FOLDER` below the folders
/// of $CMAKE_PREFIX_PATH, else below the package's own folder.
std::optional<std::string> installedDefinition(const std::string& package,
                                               const std::string& folder, const std::string& name);

/// Bytes of an element of the built-in type; 0: of its own length, a string. Nothing: no such type.
std::optional<std::size_t> sizeOfBuiltin(const std::string& type);

}  // namespace goal_alignment::any_message
