// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/phrasing/template_text.h"

namespace goal_alignment::phrasing {

/// A YAML reader that knows texts with gaps.
class TemplateReader : public YamlReader {
 public:
  using YamlReader::YamlReader;

  TemplateText sentence(const YAML::Node& node, const std::string& what) const {
    try {
      return TemplateText::parse(text(node, what));
    } catch (const std::invalid_argument& exception) {
      failAt(node.Mark(), exception.what());
    }
  }
};

}  // namespace goal_alignment::phrasing
