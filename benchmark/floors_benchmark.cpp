// SPDX-License-Identifier: BSD-3-Clause
// One benchmark a floor of the core, each on the family whose number of things is the argument.
#include <benchmark/benchmark.h>

#include <vector>

#include "generators/alignment_instance.h"
#include "goal_alignment/alignment/beliefs.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/ff.h"
#include "goal_alignment/heuristics/lm_cut.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/search/state_registry.h"
#include "goal_alignment/search/successor_generator.h"

namespace goal_alignment::benchmarks {
namespace {

constexpr std::uint64_t kSeed = 1;

/// A household, grounded, with states met on a random walk.
struct Home {
  pddl::Model model;
  grounding::GroundTask ground;
  task::FactSet goal;

  explicit Home(const Models& models)
      : model(pddl::readModel({"domain", models.domain.text()}, {"problem", models.problemText()})),
        ground(grounding::ground(model, model.goalLiterals(), {}, {})) {
    for (const Literal& literal : model.goalLiterals())
      goal.push_back(ground.status(literal).fact);
    goal = task::makeFactSet(std::move(goal));
  }
};

Models modelsOf(const benchmark::State& state) {
  RandomSource random(kSeed);
  return household(static_cast<int>(state.range(0)), random);
}

std::vector<task::State> randomWalk(const task::Task& task, std::size_t length) {
  const search::SuccessorGenerator successors(task);
  RandomSource random(kSeed);
  std::vector<task::State> states = {task::initialState(task)};
  while (states.size() < length) {
    const task::State& last = states.back();
    std::vector<task::OperatorId> applicable;
    successors.forEach(last.data(), [&](task::OperatorId op) { applicable.push_back(op); });
    task::State next(last.size());
    task::apply(task.operators[applicable[random.below(applicable.size())]], last.data(),
                last.size(), next.data());
    states.push_back(std::move(next));
  }
  return states;
}

void parse(benchmark::State& state) {
  const Models models = modelsOf(state);
  const pddl::Source domain = {"domain", models.domain.text()};
  const pddl::Source problem = {"problem", models.problemText()};
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(pddl::readModel(domain, problem));
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(domain.text.size() + problem.text.size()));
}

void ground(benchmark::State& state) {
  const Home home(modelsOf(state));
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(grounding::ground(home.model, home.model.goalLiterals(), {}, {}));
  state.counters["operators"] = static_cast<double>(home.ground.task.operators.size());
}

void mutexTable(benchmark::State& state) {
  const Home home(modelsOf(state));
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(heuristics::MutexTable(home.ground.task, {}));
  state.counters["facts"] = static_cast<double>(home.ground.task.facts.size());
}

template <typename Heuristic>
void evaluate(benchmark::State& state) {
  const Home home(modelsOf(state));
  const auto walk = randomWalk(home.ground.task, 64);
  Heuristic heuristic(home.ground.task, home.goal);
  std::size_t i = 0;
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(heuristic.evaluate(walk[i++ % walk.size()].data()));
  state.SetItemsProcessed(state.iterations());
}

void successorGenerator(benchmark::State& state) {
  const Home home(modelsOf(state));
  const search::SuccessorGenerator successors(home.ground.task);
  const auto walk = randomWalk(home.ground.task, 64);
  std::size_t i = 0;
  for ([[maybe_unused]] auto iteration : state) {
    std::size_t found = 0;
    successors.forEach(walk[i++ % walk.size()].data(), [&](task::OperatorId) { ++found; });
    benchmark::DoNotOptimize(found);
  }
  state.SetItemsProcessed(state.iterations());
}

void stateRegistry(benchmark::State& state) {
  const Home home(modelsOf(state));
  const auto walk = randomWalk(home.ground.task, 4096);
  for ([[maybe_unused]] auto iteration : state) {
    search::StateRegistry registry(walk.front().size());
    for (const task::State& each : walk)
      registry.insert(each.data());
    benchmark::DoNotOptimize(registry.size());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(walk.size()));
}

void beliefs(benchmark::State& state) {
  RandomSource random(kSeed);
  const Models robot = household(static_cast<int>(state.range(0)), random);
  const session::Input input = alignmentOf(robot, {}, {}, random).input();
  const alignment::Problem problem = alignment::makeProblem(
      pddl::readModel(input.robot_domain, input.robot_problem),
      pddl::readModel(input.human_domain, input.human_problem), {}, input.human_plan);
  alignment::CostOptions options;
  options.states_per_search = 10'000;
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(alignment::costDifferences(problem, options, {}));
  state.counters["candidates"] = static_cast<double>(problem.candidates.size());
}

BENCHMARK(parse)->RangeMultiplier(4)->Range(8, 128)->Unit(benchmark::kMicrosecond);
BENCHMARK(ground)->RangeMultiplier(4)->Range(8, 128)->Unit(benchmark::kMicrosecond);
BENCHMARK(mutexTable)->RangeMultiplier(4)->Range(8, 128)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(evaluate, heuristics::Ff)
    ->RangeMultiplier(4)
    ->Range(8, 128)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(evaluate, heuristics::LmCut)
    ->RangeMultiplier(4)
    ->Range(8, 128)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(successorGenerator)->RangeMultiplier(4)->Range(8, 128)->Unit(benchmark::kMicrosecond);
BENCHMARK(stateRegistry)->RangeMultiplier(4)->Range(8, 128)->Unit(benchmark::kMicrosecond);
BENCHMARK(beliefs)->RangeMultiplier(2)->Range(8, 16)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace goal_alignment::benchmarks
