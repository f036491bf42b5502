// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/ast.h"
#include "goal_alignment/pddl/lexer.h"

namespace goal_alignment::pddl {

/// Walks over the tokens of one text with one token of look-ahead, and words the errors of whoever
/// reads it. Its bound on nesting bounds the recursion of every reader built on it.
class TokenReader {
 public:
  static constexpr std::size_t kDeepestNesting = 1000;
  /// What holds a name holds it many times: every ground action holds those of its arguments.
  static constexpr std::size_t kLongestWord = 1000;

  /// Polls the limits at every token and throws LimitReached.
  explicit TokenReader(const Source& source, const Limits& limits = {});

  const Token& current() const { return current_; }
  bool atOpen() const { return current_.kind == Token::Kind::Open; }
  bool atClose() const { return current_.kind == Token::Kind::Close; }
  bool atEnd() const { return current_.kind == Token::Kind::End; }
  bool atWord() const { return current_.kind == Token::Kind::Word; }
  /// At this word, in any case.
  bool atWord(std::string_view lower_case) const;
  /// At a word that can be the name of something: no `?x`, no `:keyword`, no `-` or `=`.
  bool atName() const;
  bool atVariable() const;
  /// At a `-`, or a word that begins with one, as no name does: `-room`.
  bool atDash() const;

  /// Each takes the current token, or throws SyntaxError: expected `what`, found the token.
  SourcePosition open(const std::string& what = "'('");
  SourcePosition close(const std::string& what = "')'");
  Token word(const std::string& what);
  Token word(std::string_view lower_case, const std::string& what);
  ast::Name name(const std::string& what);
  ast::Name variable(const std::string& what);
  void dash();
  /// The current word's first characters; the rest, if there is any, is a word of its own.
  Token prefix(std::size_t length);
  void finish();

  /// What is being read, for UnsupportedError: `the precondition of action 'climb'`.
  void setPlace(std::string place) { place_ = std::move(place); }

  /// Which bracket is to blame where the text goes on as if it stood elsewhere, to end a message
  /// with; else empty.
  std::string bracketHint() const;

  [[noreturn]] void failExpecting(const std::string& what, const std::string& hint = {}) const;
  [[noreturn]] void fail(SourcePosition position, const std::string& message) const;
  [[noreturn]] void failUnsupported(SourcePosition position, const std::string& construct) const;

 private:
  /// A parenthesis with what it opens: `(:action go`, of which `head` is the first word.
  struct Bracket {
    SourcePosition position;
    std::string_view head;
    std::string_view name;  ///< of an action
  };

  Token take();
  void takeBracket();
  void noteHead();
  std::string found() const;
  std::string sectionHint() const;
  bool atKeyword() const;
  bool conjunctionEnded() const;
  std::string stillOpen(const Bracket& bracket) const;
  std::string closedEarly() const;

  const Source& source_;
  Lexer lexer_;
  LimitMonitor monitor_;
  Token current_;
  std::vector<Bracket> open_;  ///< the parentheses that stand open, outermost first
  Bracket closed_;             ///< the one that was closed last
  SourcePosition closed_at_;   ///< and where; line 0: none was yet
  std::string place_;
};

/// `3:14`, for a message that points at a second place.
std::string toString(SourcePosition position);

}  // namespace goal_alignment::pddl
