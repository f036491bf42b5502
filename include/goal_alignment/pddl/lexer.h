// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::pddl {

/// `(`, `)`, a word (whatever stands between blanks and parentheses), or the end of the text.
struct Token {
  enum class Kind { Open, Close, Word, End };
  Kind kind = Kind::End;
  std::string_view text;  ///< into the source
  SourcePosition position;
};

/// Cuts PDDL text into tokens; comments and blanks separate them. LF, CRLF and CR end a line, a
/// column is a byte, and a byte order mark at the start is skipped. O(text) over all calls.
///
/// What a word may be is the parser's business: a lexer that knew names from numbers could only
/// give worse messages. Beyond ASCII it takes letters and whatever else does not look like a part
/// of PDDL's own signs. It refuses what no PDDL holds outside of comments: control characters,
/// bytes that are no UTF-8, blanks, dashes and the like from word processors; and NUL anywhere.
class Lexer {
 public:
  /// The source must outlive the lexer and its tokens.
  explicit Lexer(const Source& source);

  /// The next token; after the last one, End for ever. Throws SyntaxError that names the byte or
  /// character.
  Token next();

 private:
  SourcePosition position() const;
  void skipBlanksAndComments();
  void skipComment();
  void endLine();
  [[noreturn]] void refuse() const;

  const Source& source_;
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t line_begin_ = 0;
  int line_ = 1;
};

}  // namespace goal_alignment::pddl
