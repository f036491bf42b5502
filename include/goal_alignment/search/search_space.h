// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "goal_alignment/search/search_task.h"
#include "goal_alignment/search/state_registry.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// The states a search has met, packed, and the way to each.
class SearchSpace {
 public:
  /// The task must outlive this.
  explicit SearchSpace(const SearchTask& task);

  /// The initial state's id is 0; it is there from the start.
  static constexpr StateId kInitial = 0;

  /// Applies the operator in state `from`. New states are reached through it; known ones keep their
  /// way.
  std::pair<StateId, bool> insertSuccessor(StateId from, task::OperatorId op);

  /// insertSuccessor() for each operator, in order, with visit(id, is_new, operator); false from
  /// visit ends it. Faster than one by one: the table's cache misses overlap.
  template <typename Visit>
  bool insertSuccessors(StateId from, const std::vector<task::OperatorId>& operators,
                        Visit&& visit) {
    const std::size_t words = registry_.words();
    batch_.resize(operators.size() * words);
    hashes_.resize(operators.size());
    for (std::size_t i = 0; i < operators.size(); ++i) {
      task::Word* successor = batch_.data() + i * words;
      task_.packing().apply(operators[i], registry_[from], successor);
      hashes_[i] = registry_.hash(successor);
      registry_.prefetch(hashes_[i]);
    }
    for (std::size_t i = 0; i < operators.size(); ++i) {
      const auto [id, is_new] = registry_.insert(batch_.data() + i * words, hashes_[i]);
      if (is_new) ways_.push_back({from, operators[i]});
      if (!visit(id, is_new, operators[i])) return false;
    }
    return true;
  }

  /// How a state was reached; the initial one from kNoState.
  struct Way {
    StateId parent;
    task::OperatorId op;
  };
  Way way(StateId id) const { return ways_[id]; }

  /// The way to the state becomes this one.
  void setWay(StateId id, StateId parent, task::OperatorId op) { ways_[id] = {parent, op}; }

  /// The state's facts, until this is called again. O(mutex groups).
  const task::Word* state(StateId id) {
    task_.packing().unpack(registry_[id], facts_.data());
    return facts_.data();
  }
  /// The state as it is written down, for good.
  const task::Word* packed(StateId id) const { return registry_[id]; }

  std::size_t size() const { return registry_.size(); }
  std::size_t bytes() const { return registry_.bytes() + ways_.capacity() * sizeof(Way); }

  /// The operators from the initial state to this one.
  task::Plan plan(StateId id) const;

 private:
  const SearchTask& task_;
  StateRegistry registry_;
  std::vector<Way> ways_;
  task::State facts_;
  std::vector<task::Word> successor_;
  std::vector<task::Word> batch_;
  std::vector<StateRegistry::Hash> hashes_;
};

}  // namespace goal_alignment::search
