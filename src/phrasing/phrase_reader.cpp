// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/phrases.h"
#include "template_reader.h"

namespace goal_alignment::phrasing {

/// Fills a Phrases from a YAML document.
class PhraseReader : private TemplateReader {
 public:
  using TemplateReader::TemplateReader;

  Phrases read(const std::string& text) {
    load(text, [this](const YAML::Node& document) { readSections(document); });
    return std::move(phrases_);
  }

 private:
  /// Names match without case, so the same name twice is a fault even in two spellings, which YAML
  /// itself would let pass.
  template <typename Value>
  void insert(std::map<std::string, Value>& into, const YAML::Node& key, Value value) const {
    const std::string name = toLower(text(key, "a name"));
    if (!into.emplace(name, std::move(value)).second) {
      fail(key.Mark(), "each name once", inQuotes(name) + " again");
    }
  }

  void readSections(const YAML::Node& root) {
    expectMap(root, "a map of 'predicates', 'objects' and 'actions'");
    for (const auto& section : root) {
      const std::string name = text(section.first, "the name of a section");
      if (name != "predicates" && name != "objects" && name != "actions") {
        fail(section.first.Mark(), "'predicates', 'objects' or 'actions'", inQuotes(name));
      }
      if (section.second.IsNull()) continue;  // `objects:` with nothing below it
      expectMap(section.second, "a map from names to texts");
      for (const auto& entry : section.second)
        readEntry(name, entry.first, entry.second);
    }
  }

  void readEntry(const std::string& section, const YAML::Node& key, const YAML::Node& value) {
    if (section == "objects") {
      insert(phrases_.objects_, key, text(value, "what to call the object"));
    } else if (section == "actions") {
      insert(phrases_.actions_, key, sentence(value, "a text such as \"go to {0}\""));
    } else if (value.IsMap()) {
      readForms(key, value);
    } else {
      insert(phrases_.affirmative_, key,
             sentence(value,
                      "a text such as \"{0} is clean\", or a map of 'affirmative' and "
                      "'negated'"));
    }
  }

  void readForms(const YAML::Node& key, const YAML::Node& forms) {
    for (const auto& form : forms) {
      const std::string name = text(form.first, "'affirmative' or 'negated'");
      if (name == "affirmative") {
        insert(phrases_.affirmative_, key, sentence(form.second, "a text"));
      } else if (name == "negated") {
        insert(phrases_.negated_, key, sentence(form.second, "a text"));
      } else {
        fail(form.first.Mark(), "'affirmative' or 'negated'", inQuotes(name));
      }
    }
  }

  Phrases phrases_;
};

Phrases Phrases::fromYaml(const std::string& text, const std::string& source_name) {
  return PhraseReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
