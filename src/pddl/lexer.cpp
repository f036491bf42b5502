// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/lexer.h"

#include "foreign_character.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::pddl {

namespace {

// Not <cctype>: a locale must not change what a blank is.
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}

/// Any printable ASCII: IPC files name objects `1`, `x+y` or `a.b`.
bool isWordCharacter(char c) {
  return c > ' ' && c < '\x7f' && c != '(' && c != ')' && c != ';';
}

/// Bytes of the character at the front that may stand in a word; 0 where it may not.
std::size_t wordCharacterLength(std::string_view text) {
  if (static_cast<unsigned char>(text.front()) < 0x80U)
    return isWordCharacter(text.front()) ? 1 : 0;
  const std::size_t length = utf8CharacterLength(text);
  return length > 0 && passesForLetter(text.substr(0, length)) ? length : 0;
}

}  // namespace

Lexer::Lexer(const Source& source) : source_(source), text_(source.text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    offset_ = line_begin_ = kByteOrderMark.size();
  }
}

Token Lexer::next() {
  skipBlanksAndComments();
  const SourcePosition begin = position();
  if (offset_ == text_.size()) return {Token::Kind::End, {}, begin};
  // Parentheses need no blanks around them.
  const std::size_t first = offset_;
  const char c = text_[first];
  if (c == '(' || c == ')') {
    ++offset_;
    return {c == '(' ? Token::Kind::Open : Token::Kind::Close, text_.substr(first, 1), begin};
  }
  // Nor has a variable: `(aircraft?a)` stands in an IPC domain.
  while (offset_ < text_.size() && (text_[offset_] != '?' || offset_ == first)) {
    const std::size_t length = wordCharacterLength(text_.substr(offset_));
    if (length == 0) break;
    offset_ += length;
  }
  if (offset_ == first) refuse();
  return {Token::Kind::Word, text_.substr(first, offset_ - first), begin};
}

SourcePosition Lexer::position() const {
  return {line_, static_cast<int>(offset_ - line_begin_) + 1};
}

void Lexer::skipBlanksAndComments() {
  while (offset_ < text_.size()) {
    const char c = text_[offset_];
    if (isLineEnd(c)) {
      endLine();
    } else if (isBlank(c)) {
      ++offset_;
    } else if (c == ';') {
      skipComment();
    } else {
      return;
    }
  }
}

void Lexer::skipComment() {
  while (offset_ < text_.size() && !isLineEnd(text_[offset_])) {
    if (text_[offset_] == '\0') refuse();
    ++offset_;
  }
}

void Lexer::endLine() {
  const bool two_bytes =
      text_[offset_] == '\r' && offset_ + 1 < text_.size() && text_[offset_ + 1] == '\n';
  offset_ += two_bytes ? 2 : 1;
  line_begin_ = offset_;
  ++line_;
}

void Lexer::refuse() const {
  throw SyntaxError(source_.name, position(),
                    "expected PDDL text, found " + foreignCharacter(text_, offset_));
}

}  // namespace goal_alignment::pddl
