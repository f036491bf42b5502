// SPDX-License-Identifier: BSD-3-Clause
#include "frames_reader.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::phrasing {

namespace {

/// These texts hold details that the program gives in English only: of limits, tf and failed steps.
bool mayBeLeftOut(const std::string& name) {
  const std::set<std::string> names = {"out_of_time_in", "out_of_memory_in", "out_of_budget_in",
                                       "facts_unknown", "story_trouble"};
  return names.count(name) > 0;
}

std::string gapsAsWritten(const std::set<std::size_t>& gaps) {
  if (gaps.empty()) return "no gap";
  std::string text;
  for (const std::size_t gap : gaps)
    text += (text.empty() ? "{" : " and {") + std::to_string(gap) + "}";
  return text;
}

}  // namespace

Frames FramesReader::read(const std::string& text) {
  load(text, [this](const YAML::Node& document) { readAll(document); });
  if (base_ == nullptr) return std::move(frames_);
  for (const auto& [name, english] : base_->texts_) {
    if (frames_.texts_.emplace(name, english).second) frames_.missing_.insert(name);
  }
  return std::move(frames_);
}

Frames FramesReader::over(const YAML::Node& texts) {
  readAll(texts);
  frames_.texts_.insert(base_->texts_.begin(), base_->texts_.end());
  return std::move(frames_);
}

void FramesReader::readAll(const YAML::Node& texts) {
  expectMap(texts, "a map from names to texts");
  for (const auto& entry : texts)
    readEntry(entry.first, entry.second);
}

void FramesReader::readEntry(const YAML::Node& key, const YAML::Node& value) {
  const std::string name = text(key, "the name of a text");
  if (base_ != nullptr && base_->texts_.count(name) == 0)
    fail(key.Mark(), "a name that config/phrases/en.yaml has", inQuotes(name));
  TemplateText read = sentence(value, "a text");
  if (base_ != nullptr) checkGaps(name, value, read);
  if (!frames_.texts_.emplace(name, std::move(read)).second)
    fail(key.Mark(), "each name once", inQuotes(name) + " again");
}

void FramesReader::checkGaps(const std::string& name, const YAML::Node& value,
                             const TemplateText& text) const {
  const std::set<std::size_t> expected = base_->texts_.at(name).gaps();
  const std::set<std::size_t> found = text.gaps();
  if (found == expected || (found.empty() && mayBeLeftOut(name))) return;
  fail(value.Mark(), "a text with " + gapsAsWritten(expected), inQuotes(value.Scalar()));
}

}  // namespace goal_alignment::phrasing
