// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/exhaustive.h"

#include <vector>

namespace goal_alignment::search {

using task::OperatorId;

Exhaustive::Exhaustive(const SearchTask& task) : task_(task), space_(task) {}

LimitReason Exhaustive::run(const Limits& limits, const Visit& visit) {
  LimitMonitor monitor(limits);
  if (!visit(SearchSpace::kInitial, space_.state(SearchSpace::kInitial))) return LimitReason::None;
  std::vector<OperatorId> applicable;
  for (StateId id = 0; id < space_.size(); ++id) {
    applicable.clear();
    task_.successors().forEach(space_.state(id), [&](OperatorId op) { applicable.push_back(op); });
    LimitReason reason = LimitReason::None;
    const bool goes_on = space_.insertSuccessors(
        id, applicable, [&](StateId successor, bool is_new, OperatorId /*op*/) {
          reason = monitor.generated(space_.bytes());
          if (reason != LimitReason::None) return false;
          return !is_new || visit(successor, space_.state(successor));
        });
    if (!goes_on) return reason;
  }
  return LimitReason::None;
}

}  // namespace goal_alignment::search
