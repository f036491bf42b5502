// SPDX-License-Identifier: BSD-3-Clause
#include "candidates_alone.h"

#include "goal_alignment/common/parallel.h"

namespace goal_alignment::achievability {

using task::FactSet;

std::optional<Verdict> CandidatesAlone::recall(std::size_t candidate) const {
  if (const auto known = knowledge_.recallAlone(candidate)) return known;
  if (reachable_.enumerated()) return Verdict::Unachievable;
  if (!reachable_.haveDiagram()) return std::nullopt;
  // It is neither always nor never true, so it has a fact.
  const bool holds_somewhere = reachable_.satisfy(FactSet{*task_.factOf(candidate)});
  return holds_somewhere ? Verdict::Achievable : Verdict::Unachievable;
}

std::vector<Check> CandidatesAlone::checkAll(const Limits& limits) {
  std::vector<Check> checks(task_.candidateCount());
  for (std::size_t next = 0; next < checks.size();) {
    std::vector<std::size_t> batch;
    std::vector<task::Goal> goals;
    for (; next < checks.size() && batch.size() < kBatch; ++next) {
      if (const auto known = recall(next)) {
        checks[next].verdict = *known;
      } else {
        batch.push_back(next);
        goals.emplace_back(FactSet{*task_.factOf(next)});
      }
    }
    const auto results = planner_.greedyForEach(goals, limits.withStates(budget_.second_greedy));
    for (std::size_t i = 0; i < batch.size(); ++i)
      checks[batch[i]] = learnFrom(batch[i], results[i]);
  }
  return checks;
}

Check CandidatesAlone::learnFrom(std::size_t candidate, const search::Result& result) {
  if (result.status == search::Status::Solved) {
    knowledge_.learnPlan(result.plan);
    return {Verdict::Achievable, {}, {}};
  }
  if (result.status == search::Status::LimitReached) return {Verdict::Unknown, {}, result.limit};
  knowledge_.learnNeverTrue(candidate);
  return {Verdict::Unachievable, {}, {}};
}

}  // namespace goal_alignment::achievability
