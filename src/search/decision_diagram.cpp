// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/decision_diagram.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::search {

namespace {

constexpr std::uint32_t kUnite = 1;
constexpr std::uint32_t kIntersect = 2;
constexpr std::size_t kFirstCollection = 1U << 18U;  // nodes
constexpr std::size_t kSmallestTable = 1U << 12U;
constexpr std::size_t kLargestCache = 1U << 22U;  // entries: 64 MiB

std::uint64_t mix(std::uint64_t hash, std::uint64_t more) {
  hash = (hash ^ more) * 0xbf58476d1ce4e5b9ULL;
  return hash ^ (hash >> 29U);
}

}  // namespace

DecisionDiagram::DecisionDiagram(std::vector<Value> domains)
    : domains_(std::move(domains)),
      monitor_(limits_),
      freed_(domains_.size()),
      table_(kSmallestTable, kEmpty),
      cache_(kSmallestTable),
      collect_at_(kFirstCollection) {}

void DecisionDiagram::limit(const Limits& limits) {
  limits_ = limits;
  monitor_ = LimitMonitor(limits);
}

void DecisionDiagram::step() {
  throwIfReached(monitor_.generated(), "an operation on decision diagrams");
}

std::size_t DecisionDiagram::hash(std::size_t level, const Word* children) const {
  std::uint64_t h = mix(0x9e3779b97f4a7c15ULL, level);
  for (Value value = 0; value < domains_[level]; ++value)
    h = mix(h, children[value]);
  return h ^ (h >> 32U);
}

std::size_t DecisionDiagram::hash(std::uint32_t operation, std::uint32_t argument, Node node) {
  const std::uint64_t h = mix(mix(operation, argument), node);
  return h ^ (h >> 32U);
}

DecisionDiagram::Node DecisionDiagram::make(std::size_t level, Frame& children) {
  const Value size = domains_[level];
  Word* first = &children[0];
  if (std::all_of(first, first + size, [](Node child) { return child == kEmpty; })) return kEmpty;
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = hash(level, first) & mask; table_[slot] != kEmpty;
       slot = (slot + 1) & mask) {
    const Word* const known = words(table_[slot]);
    if (known[0] == level && std::equal(first, first + size, known + 1)) return table_[slot];
  }
  makeRoom(level);
  const Node node = allocate(level);
  std::copy_n(first, size, words(node) + 1);
  insert(node);
  return node;
}

DecisionDiagram::Node DecisionDiagram::allocate(std::size_t level) {
  Node node = kEmpty;
  if (!freed_[level].empty()) {
    node = freed_[level].back();
    freed_[level].pop_back();
  } else {
    const Word size = domains_[level] + 1;
    // A node lies in one block: the rest of a block that is too small for it is left unused.
    if ((next_free_ & kBlockMask) + size > kBlockMask + 1) {
      next_free_ = (next_free_ | kBlockMask) + 1;
    }
    if (next_free_ >> kBlockBits >= blocks_.size()) {
      blocks_.push_back(std::make_unique<Word[]>(std::size_t{1} << kBlockBits));
    }
    node = next_free_;
    next_free_ += size;
  }
  words(node)[0] = static_cast<Word>(level);
  ++node_count_;
  return node;
}

void DecisionDiagram::insert(Node node) {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(words(node)[0], words(node) + 1) & mask;
  while (table_[slot] != kEmpty)
    slot = (slot + 1) & mask;
  table_[slot] = node;
}

void DecisionDiagram::growTable() {
  const std::vector<Node> old = std::move(table_);
  table_.assign(old.size() * 2, kEmpty);
  for (const Node node : old) {
    if (node != kEmpty) insert(node);
  }
}

/// What the cache forgets has to be computed again, in the worst case over and over: it grows when
/// as much was forgotten as it holds, while it has less than a quarter of the bytes.
void DecisionDiagram::growCache() {
  forgotten_ = 0;
  const std::size_t larger = cache_.size() * 2;
  if (larger > kLargestCache || larger * sizeof(CacheEntry) > limits_.bytes / 4) return;
  const std::vector<CacheEntry> old = std::move(cache_);
  cache_.assign(larger, {});
  for (const CacheEntry& e : old)
    cache_[hash(e.operation, e.argument, e.node) & (larger - 1)] = e;
}

std::size_t DecisionDiagram::bytes() const {
  return (blocks_.size() << kBlockBits) * sizeof(Word) + table_.capacity() * sizeof(Node) +
         cache_.capacity() * sizeof(CacheEntry) + held_.capacity() * sizeof(Node);
}

/// Collects when there are many more nodes than were alive the last time, or the bytes run out; a
/// collection that gives little back then ends the work, before it crawls.
void DecisionDiagram::makeRoom(std::size_t level) {
  if (node_count_ >= collect_at_) {
    collect();
    collect_at_ = std::max(kFirstCollection, node_count_ * 2);
  }
  const bool table_full = (node_count_ + 1) * 2 > table_.size();
  const std::size_t table_growth = table_full ? table_.size() * 2 * sizeof(Node) : 0;
  if (bytes() + table_growth + (sizeof(Word) << kBlockBits) > limits_.bytes &&
      (table_full || freed_[level].empty())) {
    const std::size_t before = node_count_;
    collect();
    if (node_count_ > before / 4 * 3) {
      throw LimitReached(LimitReason::Memory, "an operation on decision diagrams");
    }
  }
  if ((node_count_ + 1) * 2 > table_.size()) growTable();
}

void DecisionDiagram::collect() {
  ++collections_;
  for (const Node node : held_)
    mark(node);
  for (CacheEntry& e : cache_) {
    // Unite and intersect have a node for an argument, the operations of callers a number.
    const bool argument_alive = e.operation > kIntersect || alive(e.argument);
    if (!argument_alive || !alive(e.node) || !alive(e.result)) e = {};
  }
  sweep();
}

void DecisionDiagram::mark(Node node) {
  if (alive(node)) return;
  Word* const at = words(node);
  const Value size = domains_[at[0]];
  at[0] |= kMarked;
  for (Value value = 0; value < size; ++value)
    mark(at[1 + value]);
}

void DecisionDiagram::sweep() {
  std::size_t alive_nodes = 0;
  for (Node& node : table_) {
    if (node == kEmpty) continue;
    Word& first = words(node)[0];
    if ((first & kMarked) != 0) {
      ++alive_nodes;
    } else {
      freed_[first].push_back(node);
      first |= kFree;
    }
  }
  const std::vector<Node> old = std::move(table_);
  table_.assign(old.size(), kEmpty);
  for (const Node node : old) {
    if (node == kEmpty || (words(node)[0] & kFree) != 0) continue;
    words(node)[0] &= ~kMarked;
    insert(node);
  }
  node_count_ = alive_nodes;
}

DecisionDiagram::Node DecisionDiagram::recall(std::uint32_t operation, std::uint32_t argument,
                                              Node node) const {
  const CacheEntry& e = cache_[hash(operation, argument, node) & (cache_.size() - 1)];
  const bool hit = e.operation == operation && e.argument == argument && e.node == node;
  return hit ? e.result : kUnknown;
}

void DecisionDiagram::remember(std::uint32_t operation, std::uint32_t argument, Node node,
                               Node result) {
  CacheEntry& e = cache_[hash(operation, argument, node) & (cache_.size() - 1)];
  if (e.operation != 0) ++forgotten_;
  e = {operation, argument, node, result};
  if (forgotten_ > cache_.size()) growCache();
}

DecisionDiagram::Node DecisionDiagram::single(const std::vector<Value>& vector) {
  Frame below(*this, 1);
  below[0] = kEnd;
  for (std::size_t level = levels(); level-- > 0;) {
    Frame children(*this, domains_[level]);
    children[vector[level]] = below[0];
    below[0] = make(level, children);
  }
  return below[0];
}

DecisionDiagram::Node DecisionDiagram::unite(Node a, Node b, std::size_t level) {
  return combine(false, a, b, level);
}

DecisionDiagram::Node DecisionDiagram::intersect(Node a, Node b, std::size_t level) {
  return combine(true, a, b, level);
}

DecisionDiagram::Node DecisionDiagram::combine(bool both, Node a, Node b, std::size_t level) {
  if (a == b) return a;
  if (a > b) std::swap(a, b);
  if (a == kEmpty) return both ? kEmpty : b;
  const std::uint32_t operation = both ? kIntersect : kUnite;
  if (const Node known = recall(operation, a, b); known != kUnknown) return known;
  step();
  Frame children(*this, domains_[level]);
  for (Value value = 0; value < domains_[level]; ++value) {
    const Node part = combine(both, child(a, value), child(b, value), level + 1);
    children[value] = part;
  }
  const Node result = make(level, children);
  remember(operation, a, b, result);
  return result;
}

double DecisionDiagram::count(Node node) const {
  std::unordered_map<Node, double> counts = {{kEmpty, 0}, {kEnd, 1}};
  const auto visit = [&](const auto& self, Node n) -> double {
    if (const auto known = counts.find(n); known != counts.end()) return known->second;
    double sum = 0;
    for (Value value = 0; value < domains_[words(n)[0]]; ++value)
      sum += self(self, child(n, value));
    return counts[n] = sum;
  };
  return visit(visit, node);
}

std::size_t DecisionDiagram::size(Node node) const {
  std::unordered_set<Node> seen = {kEmpty, kEnd};
  const auto visit = [&](const auto& self, Node n) -> void {
    if (!seen.insert(n).second) return;
    for (Value value = 0; value < domains_[words(n)[0]]; ++value)
      self(self, child(n, value));
  };
  visit(visit, node);
  return seen.size() - 2;
}

}  // namespace goal_alignment::search
