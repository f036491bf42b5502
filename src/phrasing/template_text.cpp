// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/template_text.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::phrasing {

namespace {

/// More digits than any predicate has arguments, and far from overflow.
constexpr std::size_t kMaxDigits = 3;

/// The number between the brace at `open` and the next one; `open` then is the closing brace.
std::size_t readGap(const std::string& text, std::size_t& open) {
  const std::size_t close = text.find('}', open);
  const std::string inside =
      close == std::string::npos ? text.substr(open) : text.substr(open + 1, close - open - 1);
  const bool number =
      close != std::string::npos && !inside.empty() && inside.size() <= kMaxDigits &&
      std::all_of(inside.begin(), inside.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!number) {
    const std::string found = close == std::string::npos ? inside : "{" + inside + "}";
    throw std::invalid_argument("expected a gap such as {0} (or {{ for a brace), found " +
                                inQuotes(found));
  }
  open = close;
  return static_cast<std::size_t>(std::stoul(inside));
}

}  // namespace

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
      piece.index = readGap(text, i);
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

std::optional<std::string> TemplateText::fill(const std::vector<std::string>& arguments) const {
  std::string result;
  for (const Piece& piece : pieces_) {
    result += piece.text;
    if (!piece.index) continue;
    if (*piece.index >= arguments.size()) return std::nullopt;
    result += arguments[*piece.index];
  }
  return result;
}

}  // namespace goal_alignment::phrasing
