// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/alignment/beliefs.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/alignment/robot_analysis.h"
#include "goal_alignment/questions/policy.h"
#include "goal_alignment/session/session.h"
#include "thinking_budget.h"

namespace goal_alignment::session {

/// What was analysed: the problem, what the robot can achieve of it, what the person is believed to
/// want, and the policy that chooses questions. It grows phase by phase, in the order of the
/// methods below; each throws what the functions of `alignment` throw, LimitReached where the
/// budget ends it, and then leaves what was known before.
class Analysis {
 public:
  /// Both outlive this; `options` may change between two phases.
  Analysis(const Options& options, const ThinkingBudget& budget)
      : options_(options), budget_(budget) {}
  ~Analysis() = default;
  // The policy refers to the analysis, and the ground task to the problem.
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;
  Analysis(Analysis&&) = delete;
  Analysis& operator=(Analysis&&) = delete;

  /// Reads the models, and what the human expects. problem() is there afterwards.
  void read(const Input& input);
  /// Grounds the robot's model and finds the conflicts that take no search. robot() and policy()
  /// are there afterwards.
  void analyseRobot();
  /// Estimates what the person wants, unless that is known. beliefs() are there afterwards.
  void believe();
  /// Finds all conflicts, unless a plan for all of `wished` makes them needless. Where a limit ends
  /// it, the dialogue goes on inside the conflicts known.
  void findConflicts(const achievability::CandidateSet& wished);
  /// The robot's side has to be analysed anew. Throws pddl::SemanticError naming an atom that its
  /// model can't have, and std::logic_error without a problem; nothing has changed then.
  void setRobotState(const std::vector<GroundName>& atoms);

  bool hasProblem() const { return problem_ != nullptr; }
  const alignment::Problem& problem() const { return *problem_; }
  /// Empty without a problem.
  std::vector<GroundName> robotState() const;

  bool hasRobot() const { return robot_.achievability != nullptr; }
  achievability::Achievability& robot() { return *robot_.achievability; }
  const achievability::Achievability& robot() const { return *robot_.achievability; }
  const alignment::RobotAnalysis& robotAnalysis() const { return robot_; }
  bool unitCosts() const { return unit_costs_; }
  questions::Policy& policy() { return *policy_; }
  const questions::Policy& policy() const { return *policy_; }
  /// By candidate; empty before believe().
  const std::vector<double>& beliefs() const { return beliefs_; }

  /// What the policy sees of a dialogue in which so much is known of the candidates.
  questions::Situation situation(const std::vector<questions::Knowledge>& knowledge) const;
  /// A plan for all of these that is remembered, or null.
  const task::Plan* knownPlanFor(const achievability::CandidateSet& set) const;
  /// Why not all conflicts were found first, and which were; empty where that is no matter.
  const std::string& conflictsEnded() const { return conflicts_ended_; }
  std::size_t plannerCalls() const;
  const ThinkingBudget& budget() const { return budget_; }

 private:
  std::vector<double> costDifferences(alignment::CostOptions options);
  questions::PolicyContext policyContext();
  std::vector<bool> unachievableAlone();

  const Options& options_;
  const ThinkingBudget& budget_;
  // Through pointers: the ground task and the policy refer to what they were made from.
  std::unique_ptr<alignment::Problem> problem_;
  alignment::RobotAnalysis robot_;
  std::unique_ptr<questions::Policy> policy_;
  bool unit_costs_ = true;
  std::vector<double> beliefs_;
  std::string conflicts_ended_;
  std::size_t earlier_robot_calls_ = 0;  // made before the robot's state changed
  std::size_t belief_calls_ = 0;
};

}  // namespace goal_alignment::session
