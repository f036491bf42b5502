// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "goal_alignment/execution/step_mapping.h"

namespace goal_alignment::execution {

/// Servers that the master knows of, some of which may have died without a word.
struct GraphView {
  std::map<std::string, std::string> actions;  ///< `package/Name` by the server's resolved name
  std::set<std::string> services;              ///< resolved names

  /// Nothing where the master can't be asked.
  static std::optional<GraphView> now();

  /// What a person may have meant who wrote that name of an action server: `; did you mean
  /// '/arm'?`, what else there is of that type, or why what is there by that name does not serve.
  std::string nearAction(const std::string& name, const std::string& type) const;
  std::string nearService(const std::string& name) const;

  /// For people, when nobody has registered the server of that rule, whose resolved name this is.
  std::string lackOf(const StepRule& rule, const std::string& name) const;
};

/// Another node that is alive and publishes the topic; a registration that a dead one left behind
/// does not count. Names are resolved.
std::optional<std::string> otherPublisher(const std::string& topic);

}  // namespace goal_alignment::execution
