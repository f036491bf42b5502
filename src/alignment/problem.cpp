// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/problem.h"

#include <algorithm>
#include <utility>

namespace goal_alignment::alignment {

namespace {

std::string listed(const std::vector<Literal>& literals) {
  std::string text;
  for (const Literal& literal : literals)
    text += (text.empty() ? "" : ", ") + literal.text();
  return text;
}

std::vector<Literal> sorted(std::vector<Literal> literals) {
  std::sort(literals.begin(), literals.end());
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  return literals;
}

std::vector<Literal> specifiedGoal(const pddl::Model& robot, const pddl::Model& human,
                                   const std::vector<Literal>& goal) {
  if (goal.empty()) {
    std::vector<Literal> human_goal = sorted(human.goalLiterals());
    if (sorted(robot.goalLiterals()) != human_goal) {
      throw GoalsDiffer("the two problems must have one goal: " + robot.problem_source + " says " +
                        listed(robot.goalLiterals()) + ", " + human.problem_source + " says " +
                        listed(human.goalLiterals()));
    }
    return human_goal;
  }
  for (const Literal& literal : goal) {
    std::string why_not;
    if (human.resolve(literal.atom, &why_not)) continue;
    throw pddl::SemanticError(human.problem_source, {},
                              "the goal " + literal.text() + " has no meaning here: " + why_not);
  }
  return sorted(goal);
}

bool changes(const pddl::Model& model, const GroundName& atom) {
  const auto predicate = model.findPredicate(atom.name);
  return predicate && model.predicates[static_cast<std::size_t>(*predicate)].fluent;
}

std::vector<Candidate> candidatesOf(const Problem& problem, const Limits& limits) {
  std::vector<Candidate> candidates;
  LimitMonitor monitor(limits);
  for (const pddl::Atom& atom : problem.expectation.finalState()) {
    if (const LimitReason limit = monitor.poll(); limit != LimitReason::None)
      throw LimitReached(limit, "finding what the person expects");
    const Literal fluent = {problem.human.name(atom), false};
    if (std::binary_search(problem.specified.begin(), problem.specified.end(), fluent)) continue;
    const bool is_static =
        !changes(problem.human, fluent.atom) && !changes(problem.robot, fluent.atom);
    candidates.push_back({fluent, is_static});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.fluent < b.fluent; });
  return candidates;
}

}  // namespace

HumanPlanInvalid::HumanPlanInvalid(const validation::Violation& violation)
    : Exception("the human's plan does not run in the human's model: " + violation.message),
      step_(violation.step) {}

GoalNotExpected::GoalNotExpected(const std::vector<Literal>& missing, bool plan_is_empty)
    : Exception(plan_is_empty
                    ? "no plan given: I can't know what you expect; not so now: " + listed(missing)
                    : "the human's plan does not lead to the specified goal: at its end " +
                          listed(missing) + " is not so"),
      missing_(missing) {}

Problem makeProblem(pddl::Model robot, pddl::Model human, const std::vector<Literal>& goal,
                    std::vector<GroundName> human_plan, const Limits& limits) {
  Problem problem;
  problem.specified = specifiedGoal(robot, human, goal);
  problem.expectation = validation::execute(human, human_plan);
  if (problem.expectation.violation) throw HumanPlanInvalid(*problem.expectation.violation);
  const std::vector<Literal> missing =
      validation::unsatisfied(human, problem.expectation.finalState(), problem.specified);
  if (!missing.empty()) throw GoalNotExpected(missing, human_plan.empty());
  problem.robot = std::move(robot);
  problem.human = std::move(human);
  problem.human_plan = std::move(human_plan);
  problem.candidates = candidatesOf(problem, limits);
  return problem;
}

}  // namespace goal_alignment::alignment
