// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/vocabulary.h"
#include "template_reader.h"

namespace goal_alignment::phrasing {

/// Fills a Vocabulary from a YAML document.
class VocabularyReader : private TemplateReader {
 public:
  using TemplateReader::TemplateReader;

  Vocabulary read(const std::string& text) {
    bool anything = false;
    load(text, [&](const YAML::Node& root) {
      anything = true;
      readSections(root);
    });
    if (!anything) fail(YAML::Mark(), "words for yes and no", "nothing");
    return std::move(vocabulary_);
  }

 private:
  using Meaning = Vocabulary::Meaning;
  using Words = Vocabulary::Words;

  static std::optional<Meaning> meaningCalled(const std::string& section) {
    static const std::map<std::string, Meaning> kMeanings = {{"yes", Meaning::Yes},
                                                             {"no", Meaning::No},
                                                             {"dont_know", Meaning::DontKnow},
                                                             {"decline", Meaning::Decline},
                                                             {"repeat", Meaning::Repeat},
                                                             {"why", Meaning::Why},
                                                             {"all", Meaning::All},
                                                             {"none", Meaning::None}};
    const auto found = kMeanings.find(section);
    return found == kMeanings.end() ? std::nullopt : std::optional(found->second);
  }

  void readSections(const YAML::Node& root) {
    expectMap(root, "a map with 'yes', 'no' and 'say'");
    // Before all that it is ignored in.
    if (root["ignored"]) readSingles(root["ignored"], vocabulary_.ignored_);
    std::set<std::string> seen;
    for (const auto& section : root) {
      const std::string name = text(section.first, "the name of a section");
      if (!seen.insert(name).second)
        fail(section.first.Mark(), "each section once", inQuotes(name) + " again");
      readSection(name, section.first, section.second);
    }
    for (const char* needed : {"yes", "no", "say"})
      if (seen.count(needed) == 0) fail(root.Mark(), std::string("'") + needed + "'", "none");
  }

  void readSection(const std::string& name, const YAML::Node& key, const YAML::Node& value) {
    if (const auto meaning = meaningCalled(name)) {
      readPhrases(value, *meaning);
    } else if (name == "and") {
      readSingles(value, vocabulary_.and_);
    } else if (name == "stand_in") {
      readSingles(value, vocabulary_.stand_in_);
    } else if (name == "but") {
      readSingles(value, vocabulary_.but_);
    } else if (name == "numbers") {
      readNumbers(value);
    } else if (name == "say") {
      readSayings(value);
    } else if (name != "ignored") {
      fail(key.Mark(),
           "one of yes, no, dont_know, decline, repeat, why, all, none, and, but, "
           "stand_in, ignored, "
           "numbers, say",
           inQuotes(name));
    }
  }

  Words wordsIn(const YAML::Node& node) const {
    const std::string heard = text(node, "what may be heard");
    Words words = wordsOf(heard);
    if (words.empty()) fail(node.Mark(), "at least one word", inQuotes(heard));
    return words;
  }

  std::string singleWord(const YAML::Node& node) const {
    const Words words = wordsIn(node);
    if (words.size() != 1) fail(node.Mark(), "one word", inQuotes(node.Scalar()));
    return words.front();
  }

  void readPhrases(const YAML::Node& list, Meaning meaning) {
    expectList(list, "a list of what may be heard");
    if (list.size() == 0) fail(list.Mark(), "what may be heard", "an empty list");
    for (const YAML::Node& entry : list) {
      const Words words = wordsIn(entry);
      addMeaning(entry, words, meaning);
      const Words rest = vocabulary_.withoutIgnored(words);
      if (!rest.empty()) addMeaning(entry, rest, meaning);
    }
  }

  void addMeaning(const YAML::Node& entry, const Words& words, Meaning meaning) {
    const auto added = vocabulary_.meanings_.emplace(words, meaning).first;
    if (added->second != meaning)
      fail(entry.Mark(), "a text of one meaning",
           inQuotes(entry.Scalar()) + ", which has another above");
  }

  void readSingles(const YAML::Node& list, std::set<std::string>& into) {
    expectList(list, "a list of words");
    for (const YAML::Node& entry : list)
      into.insert(singleWord(entry));
  }

  void readNumbers(const YAML::Node& numbers) {
    expectMap(numbers, "a map from numbers to lists of words");
    for (const auto& entry : numbers) {
      std::size_t number = 0;
      if (!YAML::convert<std::size_t>::decode(entry.first, number) || number < 1 || number > 255)
        fail(entry.first.Mark(), "a number from 1 to 255", describe(entry.first));
      expectList(entry.second, "a list of words");
      for (const YAML::Node& node : entry.second) {
        const std::string word = singleWord(node);
        if (!vocabulary_.numbers_.emplace(word, number).second)
          fail(node.Mark(), "each word once", inQuotes(word) + " again");
        vocabulary_.number_words_.emplace(number, node.Scalar());
      }
    }
  }

  void readSayings(const YAML::Node& sayings) {
    expectMap(sayings, "a map of what is said");
    std::map<std::string, std::string*> wanted = {
        {"which", &vocabulary_.which_},         {"sorry", &vocabulary_.sorry_},
        {"answers", &vocabulary_.answers_},     {"group_answers", &vocabulary_.group_answers_},
        {"no_reason", &vocabulary_.no_reason_}, {"numbered", nullptr}};
    for (const auto& entry : sayings) {
      const std::string name = text(entry.first, "the name of a saying");
      const auto saying = wanted.find(name);
      if (saying == wanted.end())
        fail(entry.first.Mark(), "each of " + listed(wanted) + " once", inQuotes(name));
      if (saying->second != nullptr) {
        *saying->second = text(entry.second, "what is said");
      } else {
        readNumbered(entry.second);
      }
      wanted.erase(saying);
    }
    if (!wanted.empty()) fail(sayings.Mark(), listed(wanted), "none");
  }

  void readNumbered(const YAML::Node& node) {
    vocabulary_.numbered_ = sentence(node, "a text such as \"{0}: {1}.\"");
    const auto filled = vocabulary_.numbered_.fill({"<1>", "<2>"});
    if (!filled || filled->find("<1>") == std::string::npos ||
        filled->find("<2>") == std::string::npos)
      fail(node.Mark(), "a text with {0} and {1} and no other gap", inQuotes(node.Scalar()));
  }

  static std::string listed(const std::map<std::string, std::string*>& names) {
    std::string text;
    for (const auto& [name, ignored] : names)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
  }

  Vocabulary vocabulary_;
};

Vocabulary Vocabulary::fromYaml(const std::string& text, const std::string& source_name) {
  return VocabularyReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
