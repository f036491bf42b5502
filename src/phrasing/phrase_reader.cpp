// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <utility>

#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::phrasing {

namespace {

/// Longer texts are cut in messages.
constexpr std::size_t kMaxQuoted = 40;

std::string describe(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Map:
      return "a map";
    case YAML::NodeType::Sequence:
      return "a list";
    case YAML::NodeType::Scalar:
      return "'" + node.Scalar().substr(0, kMaxQuoted) + "'";
    case YAML::NodeType::Null:
    case YAML::NodeType::Undefined:
      break;
  }
  return "nothing";
}

}  // namespace

/// Fills a Phrases from a YAML document and knows, for its errors, where everything stands.
class PhraseReader {
 public:
  explicit PhraseReader(std::string source_name) : source_name_(std::move(source_name)) {}

  Phrases read(const std::string& text) {
    try {
      const std::vector<YAML::Node> documents = YAML::LoadAll(text);
      if (documents.size() > 1) fail(documents[1].Mark(), "one document", "a second one");
      if (!documents.empty() && !documents.front().IsNull()) readSections(documents.front());
    } catch (const YAML::Exception& exception) {
      fail(exception.mark, "YAML", exception.msg);
    }
    return std::move(phrases_);
  }

 private:
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& expected,
                         const std::string& found) const {
    failAt(mark, "expected " + expected + ", found " + found);
  }

  [[noreturn]] void failAt(const YAML::Mark& mark, const std::string& message) const {
    // yaml-cpp counts from 0 and has -1 for "nowhere".
    throw PhraseError(source_name_ + ":" + std::to_string(mark.line + 1) + ":" +
                      std::to_string(mark.column + 1) + ": " + message);
  }

  void expectMap(const YAML::Node& node, const std::string& what) const {
    if (!node.IsMap()) fail(node.Mark(), what, describe(node));
  }

  std::string text(const YAML::Node& node, const std::string& what) const {
    if (!node.IsScalar() || node.Scalar().empty()) fail(node.Mark(), what, describe(node));
    return node.Scalar();
  }

  TemplateText sentence(const YAML::Node& node, const std::string& what) const {
    try {
      return TemplateText::parse(text(node, what));
    } catch (const std::invalid_argument& exception) {
      failAt(node.Mark(), exception.what());
    }
  }

  /// Names match without case, so the same name twice is a fault even in two spellings, which YAML
  /// itself would let pass.
  template <typename Value>
  void insert(std::map<std::string, Value>& into, const YAML::Node& key, Value value) const {
    const std::string name = toLower(text(key, "a name"));
    if (!into.emplace(name, std::move(value)).second) {
      fail(key.Mark(), "each name once", "'" + name + "' again");
    }
  }

  void readSections(const YAML::Node& root) {
    expectMap(root, "a map of 'predicates', 'objects' and 'actions'");
    for (const auto& section : root) {
      const std::string name = text(section.first, "the name of a section");
      if (name != "predicates" && name != "objects" && name != "actions") {
        fail(section.first.Mark(), "'predicates', 'objects' or 'actions'", "'" + name + "'");
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
        fail(form.first.Mark(), "'affirmative' or 'negated'", "'" + name + "'");
      }
    }
  }

  std::string source_name_;
  Phrases phrases_;
};

Phrases Phrases::fromYaml(const std::string& text, const std::string& source_name) {
  return PhraseReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
