// SPDX-License-Identifier: BSD-3-Clause
#include "planner.h"

#include "goal_alignment/common/parallel.h"
#include "goal_alignment/search/astar.h"
#include "goal_alignment/search/greedy.h"
#include "partial_search.h"

namespace goal_alignment::achievability {

search::Result Planner::greedy(const task::Goal& goal, const Limits& limits) {
  ++calls_;
  return search::greedy(task_.searchTask(), goal, limits);
}

std::vector<search::Result> Planner::greedyForEach(const std::vector<task::Goal>& goals,
                                                   const Limits& limits) {
  std::vector<search::Result> results(goals.size());
  inParallel(goals.size(), threads_, [&](std::size_t i) {
    results[i] = search::greedy(task_.searchTask(), goals[i], limits);
  });
  calls_ += goals.size();
  return results;
}

search::Result Planner::inParts(const CandidateSet& set, const Limits& limits) {
  ++calls_;
  return searchInParts(task_.searchTask(), task_.mutexes(), task_.goalWith(set), task_.factsOf(set),
                       limits);
}

search::Result Planner::optimal(const CandidateSet& set, const Limits& limits) {
  ++calls_;
  return search::astar(task_.searchTask(), task_.goalWith(set), limits);
}

search::Improved Planner::improve(const CandidateSet& set, const task::Plan& plan,
                                  const Limits& limits) {
  ++calls_;
  return search::improve(task_.searchTask(), task_.goalWith(set), plan, limits);
}

}  // namespace goal_alignment::achievability
