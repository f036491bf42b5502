// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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
                                                             {"none", Meaning::None},
                                                             {"agreed", Meaning::Agreed}};
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
    } else if (std::set<Words>* phrases = phrasesCalled(name)) {
      for (const YAML::Node& entry : expectedPhrases(value))
        addPhrase(wordsIn(entry), *phrases);
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
           "one of yes, no, dont_know, decline, repeat, why, all, none, any, agreed, "
           "beside, leaving_out, choosing, and, but, stand_in, ignored, numbers, say",
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

  std::set<Words>* phrasesCalled(const std::string& section) {
    if (section == "any") return &vocabulary_.any_;
    if (section == "beside") return &vocabulary_.beside_;
    if (section == "leaving_out") return &vocabulary_.leaving_out_;
    if (section == "choosing") return &vocabulary_.choosing_;
    return nullptr;
  }

  void addPhrase(const Words& words, std::set<Words>& phrases) {
    vocabulary_.longest_ = std::max(vocabulary_.longest_, words.size());
    for (const Words& form : formsOf(words))
      phrases.insert(form);
  }

  const YAML::Node& expectedPhrases(const YAML::Node& list) const {
    expectList(list, "a list of what may be heard");
    if (list.size() == 0) fail(list.Mark(), "what may be heard", "an empty list");
    return list;
  }

  void readPhrases(const YAML::Node& list, Meaning meaning) {
    for (const YAML::Node& entry : expectedPhrases(list)) {
      const Words words = wordsIn(entry);
      for (const Words& form : formsOf(words))
        addMeaning(entry, form, meaning);
      for (const Words& form : formsOf(vocabulary_.withoutIgnored(words)))
        if (!form.empty()) addMeaning(entry, form, meaning);
    }
  }

  // Recognisers, and people at keyboards, leave apostrophes out.
  static std::set<Words> formsOf(const Words& words) {
    Words plain = words;
    for (std::string& word : plain)
      word.erase(std::remove(word.begin(), word.end(), '\''), word.end());
    return {words, plain};
  }

  void addMeaning(const YAML::Node& entry, const Words& words, Meaning meaning) {
    vocabulary_.longest_ = std::max(vocabulary_.longest_, words.size());
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

  // What is said: as it stands, or with so many gaps.
  struct Saying {
    std::string* text = nullptr;
    TemplateText* filled = nullptr;
    std::size_t gaps = 0;
  };
  using Sayings = std::map<std::string, Saying>;

  void readSayings(const YAML::Node& sayings) {
    expectMap(sayings, "a map of what is said");
    EndSayings end;
    Sayings needed = {{"which", {&vocabulary_.which_}},
                      {"sorry", {&vocabulary_.sorry_}},
                      {"answers", {&vocabulary_.answers_}},
                      {"group_answers", {&vocabulary_.group_answers_}},
                      {"no_reason", {&vocabulary_.no_reason_}},
                      {"numbered", {nullptr, &vocabulary_.numbered_, 2}}};
    Sayings of_end = {{"offer", {&end.offer}},
                      {"offer_one", {nullptr, &end.offer_one, 1}},
                      {"choose", {&end.choose}},
                      {"choose_one", {&end.choose_one}},
                      {"choose_answers", {&end.choose_answers}},
                      {"chosen", {&end.chosen}},
                      {"left", {&end.left}},
                      {"plan", {nullptr, &end.plan, 3}},
                      {"plan_of_one", {nullptr, &end.plan_of_one, 1}}};
    const std::size_t all_of_end = of_end.size();
    for (const auto& entry : sayings) {
      const std::string name = text(entry.first, "the name of a saying");
      Sayings& wanted = of_end.count(name) > 0 ? of_end : needed;
      const auto saying = wanted.find(name);
      if (saying == wanted.end())
        fail(entry.first.Mark(), "each of " + listed(needed) + " once", inQuotes(name));
      readSaying(entry.second, saying->second);
      wanted.erase(saying);
    }
    if (!needed.empty()) fail(sayings.Mark(), listed(needed), "none");
    if (of_end.empty()) {
      vocabulary_.end_ = std::move(end);
    } else if (of_end.size() < all_of_end) {
      fail(sayings.Mark(), "all that is said at the end, also " + listed(of_end), "none");
    }
  }

  void readSaying(const YAML::Node& node, const Saying& saying) {
    if (saying.text != nullptr) {
      *saying.text = text(node, "what is said");
    } else {
      *saying.filled = withGaps(node, saying.gaps);
    }
  }

  TemplateText withGaps(const YAML::Node& node, std::size_t number) const {
    std::string gaps;
    std::vector<std::string> marks;
    for (std::size_t i = 0; i < number; ++i) {
      gaps += (i == 0 ? "{" : " and {") + std::to_string(i) + "}";
      marks.push_back("<" + std::to_string(i) + ">");
    }
    TemplateText saying = sentence(node, "a text with " + gaps);
    const auto filled = saying.fill(marks);
    const bool all = filled && std::all_of(marks.begin(), marks.end(), [&](const auto& mark) {
                       return filled->find(mark) != std::string::npos;
                     });
    if (!all)
      fail(node.Mark(), "a text with " + gaps + " and no other gap", inQuotes(node.Scalar()));
    return saying;
  }

  static std::string listed(const Sayings& sayings) {
    std::string text;
    for (const auto& [name, ignored] : sayings)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
  }

  Vocabulary vocabulary_;
};

Vocabulary Vocabulary::fromYaml(const std::string& text, const std::string& source_name) {
  return VocabularyReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
