// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::execution {

/// "frame cup (tf_facts.yaml:12:5)": by what the rules of the file tell the atom. "": by nothing,
/// or the file can't be read.
std::string framesOf(const GroundName& atom, const std::string& rules_file);

}  // namespace goal_alignment::execution
