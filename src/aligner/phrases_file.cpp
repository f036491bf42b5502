// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/aligner/phrases_file.h"

#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"

namespace goal_alignment::aligner {

phrasing::Phrases phrasesOf(const std::string& file) {
  if (file.empty()) return {};
  const pddl::Source source = pddl::readFile(ros_common::resolveFile(file));
  return phrasing::Phrases::fromYaml(source.text, source.name);
}

}  // namespace goal_alignment::aligner
