// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/vocabulary_file.h"

#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_interface/package_files.h"

namespace goal_alignment::ros_interface {

phrasing::Vocabulary vocabularyOf(const std::string& file) {
  const pddl::Source source = pddl::readFile(resolveFile(file));
  return phrasing::Vocabulary::fromYaml(source.text, source.name);
}

}  // namespace goal_alignment::ros_interface
