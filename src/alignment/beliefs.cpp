// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/beliefs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/parallel.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/astar.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::alignment {

using grounding::FactStatus;
using task::Cost;

namespace {

constexpr double kMinBelief = 0.02;
constexpr double kMaxBelief = 0.98;

/// exp(−β·(Δ − least)): where `least` is the smallest difference of those that are summed up, large
/// differences don't vanish together.
std::vector<double> weights(const std::vector<double>& differences, double beta, double least) {
  std::vector<double> result(differences.size());
  std::transform(differences.begin(), differences.end(), result.begin(),
                 [=](double difference) { return std::exp(-beta * (difference - least)); });
  return result;
}

/// Costs of the prefixes of π^H, the empty one first.
std::vector<Cost> prefixCosts(const Problem& problem, bool unit_costs) {
  std::vector<Cost> costs;
  for (std::size_t i = 0; i < problem.expectation.costs.size(); ++i) {
    costs.push_back(unit_costs ? static_cast<Cost>(i) : problem.expectation.costs[i]);
  }
  return costs;
}

/// When prefixes of π^H achieve G^H, alone and together with each candidate, at the earliest.
struct CheapestPrefixes {
  Cost specified = 0;
  std::vector<Cost> with;  // by candidate
};

/// π^H itself achieves every candidate, so there always is one.
CheapestPrefixes cheapestPrefixes(const Problem& problem, const std::vector<Cost>& prefix_costs,
                                  const Limits& limits) {
  std::optional<Cost> alone;
  std::vector<std::optional<Cost>> first(problem.candidates.size());
  problem.expectation.forEachState([&](std::size_t step, const validation::AtomSet& state) {
    if (!validation::unsatisfied(problem.human, state, problem.specified).empty()) return;
    if (!validation::satisfiesCondition(problem.human, state, limits)) return;
    if (!alone) alone = prefix_costs[step];
    for (std::size_t c = 0; c < first.size(); ++c) {
      if (first[c]) continue;
      const std::vector<Literal> fluent = {problem.candidates[c].fluent};
      if (validation::unsatisfied(problem.human, state, fluent).empty()) {
        first[c] = prefix_costs[step];
      }
    }
  });
  CheapestPrefixes costs;
  costs.specified = alone.value();
  for (const auto& cost : first)
    costs.with.push_back(cost.value());
  return costs;
}

/// Searches for less would find little, and setting them up takes as long: the bounds do as well.
constexpr std::uint64_t kMinStates = 200;
/// The relaxed operators that all evaluations of LM-cut may look at together: about a second.
constexpr std::uint64_t kEvaluationWork = 200'000'000;

/// The optimal costs of G^H and one fact more in the human model. All searches share the bounds:
/// none costs less than G^H alone, none more than the cheapest prefix of π^H, or of any plan found,
/// that achieves it.
class HumanCosts {
 public:
  HumanCosts(const Problem& problem, const CostOptions& options, const Limits& limits)
      : problem_(problem),
        threads_(options.threads),
        prefix_costs_(prefixCosts(problem, options.unit_costs)),
        prefixes_(cheapestPrefixes(problem, prefix_costs_, limits)),
        human_(grounding::ground(problem.human, literals(problem), {options.unit_costs}, limits)),
        task_(human_.task, heuristics::groupsFromInvariants(human_.task, limits)),
        search_limits_(limits) {
    goal_ = human_.goal(problem.specified);
    collectQueries();
    const std::uint64_t size = std::max<std::size_t>(1, human_.task.operators.size());
    std::uint64_t states = options.states_per_search;
    if (options.bounds_may_do) {
      states = std::min(states, kEvaluationWork / (size * queries_.size()));
      if (states < kMinStates) states = 0;
    }
    search_limits_ = limits.withStates(states).withSeconds(options.search_seconds);
  }

  CostDifferences run() {
    CostDifferences result;
    if (search_limits_.states > 0) {
      searchBatch({0}, result);
      for (Query& query : queries_)
        query.lower = std::max(query.lower, queries_[0].lower);
      for (std::size_t next = 1; next < queries_.size() && timeIsLeft();)
        searchBatch(nextBatch(next), result);
    }
    for (const Query& query : queries_)
      result.exact = result.exact && query.lower >= query.upper;
    for (const std::size_t query : query_of_) {
      const Cost difference = prefix_costs_.back() - queries_[query].upper;
      result.values.push_back(std::abs(static_cast<double>(difference)));
    }
    return result;
  }

 private:
  /// One goal to cost; what is sought lies between the bounds.
  struct Query {
    std::optional<task::FactId> fact;  // nothing: G^H alone
    Cost lower;
    Cost upper;
  };

  /// Candidates that never change share the query for G^H alone, which comes first.
  void collectQueries() {
    queries_.push_back({std::nullopt, 0, prefixes_.specified});
    std::map<task::FactId, std::size_t> known;
    for (std::size_t c = 0; c < problem_.candidates.size(); ++c) {
      const FactStatus status = human_.status(problem_.candidates[c].fluent);
      if (status.kind != FactStatus::Kind::Variable) {
        query_of_.push_back(0);
        continue;
      }
      const auto [query, is_new] = known.emplace(status.fact, queries_.size());
      query_of_.push_back(query->second);
      if (is_new) queries_.push_back({status.fact, 0, prefixes_.with[c]});
    }
  }

  bool timeIsLeft() const { return Limits::Clock::now() < search_limits_.deadline; }

  /// The next few queries that the bounds leave open.
  std::vector<std::size_t> nextBatch(std::size_t& next) const {
    std::vector<std::size_t> batch;
    for (; next < queries_.size() && batch.size() < kBatch; ++next) {
      if (queries_[next].lower < queries_[next].upper) batch.push_back(next);
    }
    return batch;
  }

  void searchBatch(const std::vector<std::size_t>& batch, CostDifferences& progress) {
    std::vector<search::Result> results(batch.size());
    inParallel(batch.size(), threads_, [&](std::size_t i) {
      const Query& query = queries_[batch[i]];
      const task::FactSet more = query.fact ? task::FactSet{*query.fact} : task::FactSet{};
      results[i] = search::astar(task_, task::withFacts(goal_, more), search_limits_,
                                 {query.lower, query.upper});
    });
    for (std::size_t i = 0; i < batch.size(); ++i)
      settle(queries_[batch[i]], results[i], progress);
  }

  void settle(Query& query, const search::Result& result, CostDifferences& progress) {
    ++progress.planner_calls;
    if (result.limit == LimitReason::Cancelled) throw LimitReached(result.limit, "the beliefs");
    if (result.status == search::Status::LimitReached) return;
    if (result.status == search::Status::Solved) {
      query.upper = result.cost;
      learnFrom(result.plan);
    }
    query.lower = query.upper;
  }

  /// Every state of a plan that satisfies G^H bounds the costs of all that is true there.
  void learnFrom(const task::Plan& plan) {
    task::State state = task::initialState(human_.task);
    Cost cost = 0;
    for (std::size_t step = 0;; ++step) {
      if (task::satisfies(state.data(), goal_)) {
        for (Query& query : queries_) {
          if (!query.fact || task::testBit(state.data(), *query.fact))
            query.upper = std::min(query.upper, cost);
        }
      }
      if (step == plan.size()) break;
      const task::Operator& op = human_.task.operators[plan[step]];
      const task::State before = state;
      task::apply(op, before.data(), state.size(), state.data());
      cost += op.cost;
    }
  }

  const Problem& problem_;
  int threads_;
  std::vector<Cost> prefix_costs_;
  CheapestPrefixes prefixes_;
  grounding::GroundTask human_;
  search::SearchTask task_;
  Limits search_limits_;
  task::Goal goal_;
  std::vector<Query> queries_;
  std::vector<std::size_t> query_of_;  // by candidate
};

}  // namespace

CostDifferences costDifferences(const Problem& problem, const CostOptions& options,
                                const Limits& limits) {
  return HumanCosts(problem, options, limits).run();
}

std::vector<double> beliefs(const Problem& problem, const std::vector<double>& differences,
                            const BeliefOptions& options) {
  std::vector<double> result(differences.size(), options.flat);
  if (options.mode == BeliefMode::Normalised) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < differences.size(); ++i) {
      if (!problem.candidates[i].is_static) least = std::min(least, differences[i]);
    }
    // With static candidates alone there is nothing to share the expectation among.
    if (std::isinf(least)) return std::vector<double>(differences.size(), kMinBelief);
    result = weights(differences, options.beta, least);
    double sum = 0;
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (!problem.candidates[i].is_static) sum += result[i];
    }
    for (double& belief : result)
      belief *= options.kappa / sum;
  } else if (options.mode == BeliefMode::Raw) {
    std::transform(differences.begin(), differences.end(), result.begin(),
                   [&](double difference) { return std::exp(-options.beta * difference); });
  }
  for (double& belief : result)
    belief = std::clamp(belief, kMinBelief, kMaxBelief);
  return result;
}

std::vector<double> paperBeliefs(const std::vector<double>& differences, double beta) {
  if (differences.empty()) return {};
  const double least = *std::min_element(differences.begin(), differences.end());
  std::vector<double> result = weights(differences, beta, least);
  double sum = 0;
  for (const double weight : result)
    sum += weight;
  for (double& belief : result)
    belief /= sum;
  return result;
}

}  // namespace goal_alignment::alignment
