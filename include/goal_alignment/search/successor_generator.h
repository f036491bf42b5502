// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/state.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// Finds the operators that a state can apply: a trie over the operators' preconditions, rarest
/// fact first, entered only through facts that are true.
class SuccessorGenerator {
 public:
  /// Throws LimitReached.
  explicit SuccessorGenerator(const task::Task& task, const Limits& limits = {});

  /// Calls visit(OperatorId) for every applicable operator, in an order that depends on the task
  /// alone. O(true facts + trie nodes entered).
  template <typename Visit>
  void forEach(const task::Word* state, Visit&& visit) const {
    descend(0, state, visit);
    task::forEachBit(state, words_, [&](std::size_t fact) {
      if (first_[fact] != 0) descend(first_[fact], state, visit);
    });
  }

 private:
  struct Node {
    std::uint32_t operators_begin = 0;
    std::uint32_t operators_end = 0;
    std::uint32_t children_begin = 0;
    std::uint32_t children_end = 0;
  };
  struct Child {
    task::FactId fact;
    std::uint32_t node;
  };
  struct Ranked;
  struct Entry;

  std::uint32_t build(std::vector<Entry>::iterator begin, std::vector<Entry>::iterator end,
                      std::size_t depth);

  template <typename Visit>
  void descend(std::uint32_t index, const task::Word* state, Visit&& visit) const {
    const Node& node = nodes_[index];
    for (std::uint32_t i = node.operators_begin; i < node.operators_end; ++i)
      visit(operators_[i]);
    if (index == 0) return;  // the root's children are entered through first_
    for (std::uint32_t i = node.children_begin; i < node.children_end; ++i) {
      if (task::testBit(state, children_[i].fact)) descend(children_[i].node, state, visit);
    }
  }

  std::size_t words_;
  std::vector<std::uint32_t> first_;  // fact → the root's child, 0: none
  std::vector<Node> nodes_;
  std::vector<Child> children_;
  std::vector<task::OperatorId> operators_;
};

}  // namespace goal_alignment::search
