// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/lexer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using namespace std::string_literals;

/// `text@line:column` of every token, End included.
std::vector<std::string> tokens(const std::string& text) {
  const Source source{"t", text};
  Lexer lexer(source);
  std::vector<std::string> seen;
  for (;;) {
    const Token token = lexer.next();
    const bool end = token.kind == Token::Kind::End;
    seen.push_back((end ? "<end>" : std::string(token.text)) + "@" +
                   std::to_string(token.position.line) + ":" +
                   std::to_string(token.position.column));
    if (end) return seen;
  }
}

using Tokens = std::vector<std::string>;

TEST(Lexer, CutsWordsAndParentheses) {
  EXPECT_EQ(tokens("(on ?x b-1)"),
            (Tokens{"(@1:1", "on@1:2", "?x@1:5", "b-1@1:8", ")@1:11", "<end>@1:12"}));
  EXPECT_EQ(tokens("a(b)c"), (Tokens{"a@1:1", "(@1:2", "b@1:3", ")@1:4", "c@1:5", "<end>@1:6"}));
}

TEST(Lexer, AVariableBeginsAWordOfItsOwn) {
  EXPECT_EQ(tokens("at?x?y"), (Tokens{"at@1:1", "?x@1:3", "?y@1:5", "<end>@1:7"}));
}

TEST(Lexer, CountsLinesWhateverEndsThem) {
  EXPECT_EQ(tokens("a\nb\r\nc\rd\n\n\te"),
            (Tokens{"a@1:1", "b@2:1", "c@3:1", "d@4:1", "e@6:2", "<end>@6:3"}));
}

TEST(Lexer, SkipsCommentsUpToTheLinesEnd) {
  EXPECT_EQ(tokens("a;b (c\nd;"), (Tokens{"a@1:1", "d@2:1", "<end>@2:3"}));
  EXPECT_EQ(tokens(";x\r\nd"), (Tokens{"d@2:1", "<end>@2:2"}));
  EXPECT_EQ(tokens("; \xC3\xA9\na"), (Tokens{"a@2:1", "<end>@2:2"})) << "any text in a comment";
}

TEST(Lexer, SkipsAByteOrderMark) {
  EXPECT_EQ(tokens("\xEF\xBB\xBF(a"), (Tokens{"(@1:1", "a@1:2", "<end>@1:3"}));
}

TEST(Lexer, AnEmptyTextEndsAtOnceAndForEver) {
  EXPECT_EQ(tokens(""), Tokens{"<end>@1:1"});
  const Source source{"t", " "};
  Lexer lexer(source);
  EXPECT_EQ(lexer.next().kind, Token::Kind::End);
  EXPECT_EQ(lexer.next().kind, Token::Kind::End);
}

TEST(Lexer, LettersBeyondAsciiAreLetters) {
  EXPECT_EQ(tokens("küche?größe"), (Tokens{"küche@1:1", "?größe@1:7", "<end>@1:15"}))
      << "a column is a byte";
  EXPECT_EQ(tokens("(お茶 в)"), (Tokens{"(@1:1", "お茶@1:2", "в@1:9", ")@1:11", "<end>@1:12"}));
  EXPECT_EQ(tokens("a\u0308 l·l m²"), (Tokens{"a\u0308@1:1", "l·l@1:5", "m²@1:10", "<end>@1:13"}));
}

std::string error(const std::string& text) {
  return samples::errorOf<SyntaxError>([&] { tokens(text); });
}

TEST(Lexer, WhatOnlyLooksLikePddlIsNamed) {
  EXPECT_EQ(error("rex – robot"), "t:1:5: expected PDDL text, found U+2013, a dash other than '-'");
  EXPECT_EQ(error("rex\u00a0robot"),
            "t:1:4: expected PDDL text, found U+00a0, a blank other than ' '");
  EXPECT_EQ(error("“rex”"), "t:1:1: expected PDDL text, found U+201c, a quotation mark");
  EXPECT_EQ(error("\n\u200bx"), "t:2:1: expected PDDL text, found U+200b, a blank other than ' '");
}

TEST(Lexer, NamesTheByteThatNoPddlHolds) {
  EXPECT_EQ(error("(a\n \0)"s), "t:2:2: expected PDDL text, found the byte 0x00");
  EXPECT_EQ(error("; \0"s), "t:1:3: expected PDDL text, found the byte 0x00");
  EXPECT_EQ(error("\xFF\xFE("),
            "t:1:1: expected PDDL text, found the byte 0xff; the text is UTF-16, and UTF-8 "
            "is read");
  EXPECT_EQ(error("caf\xE9"),
            "t:1:4: expected PDDL text, found the byte 0xe9, which is no UTF-8; "
            "in Latin-1 it is 'é'");
  EXPECT_EQ(error("caf\xC3"),
            "t:1:4: expected PDDL text, found the byte 0xc3, which is no UTF-8; "
            "in Latin-1 it is 'Ã'");
  EXPECT_EQ(error("a\x81"), "t:1:2: expected PDDL text, found the byte 0x81, which is no UTF-8");
  EXPECT_EQ(error("a\x7f"), "t:1:2: expected PDDL text, found the byte 0x7f");
}

}  // namespace
}  // namespace goal_alignment::pddl
