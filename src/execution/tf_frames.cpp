// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/tf_frames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"
#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::execution {
namespace {

using spatial_facts::Rule;
using spatial_facts::Rules;

std::string framesOf(const GroundName& atom, const Rules& rules) {
  const Rule* const rule = rules.ownerOf(atom);
  if (rule == nullptr) return "";
  std::set<std::string> frames;
  for (const spatial_facts::Group& group : rule->groups) {
    for (const auto& option : group.options) {
      const bool is_told =
          option.atom == atom || (rule->exactly_one && rule->key(option.atom) == rule->key(atom));
      if (!is_told) continue;
      for (const spatial_facts::Probe& probe : option.probes)
        frames.insert(rules.pairs()[probe.subject].of);
    }
  }
  return fmt::format("{} {} ({})", frames.size() == 1 ? "frame" : "frames", fmt::join(frames, ", "),
                     rule->place);
}

}  // namespace

std::string framesOf(const GroundName& atom, const std::string& rules_file) {
  if (rules_file.empty()) return "";
  try {
    const pddl::Source file = pddl::readFile(ros_common::resolveFile(rules_file));
    return framesOf(atom, *Rules::fromYaml(file.text, file.name));
  } catch (const std::exception&) {
    return "";  // the aligner says what is wrong with it
  }
}

}  // namespace goal_alignment::execution
