// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/phrasing/frames.h"
#include "template_reader.h"

namespace goal_alignment::phrasing {

/// Fills a Frames from YAML.
class FramesReader : private TemplateReader {
 public:
  /// `base` has all names there are; null: those of the document are.
  FramesReader(const std::string& source_name, const Frames* base)
      : TemplateReader(source_name), base_(base) {}

  /// A document of its own, which should have all.
  Frames read(const std::string& text);
  /// A part of a document: what stands there replaces that of `base`.
  Frames over(const YAML::Node& texts);

 private:
  void readAll(const YAML::Node& texts);
  void readEntry(const YAML::Node& key, const YAML::Node& value);
  void checkGaps(const std::string& name, const YAML::Node& value, const TemplateText& text) const;

  const Frames* base_;
  Frames frames_;
};

}  // namespace goal_alignment::phrasing
