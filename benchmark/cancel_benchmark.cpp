// SPDX-License-Identifier: BSD-3-Clause
// How long a session goes on working after a cancel, in each phase. What counts is the worst case,
// `longest_ms`; the interface promises 100 ms.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <thread>

#include "generators/dialogue_tasks.h"
#include "goal_alignment/common/random_source.h"

namespace goal_alignment::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
using session::Session;

session::Options optionsOf(bool optimal_plan) {
  session::Options options;
  if (optimal_plan) options.plan = session::PlanMode::Optimal;
  return options;
}

void cancelAnywhere(benchmark::State& state, const session::Input& input, bool optimal_plan,
                    double span) {
  RandomSource random(1);
  double longest = 0;
  double finished = 0;
  for ([[maybe_unused]] auto iteration : state) {
    Session session(optionsOf(optimal_plan));
    session.begin(input);
    auto solver = std::async(std::launch::async, [&session] {
      while (session.step() == session::State::Analysing) {
      }
      return Clock::now();
    });
    std::this_thread::sleep_for(Seconds(span * random.unit()));
    const Clock::time_point cancelled = Clock::now();
    session.cancel();
    const Seconds took = solver.get() - cancelled;
    if (session.outcome().code != session::OutcomeCode::Canceled) ++finished;
    state.SetIterationTime(std::max(took.count(), 1e-9));
    longest = std::max(longest, took.count());
  }
  state.counters["longest_ms"] = longest * 1e3;
  state.counters["too_late"] = finished;  // the work was done before the cancel: no measurement
}

// Each spread over so many seconds from the beginning that most fall into the phase named.
BENCHMARK_CAPTURE(cancelAnywhere, reading, longText(200'000), false, 0.6)
    ->UseManualTime()
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cancelAnywhere, grounding, wideAction(32), false, 1.5)
    ->UseManualTime()
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cancelAnywhere, operators, wideAction(10), false, 2.0)
    ->UseManualTime()
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cancelAnywhere, analysing, swappedTiles(5), false, 3.0)
    ->UseManualTime()
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cancelAnywhere, planning, carriedBalls(24), true, 3.0)
    ->UseManualTime()
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace goal_alignment::benchmarks

BENCHMARK_MAIN();
