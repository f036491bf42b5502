// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "goal_alignment/common/limits.h"

namespace goal_alignment::search {

/// Sets of vectors, one value a level, as multi-valued decision diagrams (Kam, Villa, Brayton &
/// Sangiovanni-Vincentelli, "Multi-valued Decision Diagrams", 1998). Quasi-reduced: every path goes
/// through every level, and equal sets of suffixes are one node. The empty set alone has no nodes.
///
/// A package of our own, since those at hand keep their nodes in globals, can't be cancelled amid
/// an operation, and can't say what they hold. Here every instance stands by itself; an operation
/// polls its limits at each step and unwinds by throwing LimitReached, after which the diagram is
/// as usable as before.
///
/// Nodes never move. Those that no `Frame` holds, be it through others, may be collected whenever a
/// node is made: callers hold the arguments of what they call.
class DecisionDiagram {
 public:
  using Node = std::uint32_t;
  using Value = std::uint32_t;
  static constexpr Node kEmpty = 0;  ///< the empty set, at any level
  static constexpr Node kEnd = 1;    ///< below the last level: the set of the empty vector

  /// `domains`: the number of values, by level from the root down.
  explicit DecisionDiagram(std::vector<Value> domains);

  /// What the operations may use from now on: a step counts as a generated state.
  void limit(const Limits& limits);

  std::size_t levels() const { return domains_.size(); }
  Value domain(std::size_t level) const { return domains_[level]; }
  Node child(Node node, Value value) const { return words(node)[1 + value]; }

  /// Slots that hold nodes against collection, all kEmpty at first. Frames nest.
  class Frame {
   public:
    Frame(DecisionDiagram& diagram, std::size_t slots)
        : diagram_(diagram), base_(diagram.held_.size()) {
      diagram_.held_.resize(base_ + slots, kEmpty);
    }
    ~Frame() { diagram_.held_.resize(base_); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    /// Until a frame within this one is opened, the reference stays good.
    Node& operator[](std::size_t slot) { return diagram_.held_[base_ + slot]; }

    /// One slot more, for this node. Only while no frame within this one is open.
    void push(Node node) { diagram_.held_.push_back(node); }

   private:
    DecisionDiagram& diagram_;
    std::size_t base_;
  };

  /// The node with the frame's first slots as children; kEmpty where all of them are.
  Node make(std::size_t level, Frame& children);

  /// The set of this one vector.
  Node single(const std::vector<Value>& vector);

  /// The union of two sets at the same level. O(|a| · |b|) at most.
  Node unite(Node a, Node b, std::size_t level = 0);
  /// Their intersection.
  Node intersect(Node a, Node b, std::size_t level = 0);

  /// The number of vectors. O(nodes).
  double count(Node node) const;
  /// The number of nodes in the set's diagram.
  std::size_t size(Node node) const;

  /// A number for an operation of the caller's, for the cache below.
  std::uint32_t newOperation() { return ++operations_; }

  /// What the operation gave for (argument, node), where that is still known, else kUnknown.
  static constexpr Node kUnknown = static_cast<Node>(-1);
  Node recall(std::uint32_t operation, std::uint32_t argument, Node node) const;
  void remember(std::uint32_t operation, std::uint32_t argument, Node node, Node result);

  /// Counts one step of an operation. Throws LimitReached.
  void step();
  /// Steps since limit().
  std::uint64_t steps() const { return monitor_.states(); }

  /// Accounted bytes: nodes, tables, held slots.
  std::size_t bytes() const;
  std::size_t nodeCount() const { return node_count_; }
  std::size_t collections() const { return collections_; }

 private:
  using Word = std::uint32_t;

  struct CacheEntry {
    std::uint32_t operation = 0;
    std::uint32_t argument = 0;
    Node node = kEmpty;
    Node result = kEmpty;
  };

  static constexpr unsigned kBlockBits = 16;  // words in a block of nodes
  static constexpr Word kBlockMask = (Word{1} << kBlockBits) - 1;
  static constexpr Word kMarked = Word{1} << 31U;  // in a node's first word, beside its level
  static constexpr Word kFree = Word{1} << 30U;

  Word* words(Node node) { return blocks_[node >> kBlockBits].get() + (node & kBlockMask); }
  const Word* words(Node node) const {
    return blocks_[node >> kBlockBits].get() + (node & kBlockMask);
  }
  std::size_t hash(std::size_t level, const Word* children) const;
  static std::size_t hash(std::uint32_t operation, std::uint32_t argument, Node node);
  Node allocate(std::size_t level);
  void growTable();
  void growCache();
  void insert(Node node);
  void makeRoom(std::size_t level);
  void collect();
  void mark(Node node);
  void sweep();
  bool alive(Node node) const { return node <= kEnd || (words(node)[0] & kMarked) != 0; }
  Node combine(bool both, Node a, Node b, std::size_t level);

  std::vector<Value> domains_;
  Limits limits_;
  LimitMonitor monitor_;

  std::vector<std::unique_ptr<Word[]>> blocks_;  // a node: its level, its children
  Word next_free_ = kEnd + 1;                    // the first word never given out
  std::vector<std::vector<Node>> freed_;         // by level
  std::vector<Node> table_;                      // open addressing; kEmpty: free
  std::vector<CacheEntry> cache_;                // direct-mapped
  std::size_t forgotten_ = 0;                    // entries overwritten since it grew
  std::vector<Node> held_;
  std::size_t node_count_ = 0;
  std::size_t collect_at_;  // nodes
  std::size_t collections_ = 0;
  std::uint32_t operations_ = 2;
};

}  // namespace goal_alignment::search
