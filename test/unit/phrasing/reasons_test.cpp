// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/phrasing/phrases.h"

/// Why something is asked, where the answers lead, and what there is instead.
namespace goal_alignment::phrasing {
namespace {

using questions::Prospect;
using questions::Reason;
using Ending = Prospect::Ending;

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
      "If it does, I can't do all that you want.");
  EXPECT_EQ(kPlain.why({conflict({"(p)"}, false)}, {Ending::Undecided, 0, 0}, {Ending::Open, 2, 1},
                       false),
            "I could not make sure that I can make it so that \"p\" holds, given what you asked "
            "for. If not, I need not ask about 2 other things. If it does, I don't know whether I "
            "can do all that you want.");
  EXPECT_EQ(
      kPlain.why({conflict({"(p)", "(q)"})}, {Ending::Open, 0, 1}, {Ending::Open, 0, 1}, false),
      "I can't have both: \"p\" holds, and \"q\" holds. If it does, something else has to "
      "give way.");
}

TEST(Reasons, WhatIsProvisionalIsNotPromised) {
  const std::string why =
      kPlain.why({conflict({"(p)"})}, {Ending::NoPlan, 0, 0}, {Ending::Plan, 0, 0}, true);
  EXPECT_NE(why.find("nothing that I know of stands in the way"), std::string::npos) << why;
  EXPECT_EQ(why.find("I can do all the rest"), std::string::npos) << why;
}

TEST(Reasons, OfAGroupEachOnceAndFewOfThem) {
  const std::vector<Reason> reasons = {conflict({"(a)"}), conflict({"(b)"}), conflict({"(a)"}),
                                       conflict({"(c)"}), conflict({"(d)"})};
  const std::string why = kPlain.why(reasons, {Ending::NoPlan, 0, 0}, {Ending::Plan, 0, 0}, false);
  EXPECT_EQ(why.find("\"a\""), why.rfind("\"a\""));
  EXPECT_EQ(why.find("\"d\""), std::string::npos);
  EXPECT_NE(why.find("There are more such reasons."), std::string::npos) << why;
  EXPECT_NE(why.find("If none of them does,"), std::string::npos) << why;
  EXPECT_NE(why.find("If all of them do,"), std::string::npos) << why;
}

TEST(Reasons, CostsAreAReason) {
  Reason reason;
  reason.extra_cost = 6;
  EXPECT_EQ(kPlain.why({reason}, {Ending::Plan, 0, 0}, {Ending::Plan, 0, 0}, false),
            "To keep it so costs 6 more than a plan for what I know to be wanted. If not, I can do "
            "all the rest.");
}

TEST(Reasons, WithoutAReasonNothingIsMadeUp) {
  EXPECT_EQ(kPlain.why({Reason{}}, {Ending::Open, 0, 3}, {Ending::Open, 0, 3}, false), "");
}

TEST(Reasons, AlternativesInTheirOrder) {
  EXPECT_EQ(kPlain.alternatives({}), "");
  EXPECT_EQ(kPlain.alternatives({{literal("(p)")}, {literal("(q a)"), literal("(r)")}}),
            "I can do all but this: \"p\" holds. Or all but this: \"q\" holds for a; and \"r\" "
            "holds.");
}

}  // namespace
}  // namespace goal_alignment::phrasing
