// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/successor_generator.h"

#include <algorithm>
#include <utility>

namespace goal_alignment::search {

using task::FactId;
using task::OperatorId;

/// An operator with its precondition in the order of the trie.
struct SuccessorGenerator::Entry {
  std::vector<std::pair<std::uint32_t, FactId>> key;  // (rank, fact)
  OperatorId op;
};

SuccessorGenerator::SuccessorGenerator(const task::Task& task)
    : words_(task::wordsFor(task.facts.size())), first_(task.facts.size(), 0) {
  std::vector<std::uint32_t> uses(task.facts.size(), 0);
  for (const task::Operator& op : task.operators) {
    for (const FactId fact : op.precondition)
      ++uses[fact];
  }
  std::vector<Entry> entries(task.operators.size());
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    entries[op].op = op;
    for (const FactId fact : task.operators[op].precondition) {
      entries[op].key.emplace_back(uses[fact], fact);
    }
    std::sort(entries[op].key.begin(), entries[op].key.end());
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.key < b.key; });
  build(entries.begin(), entries.end(), 0);
  for (std::uint32_t i = nodes_[0].children_begin; i < nodes_[0].children_end; ++i) {
    first_[children_[i].fact] = children_[i].node;
  }
}

std::uint32_t SuccessorGenerator::build(std::vector<Entry>::iterator begin,
                                        std::vector<Entry>::iterator end, std::size_t depth) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.operators_begin = static_cast<std::uint32_t>(operators_.size());
  for (; begin != end && begin->key.size() == depth; ++begin)
    operators_.push_back(begin->op);
  node.operators_end = static_cast<std::uint32_t>(operators_.size());
  std::vector<Child> children;
  while (begin != end) {
    const FactId fact = begin->key[depth].second;
    auto group_end = begin;
    while (group_end != end && group_end->key[depth].second == fact)
      ++group_end;
    children.push_back({fact, build(begin, group_end, depth + 1)});
    begin = group_end;
  }
  node.children_begin = static_cast<std::uint32_t>(children_.size());
  children_.insert(children_.end(), children.begin(), children.end());
  node.children_end = static_cast<std::uint32_t>(children_.size());
  nodes_[index] = node;
  return index;
}

}  // namespace goal_alignment::search
