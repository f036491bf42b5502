// SPDX-License-Identifier: BSD-3-Clause
// What a policy takes for a decision, and how many questions more than the best it is expected to
// ask: on random families of conflicts, and on those of the instances in ../shared/benchmarks.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "generators/conflict_families.h"
#include "goal_alignment/questions/clairvoyant.h"
#include "goal_alignment/questions/grouping.h"

namespace goal_alignment::benchmarks {
namespace {

using questions::Situation;

std::unique_ptr<questions::Policy> policyOf(const std::string& name) {
  return questions::makePolicy(name, {});
}

/// The first decision of a dialogue: nothing is remembered yet. `longest_ms`: of any family.
void decision(benchmark::State& state, const std::string& policy, const std::string& family,
              double most_likely) {
  RandomSource random(1);
  double longest = 0;
  for ([[maybe_unused]] auto iteration : state) {
    const Situation situation = conflictFamily(family, 30, 200, 0.02, most_likely, random);
    const auto asking = policyOf(policy);
    const auto began = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(asking->next(situation));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    state.SetIterationTime(took.count());
    longest = std::max(longest, took.count());
  }
  state.counters["longest_ms"] = longest * 1e3;
}

/// `gap_percent`: mean over families of ten candidates; `worst_percent`: of any of them.
void gap(benchmark::State& state, const std::string& policy, const std::string& family,
         double most_likely) {
  constexpr int kFamilies = 20;
  double sum = 0;
  double worst = 0;
  for ([[maybe_unused]] auto iteration : state) {
    RandomSource random(1);
    for (int i = 0; i < kFamilies; ++i) {
      const Situation situation = conflictFamily(family, 10, 15, 0.02, most_likely, random);
      const double ratio = expectedQuestions(*policyOf(policy), situation) /
                           expectedQuestions(*policyOf("optimal"), situation);
      sum += ratio - 1;
      worst = std::max(worst, ratio - 1);
    }
  }
  state.counters["gap_percent"] = 100 * sum / kFamilies;
  state.counters["worst_percent"] = 100 * worst;
}

/// Beyond what can be computed: the mean over persons drawn by chance, against `ratio` asking the
/// same persons.
void against(benchmark::State& state, const std::string& family, double most_likely) {
  constexpr int kPersons = 20;
  std::map<std::string, double> asked;
  for ([[maybe_unused]] auto iteration : state) {
    for (const std::string policy : {"auto", "ratio"}) {
      RandomSource random(1);
      for (int i = 0; i < kPersons; ++i) {
        Situation situation = conflictFamily(family, 30, 60, 0.02, most_likely, random);
        const auto asking = policyOf(policy);
        std::vector<double> mood;
        for (std::size_t f = 0; f < situation.knowledge.size(); ++f)
          mood.push_back(random.unit());
        while (const auto choice = asking->next(situation)) {
          const std::size_t f = choice->candidate;
          situation.knowledge[f] = mood[f] < situation.probability[f]
                                       ? questions::Knowledge::Wanted
                                       : questions::Knowledge::NotWanted;
          ++asked[policy];
        }
      }
    }
  }
  state.counters["ratio_asks"] = asked["ratio"] / kPersons;
  state.counters["auto_asks"] = asked["auto"] / kPersons;
}

std::filesystem::path instances() {
  namespace fs = std::filesystem;
  if (const char* shared = std::getenv("GOAL_ALIGNMENT_SHARED")) {
    return fs::path(shared) / "benchmarks/hagl-ipc";
  }
  const fs::path root = GOAL_ALIGNMENT_SOURCE_ROOT;
  return (root / "../shared/benchmarks/hagl-ipc").lexically_normal();
}

Situation readConflicts(const std::filesystem::path& file, double probability) {
  const auto lists = nlohmann::json::parse(std::ifstream(file)).at("conflicts");
  std::map<std::string, std::size_t> index;
  for (const auto& list : lists) {
    for (const auto& fluent : list)
      index.emplace(fluent, index.size());
  }
  Situation situation;
  situation.knowledge.assign(index.size(), questions::Knowledge::Open);
  situation.probability.assign(index.size(), probability);
  for (const auto& list : lists) {
    achievability::Conflict conflict{achievability::CandidateSet(index.size()), true, true};
    for (const auto& fluent : list)
      conflict.members.set(index.at(fluent));
    situation.conflicts.push_back(std::move(conflict));
  }
  return situation;
}

/// What one person who wants nothing more (the likeliest) takes: `rounds` with groups of six.
std::size_t rounds(const std::string& policy, Situation situation) {
  const auto asking = policyOf(policy);
  for (std::size_t count = 0;; ++count) {
    const auto group = questions::nextGroup(*asking, situation, 6);
    if (group.empty()) return count;
    for (const questions::Choice& choice : group)
      situation.knowledge[choice.candidate] = questions::Knowledge::NotWanted;
  }
}

void published(benchmark::State& state, const std::string& policy, double probability) {
  if (!std::filesystem::is_directory(instances())) {
    state.SkipWithError("no instances in ../shared/benchmarks; set GOAL_ALIGNMENT_SHARED");
    return;
  }
  double sum = 0;
  double worst = 0;
  double count = 0;
  std::size_t most_rounds = 0;
  for ([[maybe_unused]] auto iteration : state) {
    for (const auto& folder : std::filesystem::directory_iterator(instances())) {
      const Situation situation = readConflicts(folder.path() / "conflicts.json", probability);
      if (situation.conflicts.empty()) continue;
      const double gap = expectedQuestions(*policyOf(policy), situation) /
                             expectedQuestions(*policyOf("optimal"), situation) -
                         1;
      sum += gap;
      worst = std::max(worst, gap);
      most_rounds = std::max(most_rounds, rounds(policy, situation));
      ++count;
    }
  }
  state.counters["instances"] = count;
  state.counters["gap_percent"] = 100 * sum / count;
  state.counters["worst_percent"] = 100 * worst;
  state.counters["rounds_of_six"] = static_cast<double>(most_rounds);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string name;
  for (const std::string& part : parts)
    name.append(name.empty() ? "" : "/").append(part);
  return name;
}

void registerAll() {
  const auto chance = [](double most) { return most < 0.5 ? "unlikely" : "any"; };
  for (const std::string policy : {"auto", "ratio", "optimal"}) {
    for (const double most : {0.22, 0.9}) {
      for (const std::string family : {"pairs", "triples"}) {
        benchmark::RegisterBenchmark(
            joined({"decision", policy, family, chance(most)}).c_str(),
            [=](benchmark::State& state) { decision(state, policy, family, most); })
            ->UseManualTime()
            ->Iterations(policy == "optimal" ? 2 : 10)
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
  for (const std::string policy : {"auto", "ratio"}) {
    for (const double most : {0.22, 0.9}) {
      for (const std::string& family : conflictFamilies()) {
        benchmark::RegisterBenchmark(
            joined({"gap", policy, family, chance(most)}).c_str(),
            [=](benchmark::State& state) { gap(state, policy, family, most); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
      }
      benchmark::RegisterBenchmark(
          joined({"gap", policy, "published", chance(most)}).c_str(),
          [=](benchmark::State& state) { published(state, policy, most / 2); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
  for (const double most : {0.22, 0.9}) {
    for (const std::string& family : conflictFamilies()) {
      benchmark::RegisterBenchmark(joined({"beyond", family, chance(most)}).c_str(),
                                   [=](benchmark::State& state) { against(state, family, most); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

const int kRegistered = (registerAll(), 0);

}  // namespace
}  // namespace goal_alignment::benchmarks
