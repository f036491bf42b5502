// SPDX-License-Identifier: BSD-3-Clause
#include "ask_all_policy.h"

#include "live_conflict.h"

namespace goal_alignment::questions {

std::optional<Choice> AskAllPolicy::next(const Situation& situation) {
  for (std::size_t f = 0; f < situation.knowledge.size(); ++f) {
    if (situation.knowledge[f] != Knowledge::Open) continue;
    if (context_.is_static[f] && !context_.ask_static) continue;
    return Choice{f, smallestLiveConflict(situation, f)};
  }
  return std::nullopt;
}

}  // namespace goal_alignment::questions
