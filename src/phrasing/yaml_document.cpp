// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/eventhandler.h>

#include <sstream>
#include <stdexcept>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/phrases.h"
#include "yaml_document.h"

namespace goal_alignment::phrasing {

namespace {

/// Far more than a person wants to hear. Aliases repeat a text for two bytes each, so that without
/// a bound the phrases could be as long as the square of the file.
constexpr std::size_t kLongestText = 1000;

/// yaml-cpp's own messages may hold half a character of the text.
constexpr std::size_t kLongestMessage = 200;

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

std::string YamlDocument::describe(const YAML::Node& node) {
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

void YamlDocument::failAsYaml(const YAML::Exception& exception) const {
  const std::size_t readable = utf8Length(exception.msg, kLongestMessage);
  fail(exception.mark, "YAML", exception.msg.substr(0, readable));
}

/// Not YAML::LoadAll(): what a document can't begin with, such as `,`, it reads for ever as one
/// empty document after the other.
void YamlDocument::refuseSecondDocument(const std::string& text) const {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStart start;
  if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return;
  fail(start.mark, "one document", "a second one");
}

void YamlDocument::fail(const YAML::Mark& mark, const std::string& expected,
                        const std::string& found) const {
  failAt(mark, "expected " + expected + ", found " + found);
}

void YamlDocument::failAt(const YAML::Mark& mark, const std::string& message) const {
  // yaml-cpp counts from 0 and has -1 for "nowhere".
  throw PhraseError(source_name_ + ":" + std::to_string(mark.line + 1) + ":" +
                    std::to_string(mark.column + 1) + ": " + message);
}

void YamlDocument::expectMap(const YAML::Node& node, const std::string& what) const {
  if (!node.IsMap()) fail(node.Mark(), what, describe(node));
}

void YamlDocument::expectList(const YAML::Node& node, const std::string& what) const {
  if (!node.IsSequence()) fail(node.Mark(), what, describe(node));
}

std::string YamlDocument::text(const YAML::Node& node, const std::string& what) const {
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

TemplateText YamlDocument::sentence(const YAML::Node& node, const std::string& what) const {
  try {
    return TemplateText::parse(text(node, what));
  } catch (const std::invalid_argument& exception) {
    failAt(node.Mark(), exception.what());
  }
}

}  // namespace goal_alignment::phrasing
