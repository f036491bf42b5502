// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/frames.h"

#include "frames_reader.h"
#include "shipped_languages.h"

namespace goal_alignment::phrasing {

namespace {

std::string fileOf(const std::string& language) {
  return "config/phrases/" + language + ".yaml";
}

}  // namespace

const Frames::Shared& Frames::english() {
  static const Shared kEnglish = std::make_shared<const Frames>(
      FramesReader(fileOf("en"), nullptr).read(shippedLanguageFiles().at("en")));
  return kEnglish;
}

Frames::Shared Frames::shipped(const std::string& language) {
  if (language == "en") return english();
  const auto file = shippedLanguageFiles().find(language);
  if (file == shippedLanguageFiles().end()) return nullptr;
  return fromYaml(file->second, fileOf(language));
}

std::vector<std::string> Frames::shippedLanguages() {
  std::vector<std::string> languages;
  for (const auto& [language, text] : shippedLanguageFiles())
    languages.push_back(language);
  return languages;
}

Frames::Shared Frames::fromYaml(const std::string& text, const std::string& source_name,
                                const Frames& base) {
  return std::make_shared<const Frames>(FramesReader(source_name, &base).read(text));
}

std::string Frames::fill(const std::string& name, const std::vector<std::string>& arguments) const {
  return texts_.at(name).fill(arguments).value();
}

std::string Frames::counted(const std::string& name, std::size_t number,
                            std::vector<std::string> more) const {
  more.insert(more.begin(), std::to_string(number));
  return fill(number == 1 ? name + "_one" : name, more);
}

}  // namespace goal_alignment::phrasing
