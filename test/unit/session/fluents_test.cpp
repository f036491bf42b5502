// SPDX-License-Identifier: BSD-3-Clause
#include "session/fluents.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysed_desk.h"

namespace goal_alignment::session {
namespace {

using samples::AnalysedDesk;
using samples::literals;

TEST(Fluents, OfCandidates) {
  const AnalysedDesk at;
  const alignment::Problem& problem = at.analysis.problem();
  const auto set = at.setOf({"(held b)", "(free)"});
  EXPECT_EQ(fluentsOf(problem, set), literals({"(free)", "(held b)"}));
  EXPECT_EQ(specifiedAnd(problem, set), literals({"(down b)", "(free)", "(held b)"}));
}

TEST(Fluents, AreSpelledAsInTheModels) {
  const AnalysedDesk at;
  const alignment::Problem& problem = at.analysis.problem();
  EXPECT_EQ(listed(problem, literals({"(held b)", "(not (free))"})), "(held B), (not (free))");
  EXPECT_EQ(askedFor(problem), "(down B)");
  EXPECT_EQ(parameterNames(problem, "take"), std::vector<std::string>{"x"});
  EXPECT_TRUE(parameterNames(problem, "fly").empty());
}

}  // namespace
}  // namespace goal_alignment::session
