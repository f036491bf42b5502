// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/spatial_facts/geometry.h"

namespace goal_alignment::spatial_facts {

/// A tf frame's name. Throws YamlError.
std::string readFrame(const YamlReader& reader, const YAML::Node& node);

/// One shape, or a list of them: `{box: {xyz: …, rpy: …, size: …}, frame: …}`. All shapes of a
/// region stand in one frame. Throws YamlError.
Region readRegion(const YamlReader& reader, const YAML::Node& node,
                  const std::string& default_frame);

}  // namespace goal_alignment::spatial_facts
