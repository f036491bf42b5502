// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/HumanTask.h"

namespace goal_alignment::nodes {

/// A task from YAML: `task_id`, `person`, and the lists `goal` and `plan` of texts such as
/// `(on a b)`; all of them may be left out. Throws YamlError.
HumanTask taskOfYaml(const std::string& text, const std::string& source_name);

/// The same from a file, which may be relative to the package's folder. Throws pddl::InputError,
/// too.
HumanTask taskOfFile(const std::string& file);

}  // namespace goal_alignment::nodes
