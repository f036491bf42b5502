// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <sstream>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::phrasing {

namespace {

/// Far more than a person wants to hear. Aliases repeat a text for two bytes each, so that without
/// a bound the phrases could be as long as the square of the file.
constexpr std::size_t kLongestText = 1000;

/// yaml-cpp's own messages may hold half a character of the text.
constexpr std::size_t kLongestMessage = 200;

std::string describe(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Map:
      return "a map";
    case YAML::NodeType::Sequence:
      return "a list";
    case YAML::NodeType::Scalar:
      return inQuotes(node.Scalar());
    case YAML::NodeType::Null:
    case YAML::NodeType::Undefined:
      break;
  }
  return "nothing";
}

/// Hears of a document nothing but where it begins.
class DocumentStart : public YAML::EventHandler {
 public:
  YAML::Mark mark;

  void OnDocumentStart(const YAML::Mark& at) override { mark = at; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

}  // namespace

/// Fills a Phrases from a YAML document and knows, for its errors, where everything stands.
class PhraseReader {
 public:
  explicit PhraseReader(std::string source_name) : source_name_(std::move(source_name)) {}

  Phrases read(const std::string& text) {
    try {
      refuseSecondDocument(text);
      const YAML::Node document = YAML::Load(text);
      if (!document.IsNull()) readSections(document);
    } catch (const YAML::Exception& exception) {
      const std::size_t readable = utf8Length(exception.msg, kLongestMessage);
      fail(exception.mark, "YAML", exception.msg.substr(0, readable));
    }
    return std::move(phrases_);
  }

 private:
  /// Not YAML::LoadAll(): what a document can't begin with, such as `,`, it reads for ever as one
  /// empty document after the other.
  void refuseSecondDocument(const std::string& text) const {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentStart start;
    if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return;
    fail(start.mark, "one document", "a second one");
  }

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
    const std::string& scalar = node.Scalar();
    if (scalar.size() > kLongestText) {
      fail(node.Mark(), "at most " + std::to_string(kLongestText) + " bytes", describe(node));
    }
    // Messages carry nothing else, and YAML's own encodings were converted before.
    if (utf8Length(scalar, kLongestText) < scalar.size()) {
      fail(node.Mark(), "UTF-8", "other bytes in " + describe(node));
    }
    return scalar;
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

  std::string source_name_;
  Phrases phrases_;
};

Phrases Phrases::fromYaml(const std::string& text, const std::string& source_name) {
  return PhraseReader(source_name).read(text);
}

}  // namespace goal_alignment::phrasing
