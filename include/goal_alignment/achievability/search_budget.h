// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "goal_alignment/common/limits.h"

namespace goal_alignment::achievability {

/// How much work each kind of search may do. Unless said otherwise the unit is a generated state.
struct SearchBudget {
  std::uint64_t first_greedy = 20'000;     ///< before the reachable states are swept
  std::uint64_t first_symbolic = 300'000;  ///< steps on a decision diagram that stays small
  std::uint64_t exhaustive = 1'000'000;    ///< the reachable states one by one
  std::uint64_t symbolic = 50'000'000;     ///< steps on a diagram where there are more states
  std::uint64_t second_greedy = 200'000;   ///< where no sweep came to its end
  int threads = 1;  ///< for searches that don't depend on each other; the answers are the same
  std::uint64_t shrinking = 5'000;  ///< per attempt to leave something out of an undecided set
  std::uint64_t parts = 100'000;    ///< on parts of the task, to prove that such a set has no plan
  std::uint64_t open_sets = 5'000;  ///< how many sets one findAllConflicts() looks at
  std::uint64_t minimising = 20'000;  ///< per conflict, to prove that it has superfluous members
};

/// The budget for a task of so many operators: in large tasks a state takes longer, so there are
/// fewer of them. Steps on diagrams and the number of sets stay as they are.
SearchBudget scaledTo(SearchBudget budget, std::size_t operators);

/// Whether our own budget ended the work, rather than a person or the clock. More of it would help.
bool isOwnBudget(LimitReason reason);

}  // namespace goal_alignment::achievability
