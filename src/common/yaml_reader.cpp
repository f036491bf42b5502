// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/yaml_reader.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "goal_alignment/common/quote.h"

namespace goal_alignment {

namespace {

/// Far more than a person wants to hear. Aliases repeat a text for two bytes each, so that without
/// a bound what is read could be as long as the square of the file.
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

void YamlReader::load(const std::string& text,
                      const std::function<void(const YAML::Node&)>& take) const {
  try {
    refuseSecondDocument(text);
    const YAML::Node document = YAML::Load(text);
    if (!document.IsNull()) take(document);
  } catch (const YAML::Exception& exception) {
    const std::size_t readable = utf8Length(exception.msg, kLongestMessage);
    fail(exception.mark, "YAML", exception.msg.substr(0, readable));
  }
}

/// Not YAML::LoadAll(): what a document can't begin with, such as `,`, it reads for ever as one
/// empty document after the other.
void YamlReader::refuseSecondDocument(const std::string& text) const {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStart start;
  if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return;
  fail(start.mark, "one document", "a second one");
}

void YamlReader::fail(const YAML::Mark& mark, const std::string& expected,
                      const std::string& found) const {
  failAt(mark, "expected " + expected + ", found " + found);
}

void YamlReader::failAt(const YAML::Mark& mark, const std::string& message) const {
  throw YamlError(place(mark) + ": " + message);
}

std::string YamlReader::place(const YAML::Mark& mark) const {
  // yaml-cpp counts from 0 and has -1 for "nowhere".
  return fmt::format("{}:{}:{}", source_name_, mark.line + 1, mark.column + 1);
}

void YamlReader::expectMap(const YAML::Node& node, const std::string& what) const {
  if (!node.IsMap()) fail(node.Mark(), what, describe(node));
}

void YamlReader::expectList(const YAML::Node& node, const std::string& what) const {
  if (!node.IsSequence()) fail(node.Mark(), what, describe(node));
}

YamlReader::Fields YamlReader::fields(const YAML::Node& node, const std::string& what,
                                      const std::vector<std::string>& known) const {
  expectMap(node, what);
  Fields result;
  for (const auto& entry : node) {
    const std::string name = text(entry.first, "a name");
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      fail(entry.first.Mark(), fmt::format("{}", fmt::join(known, ", ")), inQuotes(name));
    }
    if (!result.emplace(name, entry.second).second) {
      fail(entry.first.Mark(), "each name once", inQuotes(name) + " again");
    }
  }
  for (auto entry = result.begin(); entry != result.end();)
    entry = entry->second.IsNull() ? result.erase(entry) : std::next(entry);
  return result;
}

std::string YamlReader::text(const YAML::Node& node, const std::string& what) const {
  if (!node.IsScalar() || node.Scalar().empty()) fail(node.Mark(), what, describe(node));
  const std::string& scalar = node.Scalar();
  if (scalar.size() > kLongestText) {
    fail(node.Mark(), fmt::format("at most {} bytes", kLongestText), describe(node));
  }
  // Messages carry nothing else, and YAML's own encodings were converted before.
  if (utf8Length(scalar, kLongestText) < scalar.size()) {
    fail(node.Mark(), "UTF-8", "other bytes in " + describe(node));
  }
  return scalar;
}

double YamlReader::number(const YAML::Node& node, const std::string& what, double low,
                          double high) const {
  double value = 0;
  // Written so that "not a number" fits no range.
  const bool fits = node.IsScalar() && YAML::convert<double>::decode(node, value) && value >= low &&
                    value <= high;
  if (!fits) fail(node.Mark(), fmt::format("{}, {} to {}", what, low, high), describe(node));
  return value;
}

std::string YamlReader::describe(const YAML::Node& node) {
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

}  // namespace goal_alignment
