// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/successor_generator.h"

#include <algorithm>
#include <tuple>

#include "goal_alignment/common/blocks.h"
#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::search {

using task::FactId;
using task::OperatorId;

/// A fact of a precondition; the rarest comes first.
struct SuccessorGenerator::Ranked {
  std::uint32_t uses;
  FactId fact;

  bool operator<(const Ranked& other) const {
    return std::tie(uses, fact) < std::tie(other.uses, other.fact);
  }
};

/// An operator with its precondition in the order of the trie.
struct SuccessorGenerator::Entry {
  Span<Ranked> key;
  OperatorId op;
};

SuccessorGenerator::SuccessorGenerator(const task::Task& task, const Limits& limits)
    : words_(task::wordsFor(task.facts.size())), first_(task.facts.size(), 0) {
  LimitMonitor monitor(limits);
  const auto poll = [&] { pollOrThrow(monitor, "preparing the search"); };
  std::vector<std::uint32_t> uses(task.facts.size(), 0);
  for (const task::Operator& op : task.operators) {
    poll();
    for (const FactId fact : op.precondition)
      ++uses[fact];
  }
  std::vector<Entry> entries(task.operators.size());
  ArrayStore<Ranked> keys;
  std::vector<Ranked> key;
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    poll();
    key.clear();
    for (const FactId fact : task.operators[op].precondition)
      key.push_back({uses[fact], fact});
    std::sort(key.begin(), key.end());
    entries[op] = {keys.keep(key), op};
  }
  std::stable_sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    poll();
    return std::lexicographical_compare(a.key.begin(), a.key.end(), b.key.begin(), b.key.end());
  });
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
    const FactId fact = begin->key[depth].fact;
    auto group_end = begin;
    while (group_end != end && group_end->key[depth].fact == fact)
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
