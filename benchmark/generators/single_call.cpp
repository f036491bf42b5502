// SPDX-License-Identifier: BSD-3-Clause
#include "single_call.h"

#include <optional>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/search/astar.h"
#include "goal_alignment/search/greedy.h"
#include "goal_alignment/search/successor_generator.h"
#include "goal_alignment/validation/execution.h"
#include "stopwatch.h"

namespace goal_alignment::benchmarks {
namespace {

// Nothing where grounding proves that one of the literals is never true.
std::optional<task::FactSet> factsOf(const grounding::GroundTask& ground,
                                     const std::vector<Literal>& goal) {
  using Kind = grounding::FactStatus::Kind;
  task::FactSet facts;
  for (const Literal& literal : goal) {
    const grounding::FactStatus status = ground.status(literal);
    if (status.kind == Kind::NeverTrue || status.kind == Kind::Unknown) return std::nullopt;
    if (status.kind == Kind::Variable) facts.push_back(status.fact);
  }
  return task::makeFactSet(std::move(facts));
}

void solve(const grounding::GroundTask& ground, const std::vector<Literal>& goal, CallKind kind,
           const Limits& limits, SingleCall& call) {
  call.result.status = search::Status::Unsolvable;
  const auto facts = factsOf(ground, goal);
  if (!facts) return;
  Stopwatch watch;
  const heuristics::MutexTable mutexes(ground.task, limits);
  const task::Task task = mutexes.withoutInapplicable(ground.task);
  const bool excluded = mutexes.contains(*facts);
  call.mutexes = watch.lap();
  if (excluded) return;
  if (kind == CallKind::Optimal) {
    call.result = search::astar(task, *facts, limits);
  } else {
    call.result = search::greedy(task, search::SuccessorGenerator(task), *facts, limits);
  }
  call.search = watch.lap();
  call.plan = task::names(task, call.result.plan);
}

}  // namespace

SingleCall singleCall(const pddl::Source& domain, const pddl::Source& problem, CallKind kind,
                      const Limits& limits) {
  SingleCall call;
  Stopwatch watch;
  const pddl::Model model = pddl::readModel(domain, problem, limits);
  call.parse = watch.lap();
  call.objects = model.objects.size();
  try {
    const std::vector<Literal> goal = model.goalLiterals();
    const bool unit_costs = kind == CallKind::First || !model.has_costs;
    const grounding::GroundTask ground = grounding::ground(model, goal, {unit_costs}, limits);
    call.ground = watch.lap();
    call.facts = ground.task.facts.size();
    call.operators = ground.task.operators.size();
    solve(ground, goal, kind, limits, call);
    if (call.result.status != search::Status::Solved) return call;
    if (const auto fault = validation::fault(model, call.plan, goal))
      throw Exception("the plan found did not pass validation: " + *fault);
  } catch (const LimitReached& reached) {
    call.result.status = search::Status::LimitReached;
    call.result.limit = reached.reason();
  }
  return call;
}

std::size_t operatorCount(const pddl::Source& domain, const pddl::Source& problem) {
  const pddl::Model model = pddl::readModel(domain, problem);
  return grounding::ground(model, model.goalLiterals(), {}, {}).task.operators.size();
}

}  // namespace goal_alignment::benchmarks
