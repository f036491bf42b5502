// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/outcomes.h"

#include <gtest/gtest.h>

namespace goal_alignment::phrasing {
namespace {

Phrases tea() {
  return Phrases::fromYaml(
      "predicates:\n  clean: \"{0} is clean\"\n  quiet: \"{0} is quiet\"\n"
      "objects:\n  hall: \"the hall\"\n  den: \"the den\"\n",
      "tea.yaml");
}

std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  for (const std::string& text : texts)
    result.push_back(Literal::parse(text));
  return result;
}

const std::vector<std::string> kSix = {"(p a)", "(p b)", "(p c)", "(p d)", "(p e)", "(p f)"};

TEST(Outcomes, AGoalThatCantBeIsNamed) {
  EXPECT_EQ(goalUnsolvable(tea(), literals({"(clean hall)"})),
            "I can't do what you asked for: the hall is clean. That is certain.");
  EXPECT_EQ(goalUnsolvable(tea(), literals({"(clean hall)", "(quiet den)"})),
            "I can't do what you asked for: the hall is clean, and the den is quiet. That is "
            "certain.");
  EXPECT_EQ(goalUnsolvable(tea(), {}), "I can't do what you asked for. That is certain.");
}

TEST(Outcomes, LongListsAreCut) {
  std::vector<std::string> many = kSix;
  const std::string six = goalUnsolvable({}, literals(many));
  EXPECT_NE(six.find("; and \"p\" holds for f."), std::string::npos) << six;
  many.emplace_back("(p g)");
  const std::string seven = goalUnsolvable({}, literals(many));
  EXPECT_NE(seven.find("\"p\" holds for e; and 2 more."), std::string::npos) << seven;
}

TEST(Outcomes, NoPlanHasItsReasonAndAFewAlternatives) {
  const auto conflict = literals({"(clean hall)", "(quiet hall)"});
  EXPECT_EQ(expectationUnachievable(tea(), {conflict, true}, {{conflict[0]}, {conflict[1]}}),
            "I can't have both: the hall is clean, and the hall is quiet. That is certain. I can "
            "do everything except: the hall is clean. Or everything except: the hall is quiet.");
  EXPECT_EQ(expectationUnachievable(tea(), {literals({"(quiet hall)"}), true}, {}),
            "I can't do what you asked for and this as well: the hall is quiet. That is certain.");
  EXPECT_EQ(expectationUnachievable(tea(), {literals({"(quiet hall)"}), true, 0, true}, {}),
            "I can't get this done at all: the hall is quiet. Nothing that I can do leads there. "
            "That is certain.");
}

TEST(Outcomes, MoreAlternativesAreCounted) {
  std::vector<std::vector<Literal>> alternatives;
  for (const std::string& text : kSix)
    alternatives.push_back(literals({text}));
  const std::string six = expectationUnachievable({}, {literals(kSix), true}, alternatives);
  EXPECT_NE(six.find("everything except: \"p\" holds for c. There are 3 more ways."),
            std::string::npos)
      << six;
  alternatives.resize(kSpokenAlternatives + 1);
  const std::string four = expectationUnachievable({}, {literals(kSix), true}, alternatives);
  EXPECT_NE(four.find("There is one more way."), std::string::npos) << four;
}

TEST(Outcomes, WhatNobodyIsSureOfIsNamed) {
  const auto conflict = literals({"(clean hall)", "(quiet hall)"});
  EXPECT_EQ(unsureBlocks(tea(), {conflict, true}, {conflict[1]}, {{conflict[0]}}),
            "I can't have both: the hall is clean, and the hall is quiet. It depends on whether "
            "this matters to you: the hall is quiet. I can do everything except: the hall is "
            "clean.");
  EXPECT_EQ(unsureBlocks(tea(), {conflict, false}, conflict, {}),
            "I could not find out whether I can have both: the hall is clean, and the hall is "
            "quiet. It depends on which of these matter to you: the hall is clean, and the hall is "
            "quiet.");
}

TEST(Outcomes, WhatTheLimitsLeftOpenIsNoProof) {
  const auto conflict = literals({"(clean hall)", "(quiet hall)"});
  EXPECT_EQ(leftOpen(tea(), conflict, Limit::Time),
            "I could not find out whether I can have both: the hall is clean, and the hall is "
            "quiet. I ran out of time.");
  EXPECT_NE(leftOpen(tea(), conflict, Limit::Memory).find("I ran out of memory."),
            std::string::npos);
  EXPECT_NE(leftOpen(tea(), conflict, Limit::Budget).find("more time would not help."),
            std::string::npos);
  EXPECT_EQ(leftOpen(tea(), "at the search for a plan", Limit::Time),
            "I ran out of time before I could find out (at the search for a plan).");
}

TEST(Outcomes, WhatWasAssumedIsNotPromised) {
  EXPECT_EQ(planFound(tea(), {}),
            "I have a plan. It does what you asked and keeps everything you didn't rule out.");
  EXPECT_EQ(planFound(tea(), literals({"(quiet den)"})),
            "I have a plan. It does what you asked and keeps everything you didn't rule out. I "
            "don't promise this, since nobody was asked about it: the den is quiet.");
}

TEST(Outcomes, APlanThatLeadsElsewhereSaysWhatIsMissing) {
  EXPECT_EQ(planMisses(tea(), literals({"(quiet den)"}), true),
            "Your plan does not lead to what you asked for. At its end this is not so: the den is "
            "quiet.");
  EXPECT_EQ(planMisses(tea(), literals({"(quiet den)"}), false),
            "You gave me no plan, so I can't know what you expect. This is not so now: the den is "
            "quiet.");
}

TEST(Outcomes, SuppositionsSayWhatIsSupposed) {
  const auto wanted = literals({"(clean hall)", "(clean den)"});
  const auto not_wanted = literals({"(quiet hall)"});
  EXPECT_EQ(supposition(tea(), wanted, {}),
            "If it mattered that the hall is clean, and that the den is clean");
  EXPECT_EQ(supposition(tea(), {}, {}), "As things stand");
  EXPECT_EQ(supposition(tea(), {}, not_wanted), "If it did not matter that the hall is quiet");
  EXPECT_EQ(supposition(tea(), {wanted[0]}, not_wanted),
            "If it mattered that the hall is clean, and did not matter that the hall is quiet");
}

}  // namespace
}  // namespace goal_alignment::phrasing
