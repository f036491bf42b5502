// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/validation/execution.h"

/// The HAGL problem of goal-alignment.tex, Definition 2, without its oracle: what there is to ask
/// about.
namespace goal_alignment::alignment {

/// The two problem files state different goals.
class GoalsDiffer : public Exception {
 public:
  using Exception::Exception;
};

/// A step of π^H can't be executed in the human model.
class HumanPlanInvalid : public Exception {
 public:
  explicit HumanPlanInvalid(const validation::Violation& violation);
  std::size_t step() const noexcept { return violation_.step; }
  const validation::Violation& violation() const noexcept { return violation_; }

 private:
  validation::Violation violation_;
};

/// S^H does not satisfy G^H.
class GoalNotExpected : public Exception {
 public:
  /// `condition`: the text of the goal's condition where that is false, else empty.
  GoalNotExpected(const std::vector<Literal>& missing, const std::string& condition,
                  bool plan_is_empty);
  const std::vector<Literal>& missing() const noexcept { return missing_; }
  /// Whether more is missing than literals can say.
  bool hasCondition() const noexcept { return has_condition_; }

 private:
  std::vector<Literal> missing_;
  bool has_condition_;
};

/// A fluent of S^H \ G^H, or the negation of one outside S^H: the person may want it, and nobody
/// knows yet.
struct Candidate {
  Literal fluent;
  bool is_static = false;  ///< no action of either model adds or deletes its predicate
};

struct Problem {
  pddl::Model robot;
  pddl::Model human;
  std::vector<Literal> specified;  ///< the literal conjuncts of G^H, sorted
  std::string condition;  ///< what G^H asks besides, the same in both models; empty: nothing.
                          ///< As a formula it is each model's Model::goal_condition.
  std::vector<GroundName> human_plan;  ///< π^H
  validation::Execution expectation;   ///< π^H executed in the human model; its last state is S^H
  std::vector<Candidate> candidates;   ///< sorted by fluent
};

/// The literals of G^H and all candidates. Who looks them up in a grounded model must have had it
/// grounded with them: a negated one is a fact only where it was asked for.
std::vector<Literal> literals(const Problem& problem);

/// Puts the problem together: G^H is `goal`, or that of the problem files where it is empty, which
/// then may have a condition that is no conjunction of literals: it is kept as one. S^H is where
/// π^H leads in the human model. Throws GoalsDiffer, HumanPlanInvalid, GoalNotExpected and
/// pddl::SemanticError (a goal that the human model can't name), LimitReached.
/// O(size of the models + sum of the states on the way).
Problem makeProblem(pddl::Model robot, pddl::Model human, const std::vector<Literal>& goal,
                    std::vector<GroundName> human_plan, const Limits& limits = {});

/// Side effects: adds the candidate "not f" for every f outside S^H that is true in some state
/// which the robot can reach even without deletes, its initial one included. Throws LimitReached.
/// Takes as long as grounding the robot's model.
void addNegativeCandidates(Problem& problem, const Limits& limits);

}  // namespace goal_alignment::alignment
