// SPDX-License-Identifier: BSD-3-Clause
#include "token_reader.h"

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

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

void TokenReader::finish() {
  if (!atEnd()) failExpecting("the end of the text");
}

Token TokenReader::take() {
  pollOrThrow(monitor_, "reading ", source_.name);
  if (current_.text.size() > kLongestWord) {
    fail(current_.position, inQuotes(current_.text) + " is longer than " +
                                std::to_string(kLongestWord) + " characters");
  }
  if (atOpen()) {
    // Checked here, before any reader recurses into it.
    if (open_.size() == kDeepestNesting) {
      fail(current_.position,
           "parentheses are nested deeper than " + std::to_string(kDeepestNesting));
    }
    open_.push_back(current_.position);
  } else if (atClose() && !open_.empty()) {
    open_.pop_back();
  }
  const Token taken = current_;
  current_ = lexer_.next();
  return taken;
}

void TokenReader::failExpecting(const std::string& what, const std::string& hint) const {
  fail(current_.position, "expected " + what + ", found " + found() + hint);
}

void TokenReader::fail(SourcePosition position, const std::string& message) const {
  throw SyntaxError(source_.name, position, message);
}

void TokenReader::failUnsupported(SourcePosition position, const std::string& construct) const {
  throw UnsupportedError(source_.name, position,
                         "not supported yet: " + construct + ", at " + place_);
}

// A missing `)` shows only at the end, far from its place: the innermost open `(` helps.
std::string TokenReader::found() const {
  if (!atEnd()) return inQuotes(current_.text);
  std::string text = "the end of the text";
  if (!open_.empty()) text += "; the '(' at " + toString(open_.back()) + " is still open";
  return text;
}

}  // namespace goal_alignment::pddl
