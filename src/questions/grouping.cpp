// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/grouping.h"

namespace goal_alignment::questions {

std::vector<Choice> nextGroup(Policy& policy, const Situation& situation, std::size_t most) {
  std::vector<Choice> group;
  Situation then = situation;
  while (group.size() < most) {
    const auto choice = policy.next(then);
    if (!choice) break;
    // A NO is likelier, and settles more.
    then.knowledge[choice->candidate] = Knowledge::NotWanted;
    group.push_back(*choice);
  }
  return group;
}

}  // namespace goal_alignment::questions
