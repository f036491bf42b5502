// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <utility>

#include "frames_reader.h"
#include "goal_alignment/common/listed.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/phrasing/phrases.h"
#include "template_reader.h"

namespace goal_alignment::phrasing {

/// Fills a Phrases from a YAML document.
class PhraseReader : private TemplateReader {
 public:
  explicit PhraseReader(const std::string& source_name)
      : TemplateReader(source_name), source_name_(source_name) {}

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
    expectMap(root, "a map of 'predicates', 'objects', 'actions', 'language' and 'frames'");
    // What stands below `frames` replaces texts of the language, wherever that stands.
    if (root["language"]) readLanguage(root["language"]);
    for (const auto& section : root)
      readSection(text(section.first, "the name of a section"), section.first, section.second);
  }

  void readSection(const std::string& name, const YAML::Node& key, const YAML::Node& value) {
    const bool frames = name == "frames";
    if (name == "language") return;
    if (name != "predicates" && name != "objects" && name != "actions" && !frames) {
      fail(key.Mark(), "'predicates', 'objects', 'actions', 'language' or 'frames'",
           inQuotes(name));
    }
    if (value.IsNull()) return;  // `objects:` with nothing below it
    expectMap(value, "a map from names to texts");
    if (frames) return readFrames(value);
    for (const auto& entry : value)
      readEntry(name, entry.first, entry.second);
  }

  void readLanguage(const YAML::Node& node) {
    const std::string language = text(node, "a language");
    const bool is_file = language.find('.') != std::string::npos;
    phrases_.frames_ = is_file ? framesOf(node, language) : Frames::shipped(language);
    if (!phrases_.frames_) fail(node.Mark(), languages(), inQuotes(language));
    warnOf(is_file ? language : "the language " + language);
  }

  /// A file beside this one.
  Frames::Shared framesOf(const YAML::Node& node, const std::string& file) const {
    const auto path = std::filesystem::path(source_name_).parent_path() / file;
    try {
      return Frames::fromYaml(pddl::readFile(path.string()).text, path.string());
    } catch (const pddl::InputError& error) {
      failAt(node.Mark(), error.what());
    }
  }

  static std::string languages() {
    std::string text;
    for (const std::string& language : Frames::shippedLanguages())
      text += inQuotes(language) + ", ";
    return text + "or a file beside this one, FILE.yaml";
  }

  void warnOf(const std::string& language) {
    const std::string names =
        listed(phrases_.frames_->missing(), [](const std::string& name) { return name; });
    if (!names.empty())
      phrases_.warning_ = language + " lacks, and English stands in for: " + names;
  }

  void readFrames(const YAML::Node& texts) {
    phrases_.frames_ = std::make_shared<const Frames>(
        FramesReader(source_name_, phrases_.frames_.get()).over(texts));
  }

  void readEntry(const std::string& section, const YAML::Node& key, const YAML::Node& value) {
    if (section == "objects") {
      insert(phrases_.objects_, key, objectOf(value));
    } else if (section == "actions") {
      insert(phrases_.actions_, key, sentence(value, "a text such as \"go to {0}\""));
    } else if (value.IsMap()) {
      insert(phrases_.predicates_, key, formsOf(value));
    } else {
      Phrases::Forms forms;
      forms.affirmative = sentence(
          value, "a text such as \"{0} is clean\", or a map of 'affirmative' and 'negated'");
      insert(phrases_.predicates_, key, std::move(forms));
    }
  }

  Filling objectOf(const YAML::Node& value) const {
    Filling object;
    if (!value.IsMap()) {
      object.text = text(value, "what to call the object");
      return object;
    }
    for (const auto& form : value)
      insert(object.forms, form.first, text(form.second, "what to call the object"));
    const auto name = object.forms.find("name");
    if (name == object.forms.end()) fail(value.Mark(), "'name', what to call the object", "none");
    object.text = name->second;
    return object;
  }

  Phrases::Forms formsOf(const YAML::Node& node) const {
    static const std::map<std::string, Phrases::Form> kForms = {
        {"affirmative", &Phrases::Forms::affirmative},
        {"negated", &Phrases::Forms::negated},
        {"that", &Phrases::Forms::that},
        {"that_not", &Phrases::Forms::that_not}};
    Phrases::Forms forms;
    for (const auto& entry : node) {
      const std::string name = text(entry.first, "'affirmative', 'negated', 'that' or 'that_not'");
      const auto form = kForms.find(name);
      if (form == kForms.end()) {
        fail(entry.first.Mark(), "'affirmative', 'negated', 'that' or 'that_not'", inQuotes(name));
      }
      auto& into = forms.*form->second;
      if (into) fail(entry.first.Mark(), "each name once", inQuotes(name) + " again");
      into = sentence(entry.second, "a text");
    }
    return forms;
  }

  const std::string source_name_;
  Phrases phrases_;
};

Phrases Phrases::fromYaml(const std::string& text, const std::string& source_name) {
  return PhraseReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
