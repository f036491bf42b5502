// SPDX-License-Identifier: BSD-3-Clause
#include "token_reader.h"

#include <tuple>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

namespace {

constexpr const char* kAction = ":action";

/// `'(:action go'`
std::string opened(std::string_view head, std::string_view name) {
  const std::string text = "(" + std::string(head);
  return inQuotes(name.empty() ? text : text + " " + std::string(name));
}

}  // namespace

std::string toString(SourcePosition position) {
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

TokenReader::TokenReader(const Source& source, const Limits& limits)
    : source_(source), lexer_(source), monitor_(limits), current_(lexer_.next()) {}

bool TokenReader::atWord(std::string_view lower_case) const {
  return atWord() && current_.text.size() == lower_case.size() &&
         toLower(current_.text) == lower_case;
}

bool TokenReader::atName() const {
  return atWord() &&
         std::string_view("?:-=<>").find(current_.text.front()) == std::string_view::npos;
}

bool TokenReader::atVariable() const {
  return atWord() && current_.text.front() == '?' && current_.text.size() > 1;
}

bool TokenReader::atDash() const {
  return atWord() && current_.text.front() == '-';
}

SourcePosition TokenReader::open(const std::string& what) {
  if (!atOpen()) failExpecting(what);
  return take().position;
}

SourcePosition TokenReader::close(const std::string& what) {
  if (!atClose()) failExpecting(what);
  return take().position;
}

Token TokenReader::word(const std::string& what) {
  if (!atWord()) failExpecting(what);
  return take();
}

Token TokenReader::word(std::string_view lower_case, const std::string& what) {
  if (!atWord(lower_case)) failExpecting(what);
  return take();
}

ast::Name TokenReader::name(const std::string& what) {
  if (!atName()) failExpecting(what);
  const Token token = take();
  return {token.text, token.position};
}

ast::Name TokenReader::variable(const std::string& what) {
  if (!atVariable()) failExpecting(what);
  const Token token = take();
  return {token.text, token.position};
}

void TokenReader::dash() {
  prefix(1);
}

Token TokenReader::prefix(std::size_t length) {
  if (length >= current_.text.size()) return take();
  const Token front{Token::Kind::Word, current_.text.substr(0, length), current_.position};
  current_.text.remove_prefix(length);
  current_.position.column += static_cast<int>(length);
  return front;
}

void TokenReader::finish() {
  if (!atEnd()) failExpecting("the end of the text");
}

Token TokenReader::take() {
  pollOrThrow(monitor_, "reading ", source_.name);
  if (current_.text.size() > kLongestWord) {
    fail(current_.position, inQuotes(current_.text) + " is longer than " +
                                std::to_string(kLongestWord) + " characters");
  }
  if (atWord()) {
    noteHead();
  } else {
    takeBracket();
  }
  const Token taken = current_;
  current_ = lexer_.next();
  return taken;
}

void TokenReader::takeBracket() {
  if (atOpen()) {
    // Checked here, before any reader recurses into it.
    if (open_.size() == kDeepestNesting) {
      fail(current_.position,
           "parentheses are nested deeper than " + std::to_string(kDeepestNesting));
    }
    open_.push_back({current_.position, {}, {}});
  } else if (atClose() && !open_.empty()) {
    closed_ = open_.back();
    closed_at_ = current_.position;
    open_.pop_back();
  }
}

void TokenReader::noteHead() {
  if (open_.empty()) return;
  Bracket& innermost = open_.back();
  if (innermost.head.empty()) {
    innermost.head = current_.text;
  } else if (innermost.name.empty() && toLower(innermost.head) == kAction) {
    innermost.name = current_.text;
  }
}

void TokenReader::failExpecting(const std::string& what, const std::string& hint) const {
  fail(current_.position, "expected " + what + ", found " + found() + hint + bracketHint());
}

void TokenReader::fail(SourcePosition position, const std::string& message) const {
  throw SyntaxError(source_.name, position, message);
}

void TokenReader::failUnsupported(SourcePosition position, const std::string& construct) const {
  throw UnsupportedError(source_.name, position,
                         "not supported yet: " + construct + ", at " + place_);
}

std::string TokenReader::found() const {
  return atEnd() ? "the end of the text" : inQuotes(current_.text);
}

// A parenthesis that is missing, or one too many, shows only later: where something stands that
// belongs further out or further in.
std::string TokenReader::bracketHint() const {
  if (open_.empty()) {
    const bool behind_all = atClose() || toLower(closed_.head) == "define";
    return closed_at_.line > 0 && behind_all ? closedEarly() : "";
  }
  const Bracket& innermost = open_.back();
  if (atEnd()) return stillOpen(innermost);
  const bool first_word = innermost.head.empty();
  if (open_.size() <= (first_word ? 2U : 1U)) return sectionHint();
  if (atKeyword()) {
    if (first_word) return stillOpen(open_[open_.size() - 2]);
    return toLower(innermost.head) == kAction ? "" : stillOpen(innermost);
  }
  if (!atOpen() || first_word) return "";
  return conjunctionEnded() ? closedEarly() : stillOpen(innermost);
}

/// Where only sections stand, what belongs into one was cut off from it.
std::string TokenReader::sectionHint() const {
  if (atOpen() || atClose()) return "";
  const std::string last = toLower(closed_.head);
  const bool of_action = last == kAction && !open_.back().head.empty() && !atWord(kAction);
  if (atKeyword() && !of_action) return "";
  return !last.empty() && last.front() == ':' ? closedEarly() : "";
}

bool TokenReader::atKeyword() const {
  return atWord() && current_.text.front() == ':';
}

/// At a `(`: whether it may have been meant for the `and` before it, and begins nothing new.
bool TokenReader::conjunctionEnded() const {
  const SourcePosition outer = open_.back().position;
  const SourcePosition last = closed_.position;
  if (std::tie(last.line, last.column) < std::tie(outer.line, outer.column)) return false;
  Lexer ahead = lexer_;
  const Token next = ahead.next();
  const bool keyword = next.kind == Token::Kind::Word && next.text.front() == ':';
  const std::string head = toLower(closed_.head);
  return !keyword && (head == "and" || head == "or");
}

std::string TokenReader::stillOpen(const Bracket& bracket) const {
  return "; the " + opened(bracket.head, bracket.name) + " at " + toString(bracket.position) +
         " is still open";
}

std::string TokenReader::closedEarly() const {
  return "; the ')' at " + toString(closed_at_) + " closes the " +
         opened(closed_.head, closed_.name) + " at " + toString(closed_.position) +
         ", and there may be one ')' too many";
}

}  // namespace goal_alignment::pddl
