// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rapidcheck/gtest.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/grounding/grounder.h"
#include "oracles/random_hagl.h"

/// What the tests of `achievability` share.
namespace goal_alignment::achievability::samples {

/// Budgets that make each stage of a proof the one that answers: greedy search, each of the sweeps
/// through the reachable states, and greedy search after sweeps that did not finish.
inline std::vector<SearchBudget> stageBudgets() {
  return {SearchBudget{},          {100'000, 1, 1, 1, 1},   {1, 1'000'000, 1, 1, 1},
          {1, 1, 1'000'000, 1, 1}, {1, 1, 1, 1'000'000, 1}, {1, 1, 1, 1, 1'000'000, 3}};
}

inline std::unique_ptr<Achievability> make(const oracles::Hagl& hagl,
                                           const SearchBudget& budget = {},
                                           const Limits& limits = {}) {
  std::vector<Literal> goals = hagl.specified;
  goals.insert(goals.end(), hagl.candidates.begin(), hagl.candidates.end());
  return std::make_unique<Achievability>(grounding::ground(hagl.robot, goals, {}, {}),
                                         hagl.specified, hagl.candidates, budget, limits);
}

inline CandidateSet setOf(std::size_t candidates, std::uint64_t bits) {
  return CandidateSet(candidates, bits);
}

inline std::set<oracles::CandidateBits> provenConflicts(const Achievability& robot) {
  std::set<oracles::CandidateBits> sets;
  for (const Conflict& conflict : robot.conflicts()) {
    if (conflict.proven) sets.insert(conflict.members.to_ulong());
  }
  return sets;
}

/// What is known must be true, however little was searched.
inline void requireSound(const oracles::Hagl& hagl, const Achievability& robot) {
  const std::set<oracles::CandidateBits> minimal = hagl.minimalConflicts();
  for (const Conflict& conflict : robot.conflicts()) {
    const oracles::CandidateBits set = conflict.members.to_ulong();
    if (conflict.proven) RC_ASSERT(!hagl.achievable(set));
    if (conflict.minimal) RC_ASSERT(conflict.proven && minimal.count(set) > 0);
  }
  for (const auto& achieved : robot.achieved())
    RC_ASSERT(hagl.achievable(achieved.set.to_ulong()));
  if (robot.complete()) RC_ASSERT(provenConflicts(robot) == minimal);
}

/// The four files and the plan, for a failing case.
inline std::string text(const oracles::Hagl& hagl) {
  std::string result = hagl.input.robot_domain.text + hagl.input.robot_problem.text +
                       hagl.input.human_domain.text + hagl.input.human_problem.text + "; plan";
  for (const GroundName& step : hagl.input.human_plan)
    result += " " + step.text();
  result += "\n; specified";
  for (const Literal& literal : hagl.specified)
    result += " " + literal.text();
  result += "\n; true goal";
  for (const Literal& literal : hagl.true_goal)
    result += " " + literal.text();
  return result + "\n";
}

}  // namespace goal_alignment::achievability::samples
