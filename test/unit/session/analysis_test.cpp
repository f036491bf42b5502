// SPDX-License-Identifier: BSD-3-Clause
#include "session/analysis.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::session {
namespace {

using samples::AnalysedDesk;
using samples::desk;

TEST(Analysis, GrowsPhaseByPhase) {
  const Options options;
  const ThinkingBudget budget(options.time_limit, options.memory_limit);
  Analysis analysis(options, budget);
  EXPECT_FALSE(analysis.hasProblem());
  EXPECT_TRUE(analysis.robotState().empty());
  EXPECT_THROW(analysis.setRobotState({}), std::logic_error);
  analysis.read(desk());
  EXPECT_TRUE(analysis.hasProblem());
  EXPECT_EQ(analysis.robotState().size(), 5U);
  EXPECT_FALSE(analysis.hasRobot());
  analysis.analyseRobot();
  EXPECT_TRUE(analysis.hasRobot());
  EXPECT_TRUE(analysis.beliefs().empty());
  analysis.believe();
  EXPECT_EQ(analysis.beliefs().size(), analysis.problem().candidates.size());
  analysis.findConflicts(~achievability::CandidateSet(analysis.beliefs().size()));
  EXPECT_TRUE(analysis.robot().complete());
  EXPECT_EQ(analysis.robot().conflicts().size(), 3U);
  EXPECT_EQ(analysis.conflictsEnded(), "");
}

TEST(Analysis, KeepsBeliefsAndCountsWhenTheRobotsStateChanges) {
  AnalysedDesk at;
  const std::vector<double> beliefs = at.analysis.beliefs();
  const std::size_t calls = at.analysis.plannerCalls();
  EXPECT_GT(calls, 0U);
  at.analysis.setRobotState({{"free", {}}, {"down", {"b"}}});
  EXPECT_FALSE(at.analysis.hasRobot());
  EXPECT_EQ(at.analysis.plannerCalls(), calls);
  EXPECT_EQ(at.analysis.beliefs(), beliefs);
  EXPECT_EQ(at.analysis.robotState().size(), 2U);
  at.analysis.analyseRobot();
  EXPECT_TRUE(at.analysis.hasRobot());
}

TEST(Analysis, AStateThatTheModelCannotHaveChangesNothing) {
  AnalysedDesk at;
  EXPECT_THROW(at.analysis.setRobotState({{"free", {}}, {"flies", {"b"}}}), pddl::SemanticError);
  EXPECT_TRUE(at.analysis.hasRobot());
  EXPECT_EQ(at.analysis.robotState().size(), 5U);
}

TEST(Analysis, ALimitLeavesWhatWasKnownBefore) {
  Options options;
  options.negative_candidates = true;
  ThinkingBudget budget(options.time_limit, options.memory_limit);
  Analysis analysis(options, budget);
  budget.cancel().cancel();
  EXPECT_THROW(analysis.read(desk()), LimitReached);
  EXPECT_FALSE(analysis.hasProblem());
}

TEST(Analysis, RemembersPlansForAllThatTheyAchieve) {
  AnalysedDesk at;
  EXPECT_EQ(at.analysis.knownPlanFor(at.setOf({"(held b)"})), nullptr);
  EXPECT_NE(at.analysis.knownPlanFor(at.none()), nullptr);
}

}  // namespace
}  // namespace goal_alignment::session
