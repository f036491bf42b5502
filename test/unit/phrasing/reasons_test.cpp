// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/phrasing/phrases.h"

/// Why something is asked, where the answers lead, and what there is instead.
namespace goal_alignment::phrasing {
namespace {

using questions::AnswerEffect;
using questions::Reason;
using Ending = AnswerEffect::Ending;

Literal literal(const std::string& text) {
  return Literal::parse(text);
}

Reason conflict(const std::vector<std::string>& texts, bool proven = true) {
  Reason reason;
  for (const std::string& text : texts)
    reason.conflict.push_back(literal(text));
  reason.proven = proven;
  return reason;
}

const Phrases kPlain;

TEST(Reasons, AConflictAndWhereTheAnswersLead) {
  EXPECT_EQ(
      kPlain.why({conflict({"(p a)", "(q)"})}, {Ending::NoPlan, 0, 0}, {Ending::Plan, 0, 0}, false),
      "I can't have both: \"p\" holds for a, and \"q\" holds. If not, I can do all the rest. "
      "If it does, I can't do everything you want.");
  EXPECT_EQ(kPlain.why({conflict({"(p)"}, false)}, {Ending::Undecided, 0, 0}, {Ending::Open, 2, 1},
                       false),
            "I could not find out whether I can do what you asked for and this as well: \"p\" "
            "holds. If not, that saves 2 more questions. If it does, I don't know whether I can do "
            "everything you want.");
  EXPECT_EQ(
      kPlain.why({conflict({"(p)", "(q)"})}, {Ending::Open, 0, 1}, {Ending::Open, 0, 1}, false),
      "I can't have both: \"p\" holds, and \"q\" holds. If it does, I have to leave "
      "something else out.");
  EXPECT_EQ(
      kPlain.why({conflict({"(p)", "(q)"})}, {Ending::Plan, 0, 0}, {Ending::Open, 1, 1}, false),
      "I can't have both: \"p\" holds, and \"q\" holds. If not, that saves one more "
      "question.");
}

TEST(Reasons, WhatIsProvisionalIsNotPromised) {
  const std::string why =
      kPlain.why({conflict({"(p)"})}, {Ending::NoPlan, 0, 0}, {Ending::Plan, 0, 0}, true);
  EXPECT_NE(why.find("If not, I can go ahead."), std::string::npos) << why;
  EXPECT_EQ(why.find("I can do all the rest"), std::string::npos) << why;
}

TEST(Reasons, OfAGroupEachOnceAndFewOfThem) {
  const std::vector<Reason> reasons = {conflict({"(a)"}), conflict({"(b)"}), conflict({"(a)"}),
                                       conflict({"(c)"}), conflict({"(d)"})};
  const std::string why = kPlain.why(reasons, {Ending::NoPlan, 0, 0}, {Ending::Plan, 0, 0}, false);
  EXPECT_EQ(why.find("\"a\""), why.rfind("\"a\""));
  EXPECT_EQ(why.find("\"d\""), std::string::npos);
  EXPECT_NE(why.find("There are more reasons of this kind."), std::string::npos) << why;
  EXPECT_NE(why.find("If none of them does,"), std::string::npos) << why;
  EXPECT_NE(why.find("If all of them do,"), std::string::npos) << why;
}

TEST(Reasons, CostsAreAReason) {
  Reason reason;
  reason.extra_cost = 6;
  EXPECT_EQ(kPlain.why({reason}, {Ending::Plan, 0, 0}, {Ending::Plan, 0, 0}, false),
            "That would cost 6 more than a plan for what I know you want. If not, I can do all the "
            "rest.");
}

TEST(Reasons, WithoutAReasonNothingIsMadeUp) {
  EXPECT_EQ(kPlain.why({Reason{}}, {Ending::Open, 0, 3}, {Ending::Open, 0, 3}, false), "");
}

TEST(Reasons, AlternativesInTheirOrder) {
  EXPECT_EQ(kPlain.alternatives({}), "");
  EXPECT_EQ(kPlain.alternatives({{literal("(p)")}, {literal("(q a)"), literal("(r)")}}),
            "I can do everything except: \"p\" holds. Or everything except: \"q\" holds for a, and "
            "\"r\" holds.");
}

}  // namespace
}  // namespace goal_alignment::phrasing
