// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/template_text.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"

namespace goal_alignment::phrasing {

namespace {

/// More digits than any predicate has arguments, and far from overflow.
constexpr std::size_t kMaxDigits = 3;

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() <= kMaxDigits &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

const std::string& Filling::in(const std::string& form) const {
  const auto found = forms.find(form);
  return found == forms.end() ? text : found->second;
}

/// Between the brace at `open` and the next one; `open` then is the closing brace.
void TemplateText::readGap(const std::string& text, std::size_t& open, Piece& piece) {
  const std::size_t close = text.find('}', open);
  const bool closed = close != std::string::npos;
  const std::string inside = closed ? text.substr(open + 1, close - open - 1) : text.substr(open);
  const std::size_t colon = inside.find(':');
  const std::string number = inside.substr(0, colon);
  if (!closed || !isNumber(number) || colon + 1 == inside.size()) {
    throw std::invalid_argument("expected a gap such as {0} (or {{ for a brace), found " +
                                inQuotes(closed ? "{" + inside + "}" : inside));
  }
  open = close;
  piece.index = static_cast<std::size_t>(std::stoul(number));
  if (colon != std::string::npos) piece.form = toLower(inside.substr(colon + 1));
}

TemplateText TemplateText::parse(const std::string& text) {
  TemplateText result;
  Piece piece;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool doubled = i + 1 < text.size() && text[i + 1] == c;
    if ((c == '{' || c == '}') && doubled) {
      piece.text += c;
      ++i;
    } else if (c == '{') {
      readGap(text, i, piece);
      result.pieces_.push_back(std::exchange(piece, {}));
    } else if (c == '}') {
      throw std::invalid_argument("expected '{' before '}' (or }} for a brace), found " +
                                  inQuotes(text.substr(0, i + 1)));
    } else {
      piece.text += c;
    }
  }
  result.pieces_.push_back(std::move(piece));
  return result;
}

std::optional<std::string> TemplateText::fillIn(const std::vector<Filling>& arguments) const {
  std::string result;
  for (const Piece& piece : pieces_) {
    result += piece.text;
    if (!piece.index) continue;
    if (*piece.index >= arguments.size()) return std::nullopt;
    result += arguments[*piece.index].in(piece.form);
  }
  return result;
}

std::optional<std::string> TemplateText::fill(const std::vector<std::string>& arguments) const {
  std::vector<Filling> fillings;
  fillings.reserve(arguments.size());
  for (const std::string& argument : arguments)
    fillings.push_back({argument, {}});
  return fillIn(fillings);
}

std::set<std::size_t> TemplateText::gaps() const {
  std::set<std::size_t> result;
  for (const Piece& piece : pieces_)
    if (piece.index) result.insert(*piece.index);
  return result;
}

}  // namespace goal_alignment::phrasing
