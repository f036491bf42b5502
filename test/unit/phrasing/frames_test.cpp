// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/frames.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/phrasing/phrases.h"
#include "unit/source_root.h"

namespace goal_alignment::phrasing {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::set<std::string> namesIn(const std::string& text, const std::regex& pattern) {
  std::set<std::string> names;
  for (std::sregex_iterator name(text.begin(), text.end(), pattern), end; name != end; ++name)
    names.insert((*name)[1]);
  return names;
}

std::set<std::string> englishNames() {
  return namesIn("\n" + textOf(sourceRoot() / "config/phrases/en.yaml"),
                 std::regex("\n([a-z_]+): \""));
}

TEST(Frames, EveryLanguageThatIsShippedIsWhole) {
  const auto languages = Frames::shippedLanguages();
  EXPECT_EQ(languages, (std::vector<std::string>{"de", "en"}));
  for (const std::string& language : languages) {
    const Frames::Shared frames = Frames::shipped(language);  // wrong gaps would throw
    ASSERT_NE(frames, nullptr) << language;
    EXPECT_EQ(frames->missing(), std::set<std::string>{}) << language;
    const std::string file = textOf(sourceRoot() / "config/phrases" / (language + ".yaml"));
    EXPECT_FALSE(file.empty());
    EXPECT_NE(file.find("\"" + frames->fill("certain") + "\""), std::string::npos)
        << "the library has another " << language;
  }
  EXPECT_EQ(Frames::shipped("xx"), nullptr);
}

// A name that stands in quotes somewhere, or is put together of what does.
TEST(Frames, EveryTextIsSaidSomewhere) {
  std::string sources;
  for (const char* folder : {"src", "include"}) {
    for (const auto& entry : fs::recursive_directory_iterator(sourceRoot() / folder))
      if (entry.is_regular_file()) sources += textOf(entry.path());
  }
  const std::set<std::string> in_quotes = namesIn(sources, std::regex("\"([a-z_]+)\""));
  const std::set<std::string> names = englishNames();
  EXPECT_GT(names.size(), 150U);
  for (const std::string& name : names) {
    bool said = in_quotes.count(name) > 0;
    for (std::size_t cut = 1; !said && cut < name.size(); ++cut) {
      const std::string rest = name.substr(cut);
      const bool begins = in_quotes.count(name.substr(0, cut)) > 0;
      said = begins && (in_quotes.count(rest) > 0 || rest == "_one" || rest == "_saves_one" ||
                        rest == "_named_from");
    }
    EXPECT_TRUE(said) << name << " is said nowhere";
  }
}

TEST(Frames, TextsThatAreSaidExist) {
  std::string sources;
  for (const auto& entry : fs::recursive_directory_iterator(sourceRoot() / "src"))
    if (entry.path().extension() != ".yaml" && entry.is_regular_file())
      sources += textOf(entry.path());
  const auto said = namesIn(sources, std::regex("(?:say|tell|tellBelow)\\(\"([a-z_]+)\""));
  const auto counted = namesIn(sources, std::regex("counted\\(\"([a-z_]+)\""));
  const std::set<std::string> names = englishNames();
  EXPECT_GT(said.size(), 60U);
  for (const std::string& name : said)
    EXPECT_EQ(names.count(name), 1U) << name;
  for (const std::string& name : counted) {
    EXPECT_EQ(names.count(name), 1U) << name;
    EXPECT_EQ(names.count(name + "_one"), 1U) << name;
  }
}

TEST(Frames, NumbersHaveASingular) {
  const Frames& english = *Frames::english();
  EXPECT_EQ(english.counted("more_ways", 1), "There is one more way.");
  EXPECT_EQ(english.counted("more_ways", 4), "There are 4 more ways.");
  EXPECT_EQ(english.counted("event_with_plan", 2, {"tea"}), "tea; with a plan of 2 steps");
  EXPECT_THROW(english.fill("no_such_text"), std::out_of_range);
}

TEST(Frames, WhatAFileLacksIsSaidInEnglish) {
  const auto few = Frames::fromYaml("certain: \"C'est sûr.\"\n", "fr.yaml");
  EXPECT_EQ(few->fill("certain"), "C'est sûr.");
  EXPECT_EQ(few->fill("answer_yes"), "yes");
  EXPECT_EQ(few->missing().size() + 1, englishNames().size());
  EXPECT_EQ(few->missing().count("answer_yes"), 1U);
}

TEST(Frames, ErrorsHaveAPlace) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"certian: x", "1:1: expected a name that config/phrases/en.yaml has, found 'certian'"},
      {"certain: x\nquestion: \"Wichtig?\"", "2:11: expected a text with {0}, found 'Wichtig?'"},
      {"list_last: \"{0} et\"", "1:12: expected a text with {0} and {1}, found '{0} et'"},
      {"certain: [x]", "1:10: expected a text, found a list"},
      {"certain: x\ncertain: y", "2:1: expected each name once, found 'certain' again"},
      {"- x", "1:1: expected a map from names to texts, found a list"},
  };
  for (const auto& [text, message] : table) {
    try {
      Frames::fromYaml(text, "fr.yaml");
      ADD_FAILURE() << "accepted: " << text;
    } catch (const YamlError& error) {
      EXPECT_EQ(error.what(), "fr.yaml:" + message);
    }
  }
}

TEST(Frames, AFileBesideThePhrasesIsALanguage) {
  const fs::path folder = fs::path(testing::TempDir()) / "goal_alignment_frames_test";
  fs::create_directories(folder);
  std::ofstream(folder / "fr.yaml") << "certain: \"C'est sûr.\"\n";
  const std::string name = (folder / "phrases.yaml").string();
  const Phrases phrases = Phrases::fromYaml("language: fr.yaml\n", name);
  EXPECT_EQ(phrases.say("certain"), "C'est sûr.");
  EXPECT_EQ(phrases.warning().rfind("fr.yaml lacks, and English stands in for: action_with, ", 0),
            0U)
      << phrases.warning();
  std::ofstream(folder / "fr.yaml") << "certian: x\n";
  try {
    Phrases::fromYaml("language: fr.yaml\n", name);
    ADD_FAILURE();
  } catch (const YamlError& error) {
    EXPECT_EQ(std::string(error.what()).rfind((folder / "fr.yaml").string() + ":1:1: ", 0), 0U)
        << error.what();
  }
  EXPECT_THROW(Phrases::fromYaml("language: none.yaml\n", name), YamlError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace goal_alignment::phrasing
