// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/beliefs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/search/astar.h"

namespace goal_alignment::alignment {

using grounding::FactStatus;
using task::Cost;

namespace {

constexpr double kLeastBelief = 0.02;
constexpr double kMostBelief = 0.98;

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

/// For each candidate the cost of the cheapest prefix of π^H that achieves it together with G^H.
/// π^H itself achieves every candidate, so there always is one.
std::vector<Cost> cheapestPrefixes(const Problem& problem, const std::vector<Cost>& prefix_costs,
                                   const Limits& limits) {
  std::vector<std::optional<Cost>> first(problem.candidates.size());
  problem.expectation.forEachState([&](std::size_t step, const validation::AtomSet& state) {
    if (!validation::unsatisfied(problem.human, state, problem.specified).empty()) return;
    if (!validation::satisfiesCondition(problem.human, state, limits)) return;
    for (std::size_t c = 0; c < first.size(); ++c) {
      if (first[c]) continue;
      const std::vector<Literal> fluent = {problem.candidates[c].fluent};
      if (validation::unsatisfied(problem.human, state, fluent).empty()) {
        first[c] = prefix_costs[step];
      }
    }
  });
  std::vector<Cost> costs(first.size());
  std::transform(first.begin(), first.end(), costs.begin(), [](auto cost) { return cost.value(); });
  return costs;
}

/// The optimal costs of G^H and one fact more in the human model, each fact searched for once.
class HumanCosts {
 public:
  HumanCosts(const Problem& problem, bool unit_costs, const Limits& limits, std::uint64_t states)
      : problem_(problem),
        prefix_costs_(prefixCosts(problem, unit_costs)),
        cheapest_prefixes_(cheapestPrefixes(problem, prefix_costs_, limits)),
        human_(grounding::ground(problem.human, problem.specified, {unit_costs}, limits)),
        successors_(human_.task),
        search_limits_(limits.withStates(states)) {
    for (const Literal& literal : problem.specified) {
      const FactStatus status = human_.status(literal);
      if (status.kind == FactStatus::Kind::Variable) goal_.push_back(status.fact);
    }
  }

  Cost humanPlanCost() const { return prefix_costs_.back(); }

  Cost optimal(std::size_t candidate, CostDifferences& progress) {
    const FactStatus status = human_.status(problem_.candidates[candidate].fluent);
    std::optional<task::FactId> key;
    if (status.kind == FactStatus::Kind::Variable) key = status.fact;
    if (const auto known = costs_.find(key); known != costs_.end()) return known->second;
    const Cost cost = search(cheapest_prefixes_[candidate], key, progress);
    costs_.emplace(key, cost);
    return cost;
  }

 private:
  Cost search(Cost bound, std::optional<task::FactId> fact, CostDifferences& progress) {
    task::FactSet goal = goal_;
    if (fact) goal.push_back(*fact);
    goal = task::makeFactSet(std::move(goal));
    ++progress.planner_calls;
    const search::Result result =
        search::astar(human_.task, successors_, goal, search_limits_, bound);
    if (result.limit == LimitReason::Cancelled) throw LimitReached(result.limit, "the beliefs");
    if (result.status == search::Status::LimitReached) progress.exact = false;
    return result.status == search::Status::Solved ? result.cost : bound;
  }

  const Problem& problem_;
  std::vector<Cost> prefix_costs_;
  std::vector<Cost> cheapest_prefixes_;  // by candidate
  grounding::GroundTask human_;
  search::SuccessorGenerator successors_;
  Limits search_limits_;
  task::FactSet goal_;
  std::map<std::optional<task::FactId>, Cost> costs_;  // nothing: G^H alone
};

}  // namespace

CostDifferences costDifferences(const Problem& problem, bool unit_costs, const Limits& limits,
                                std::uint64_t states_per_search) {
  HumanCosts costs(problem, unit_costs, limits, states_per_search);
  CostDifferences result;
  result.values.reserve(problem.candidates.size());
  for (std::size_t c = 0; c < problem.candidates.size(); ++c) {
    const Cost difference = costs.humanPlanCost() - costs.optimal(c, result);
    result.values.push_back(std::abs(static_cast<double>(difference)));
  }
  return result;
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
    if (std::isinf(least)) return std::vector<double>(differences.size(), kLeastBelief);
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
    belief = std::clamp(belief, kLeastBelief, kMostBelief);
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
