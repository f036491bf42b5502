// SPDX-License-Identifier: BSD-3-Clause
#include "fluents.h"

#include "goal_alignment/common/listed.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using alignment::Problem;

std::vector<Literal> fluentsOf(const Problem& problem, const CandidateSet& candidates) {
  std::vector<Literal> result;
  for (const std::size_t f : achievability::members(candidates))
    result.push_back(problem.candidates[f].fluent);
  return result;
}

std::vector<Literal> specifiedAnd(const Problem& problem, const CandidateSet& candidates) {
  std::vector<Literal> result = problem.specified;
  const std::vector<Literal> more = fluentsOf(problem, candidates);
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

std::string spelling(const Problem& problem, const GroundName& ground) {
  const bool robot_knows =
      problem.robot.findPredicate(ground.name) || problem.robot.findSchema(ground.name);
  return (robot_knows ? problem.robot : problem.human).spelling(ground);
}

std::string listed(const Problem& problem, const std::vector<Literal>& literals) {
  return goal_alignment::listed(literals, [&](const Literal& literal) {
    const std::string atom = spelling(problem, literal.atom);
    return literal.negated ? "(not " + atom + ")" : atom;
  });
}

std::string askedFor(const Problem& problem) {
  const std::string literals = listed(problem, problem.specified);
  return literals + (literals.empty() || problem.condition.empty() ? "" : ", ") + problem.condition;
}

std::vector<std::string> parameterNames(const Problem& problem, const std::string& action) {
  std::vector<std::string> names;
  const auto schema = problem.robot.findSchema(action);
  if (!schema) return names;
  for (const pddl::Parameter& parameter :
       problem.robot.schemas[static_cast<std::size_t>(*schema)].parameters) {
    names.push_back(parameter.name);
  }
  return names;
}

}  // namespace goal_alignment::session
