// SPDX-License-Identifier: BSD-3-Clause
#include "single_call.h"

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/stopwatch.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/search/solve.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::benchmarks {

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
    const auto seek = kind == CallKind::Optimal ? search::Seek::OptimalPlan : search::Seek::AnyPlan;
    call.result = search::solve(ground.task, ground.goal(goal), seek, limits);
    call.mutexes = call.result.statistics.preparing;
    call.search = watch.lap() - call.mutexes;
    call.plan = task::names(ground.task, call.result.plan);
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
