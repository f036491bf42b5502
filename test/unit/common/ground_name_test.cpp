// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/ground_name.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

namespace goal_alignment {
namespace {

rc::Gen<std::string> anyWord() {
  return rc::gen::nonEmpty(rc::gen::container<std::string>(
      rc::gen::oneOf(rc::gen::inRange('a', 'z'), rc::gen::elementOf(std::string("0189-_?")))));
}

TEST(GroundName, ReadsWithAndWithoutParenthesesInAnyCase) {
  const GroundName on{"on", {"a", "b"}};
  EXPECT_EQ(GroundName::parse("(on a b)"), on);
  EXPECT_EQ(GroundName::parse("ON A b"), on);
  EXPECT_EQ(GroundName::parse(" \t( On\n a  B )\r\n"), on);
  EXPECT_EQ(GroundName::parse("(handempty)"), (GroundName{"handempty", {}}));
}

TEST(GroundName, RefusesWhatIsNoName) {
  for (const char* text : {"", "  ", "()", "(", ")", "(on a", "on a)", "((on a))", "(on (a))"}) {
    EXPECT_THROW(GroundName::parse(text), std::invalid_argument) << text;
  }
}

TEST(GroundName, QuotesTheRefusedText) {
  try {
    GroundName::parse("(on a");
    FAIL() << "an unbalanced text was read";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("'(on a'"), std::string::npos) << refused.what();
  }
}

TEST(GroundName, TellsArgumentsApart) {
  EXPECT_NE(GroundName::parse("(p a b)"), GroundName::parse("(p b a)"));
  EXPECT_NE(GroundName::parse("(p a)"), GroundName::parse("(p a a)"));
  EXPECT_LT(GroundName::parse("(p a)"), GroundName::parse("(p b)"));
  EXPECT_LT(GroundName::parse("(p)"), GroundName::parse("(p a)"));
  EXPECT_NE(std::hash<GroundName>{}(GroundName::parse("(p a b)")),
            std::hash<GroundName>{}(GroundName::parse("(p b a)")));
}

RC_GTEST_PROP(GroundName, IsReadBackFromItsText, ()) {
  const GroundName name{*anyWord(), *rc::gen::container<std::vector<std::string>>(anyWord())};
  RC_ASSERT(GroundName::parse(name.text()) == name);
}

TEST(Literal, ReadsNegationsAndWritesThem) {
  const Literal negated{{"on", {"a", "b"}}, true};
  EXPECT_EQ(Literal::parse("(not (on a b))"), negated);
  EXPECT_EQ(Literal::parse("( NOT(on A b) )"), negated);
  EXPECT_EQ(negated.text(), "(not (on a b))");
  EXPECT_EQ(Literal::parse("(on a b)"), (Literal{{"on", {"a", "b"}}, false}));
  EXPECT_NE(Literal::parse("(on a b)"), negated);
}

TEST(Literal, APredicateMayBeginLikeNot) {
  EXPECT_EQ(Literal::parse("(nothing)"), (Literal{{"nothing", {}}, false}));
  EXPECT_EQ(Literal::parse("(not-closed a)"), (Literal{{"not-closed", {"a"}}, false}));
}

TEST(Literal, RefusesWhatIsNoLiteral) {
  for (const char* text : {"", "(not ())", "(not (p)", "(not (not (p)))", "(and (p))"}) {
    EXPECT_THROW(Literal::parse(text), std::invalid_argument) << text;
  }
}

TEST(ToLower, ChangesAsciiLettersAlone) {
  EXPECT_EQ(toLower("AZaz09-_[@`{"), "azaz09-_[@`{");
  EXPECT_EQ(toLower("\xC3\x84"), "\xC3\x84");
}

TEST(Trimmed, TakesOffBlanksAndLineEnds) {
  EXPECT_EQ(trimmed(" \t(on a b)\r\n"), "(on a b)");
  EXPECT_EQ(trimmed("a  b"), "a  b");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_EQ(trimmed(""), "");
}

}  // namespace
}  // namespace goal_alignment
