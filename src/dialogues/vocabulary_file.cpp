// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/vocabulary_file.h"

#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"

namespace goal_alignment::dialogues {

phrasing::Vocabulary vocabularyOf(const std::string& file) {
  const pddl::Source source = pddl::readFile(ros_common::resolveFile(file));
  return phrasing::Vocabulary::fromYaml(source.text, source.name);
}

}  // namespace goal_alignment::dialogues
