// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/problem.h"

#include <algorithm>
#include <set>
#include <utility>

#include "goal_alignment/common/listed.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/grounding/relaxed_reachability.h"

namespace goal_alignment::alignment {

namespace {

std::vector<Literal> sorted(std::vector<Literal> literals) {
  std::sort(literals.begin(), literals.end());
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  return literals;
}

std::string goalText(const std::vector<Literal>& literals, const std::string& condition) {
  return listed(literals) + (literals.empty() || condition.empty() ? "" : ", ") + condition;
}

void specifyByFiles(Problem& problem) {
  problem.specified = sorted(problem.human.goalLiterals());
  problem.condition = problem.human.goalConditionText();
  const std::vector<Literal> robot_goal = sorted(problem.robot.goalLiterals());
  const std::string robot_condition = problem.robot.goalConditionText();
  if (robot_goal == problem.specified && robot_condition == problem.condition) return;
  throw GoalsDiffer("the two problems must have one goal: " + problem.robot.problem_source +
                    " says " + goalText(problem.robot.goalLiterals(), robot_condition) + ", " +
                    problem.human.problem_source + " says " +
                    goalText(problem.human.goalLiterals(), problem.condition));
}

/// The goal stands in for that of the files, of which nothing remains.
void specifyByHand(Problem& problem, const std::vector<Literal>& goal) {
  for (const Literal& literal : goal) {
    std::string why_not;
    if (problem.human.resolve(literal.atom, &why_not)) continue;
    throw pddl::SemanticError("the task's goal", {},
                              shortened(literal.text()) + " has no meaning in " +
                                  problem.human.problem_source + ": " + why_not);
  }
  problem.specified = sorted(goal);
  problem.robot.setGoal({});
  problem.human.setGoal({});
}

bool changes(const pddl::Model& model, const GroundName& atom) {
  const auto predicate = model.findPredicate(atom.name);
  return predicate && model.predicates[static_cast<std::size_t>(*predicate)].fluent;
}

/// Adds the fluent as a candidate unless it was asked for anyway.
void addCandidate(Problem& problem, Literal fluent) {
  if (std::binary_search(problem.specified.begin(), problem.specified.end(), fluent)) return;
  const bool is_static =
      !changes(problem.human, fluent.atom) && !changes(problem.robot, fluent.atom);
  problem.candidates.push_back({std::move(fluent), is_static});
}

void sortCandidates(Problem& problem, LimitMonitor& monitor) {
  std::sort(problem.candidates.begin(), problem.candidates.end(),
            [&](const Candidate& a, const Candidate& b) {
              pollOrThrow(monitor, "finding what the person expects");
              return a.fluent < b.fluent;
            });
}

void findCandidates(Problem& problem, const Limits& limits) {
  LimitMonitor monitor(limits);
  for (const pddl::Atom& atom : problem.expectation.finalState()) {
    pollOrThrow(monitor, "finding what the person expects");
    addCandidate(problem, {problem.human.name(atom), false});
  }
  sortCandidates(problem, monitor);
}

}  // namespace

HumanPlanInvalid::HumanPlanInvalid(const validation::Violation& violation)
    : Exception("the human's plan does not run in the human's model: " + violation.message),
      violation_(violation) {}

GoalNotExpected::GoalNotExpected(const std::vector<Literal>& missing, const std::string& condition,
                                 bool plan_is_empty)
    : Exception(plan_is_empty
                    ? "no plan given: I can't know what you expect; not so now: " +
                          goalText(missing, condition)
                    : "the human's plan does not lead to the specified goal: at its end " +
                          goalText(missing, condition) + " is not so"),
      missing_(missing),
      has_condition_(!condition.empty()) {}

std::vector<Literal> literals(const Problem& problem) {
  std::vector<Literal> result = problem.specified;
  for (const Candidate& candidate : problem.candidates)
    result.push_back(candidate.fluent);
  return result;
}

Problem makeProblem(pddl::Model robot, pddl::Model human, const std::vector<Literal>& goal,
                    std::vector<GroundName> human_plan, const Limits& limits) {
  Problem problem;
  problem.robot = std::move(robot);
  problem.human = std::move(human);
  problem.human_plan = std::move(human_plan);
  if (goal.empty()) {
    specifyByFiles(problem);
  } else {
    specifyByHand(problem, goal);
  }
  problem.expectation = validation::execute(problem.human, problem.human_plan, limits);
  if (problem.expectation.violation) throw HumanPlanInvalid(*problem.expectation.violation);
  const validation::AtomSet& expected = problem.expectation.finalState();
  const std::vector<Literal> missing =
      validation::unsatisfied(problem.human, expected, problem.specified, limits);
  const bool condition = validation::satisfiesCondition(problem.human, expected, limits);
  if (!missing.empty() || !condition) {
    throw GoalNotExpected(missing, condition ? "" : problem.condition, problem.human_plan.empty());
  }
  findCandidates(problem, limits);
  return problem;
}

void addNegativeCandidates(Problem& problem, const Limits& limits) {
  const grounding::RelaxedReachability reachable =
      grounding::relaxedReachability(problem.robot, limits);
  std::set<GroundName> expected;
  for (const pddl::Atom& atom : problem.expectation.finalState())
    expected.insert(problem.human.name(atom));
  LimitMonitor monitor(limits);
  for (const pddl::AtomView& atom : reachable.atoms) {
    pollOrThrow(monitor, "finding side effects");
    GroundName name = problem.robot.name(atom);
    if (expected.count(name) == 0) addCandidate(problem, {std::move(name), true});
  }
  sortCandidates(problem, monitor);
}

}  // namespace goal_alignment::alignment
