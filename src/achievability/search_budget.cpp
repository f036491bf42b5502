// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/search_budget.h"

#include <algorithm>

namespace goal_alignment::achievability {

namespace {

/// The size of task up to which the budgets are meant literally.
constexpr std::uint64_t kOperators = 2'500;
/// However large the task is, a search gets so many states.
constexpr std::uint64_t kMinStates = 500;

}  // namespace

SearchBudget scaledTo(SearchBudget budget, std::size_t operators) {
  if (operators <= kOperators) return budget;
  for (std::uint64_t* states : {&budget.first_greedy, &budget.exhaustive, &budget.second_greedy,
                                &budget.shrinking, &budget.parts, &budget.minimising})
    *states = std::min(*states, std::max(*states * kOperators / operators, kMinStates));
  return budget;
}

bool isOwnBudget(LimitReason reason) {
  return reason == LimitReason::States || reason == LimitReason::Memory;
}

}  // namespace goal_alignment::achievability
