// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/task/task.h"

namespace goal_alignment::heuristics {

/// Disjunctive action landmarks of a state with a share of the operators' costs each: every plan
/// from the state contains an operator of each, and the shares of one operator don't exceed its
/// cost. So the sum of the costs is a lower bound.
class Landmarks {
 public:
  struct Landmark {
    task::Cost cost;
    const task::OperatorId* first;
    const task::OperatorId* last;
    const task::OperatorId* begin() const { return first; }
    const task::OperatorId* end() const { return last; }
  };

  void clear() {
    operators_.clear();
    entries_.clear();
    total_ = 0;
  }
  void add(task::Cost cost, const task::OperatorId* first, const task::OperatorId* last) {
    operators_.insert(operators_.end(), first, last);
    entries_.push_back({cost, static_cast<std::uint32_t>(operators_.size())});
    total_ += cost;
  }

  std::size_t size() const { return entries_.size(); }
  Landmark operator[](std::size_t i) const {
    const std::uint32_t begin = i == 0 ? 0 : entries_[i - 1].end;
    return {entries_[i].cost, operators_.data() + begin, operators_.data() + entries_[i].end};
  }
  task::Cost total() const { return total_; }
  std::size_t bytes() const {
    return operators_.size() * sizeof(task::OperatorId) + entries_.size() * sizeof(Entry) +
           sizeof(*this);
  }

 private:
  struct Entry {
    task::Cost cost;
    std::uint32_t end;
  };

  std::vector<task::OperatorId> operators_;
  std::vector<Entry> entries_;
  task::Cost total_ = 0;
};

}  // namespace goal_alignment::heuristics
