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
            "I can't do what you asked for: the hall is clean; and the den is quiet. That is "
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
  EXPECT_EQ(expectationUnachievable(tea(), conflict, {{conflict[0]}, {conflict[1]}}),
            "I can't have both: the hall is clean, and the hall is quiet. That is certain. I can "
            "do all but this: the hall is clean. Or all but this: the hall is quiet.");
  EXPECT_EQ(expectationUnachievable(tea(), literals({"(quiet hall)"}), {}),
            "I can't make it so that the hall is quiet, given what you asked for. That is "
            "certain.");
}

TEST(Outcomes, MoreAlternativesAreCounted) {
  std::vector<std::vector<Literal>> alternatives;
  for (const std::string& text : kSix)
    alternatives.push_back(literals({text}));
  const std::string six = expectationUnachievable({}, literals(kSix), alternatives);
  EXPECT_NE(six.find("all but this: \"p\" holds for c. There are 3 more ways."), std::string::npos)
      << six;
  alternatives.resize(kSpokenAlternatives + 1);
  const std::string four = expectationUnachievable({}, literals(kSix), alternatives);
  EXPECT_NE(four.find("There is one more way."), std::string::npos) << four;
}

TEST(Outcomes, WhatNobodyIsSureOfIsNamed) {
  const auto conflict = literals({"(clean hall)", "(quiet hall)"});
  EXPECT_EQ(unsureBlocks(tea(), conflict, true, {conflict[1]}),
            "I can't have both: the hall is clean, and the hall is quiet. It depends on whether "
            "this matters to you: the hall is quiet.");
  EXPECT_EQ(unsureBlocks(tea(), conflict, false, conflict),
            "I could not make sure that I can have both: the hall is clean, and the hall is quiet. "
            "It depends on which of these matter to you: the hall is clean; and the hall is "
            "quiet.");
}

TEST(Outcomes, WhatTheLimitsLeftOpenIsNoProof) {
  EXPECT_EQ(leftOpen(tea(), literals({"(clean hall)", "(quiet hall)"})),
            "I could not make sure that I can have both: the hall is clean, and the hall is quiet. "
            "My limits did not let me find out more.");
}

TEST(Outcomes, WhatWasAssumedIsNotPromised) {
  const std::string text = planWithout(tea(), literals({"(quiet den)"}));
  EXPECT_NE(text.find("I do not promise it: the den is quiet."), std::string::npos) << text;
}

TEST(Outcomes, SuppositionsSayWhatIsSupposed) {
  const auto wanted = literals({"(clean hall)", "(clean den)"});
  const auto not_wanted = literals({"(quiet hall)"});
  EXPECT_EQ(supposition(tea(), wanted, {}),
            "If it mattered that the hall is clean; and that the den is clean");
  EXPECT_EQ(supposition(tea(), {}, not_wanted), "If it did not matter that the hall is quiet");
  EXPECT_EQ(supposition(tea(), {wanted[0]}, not_wanted),
            "If it mattered that the hall is clean, and did not matter that the hall is quiet");
}

}  // namespace
}  // namespace goal_alignment::phrasing
