// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "achievability/candidates_alone.h"
#include "achievability/conflict_enumeration.h"
#include "achievability/conflict_minimiser.h"
#include "achievability/goal_set_knowledge.h"
#include "achievability/goal_set_prover.h"
#include "achievability/goal_set_task.h"
#include "achievability/planner.h"
#include "achievability/reachable_states.h"
#include "goal_alignment/grounding/grounder.h"
#include "oracles/random_hagl.h"

namespace goal_alignment::achievability::samples {

inline grounding::GroundTask grounded(const oracles::Hagl& hagl) {
  std::vector<Literal> goals = hagl.specified;
  goals.insert(goals.end(), hagl.candidates.begin(), hagl.candidates.end());
  return grounding::ground(hagl.robot, goals, {}, {});
}

/// The parts of an Achievability, each to be tested by itself.
struct Parts {
  SearchBudget budget;
  GoalSetTask task;
  GoalSetKnowledge knowledge{task};
  Planner planner{task, budget.threads};
  ReachableStates reachable{task, knowledge, planner, budget};
  ConflictMinimiser minimiser{task, knowledge, planner, reachable, budget};
  GoalSetProver prover{task, knowledge, planner, reachable, minimiser, budget};
  CandidatesAlone alone{task, knowledge, planner, reachable, budget};
  ConflictEnumeration enumeration{task, knowledge, planner, reachable, prover, budget};

  explicit Parts(const oracles::Hagl& hagl, const SearchBudget& given = {})
      : budget(given), task(grounded(hagl), hagl.specified, hagl.candidates, {}) {}
};

}  // namespace goal_alignment::achievability::samples
