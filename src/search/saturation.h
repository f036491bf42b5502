// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "events.h"
#include "goal_alignment/search/decision_diagram.h"

namespace goal_alignment::search {

/// Closes sets of states under events, node by node from the last level up, so that most work is
/// done in small diagrams (Ciardo, Lüttgen & Siminiceanu, "Saturation: An Efficient Iteration
/// Strategy for Symbolic State-Space Generation", TACAS 2001). A node is saturated when no event
/// that touches nothing above its level leads out of it.
class Saturation {
 public:
  using Node = DecisionDiagram::Node;

  /// `level_of`: by group. The diagram must outlive this. Throws LimitReached.
  Saturation(DecisionDiagram& diagram, const std::vector<Event>& events,
             const std::vector<std::uint32_t>& level_of);

  /// All states that events lead to from the set, of those events that touch no level above
  /// `first`, and the set itself. Throws LimitReached.
  Node close(Node set, std::size_t first = 0) { return closeBelow(set, 0, first); }

  /// The states right after one event whose topmost level is this one. Throws LimitReached.
  Node after(Node set, std::size_t top) { return afterBelow(set, 0, top); }

 private:
  using Value = DecisionDiagram::Value;
  using Frame = DecisionDiagram::Frame;
  using Pairs = std::vector<std::pair<Value, Value>>;
  using Chain = std::uint32_t;
  static constexpr Chain kDone = 0;

  /// The rest of an event: what it does at a level, and further down. Equal rests are one, so that
  /// the cache serves all events that share them.
  struct Link {
    std::uint32_t level = 0;
    Pairs pairs;
    Chain next = kDone;
  };

  /// One thing that events with this topmost level do to one of its values.
  struct Move {
    Value to;
    Chain rest;
  };

  void addMoves(const LocalChange& top, Chain rest);
  Chain link(std::uint32_t level, const Pairs& pairs, Chain next);
  Node closeBelow(Node set, std::size_t level, std::size_t first);
  Node saturate(Node node, std::size_t level);
  Node saturateTop(Node node, std::size_t level);
  void saturateChildren(Frame& children, std::size_t level);
  Node fire(Chain chain, Node node, std::size_t level, bool saturated);
  Node afterBelow(Node set, std::size_t level, std::size_t top);

  DecisionDiagram& diagram_;
  std::vector<Link> links_;
  std::map<std::tuple<std::uint32_t, Pairs, Chain>, Chain> known_links_;
  std::vector<std::vector<std::vector<Move>>> moves_;  // by topmost level, by its value before
  std::uint32_t saturate_;
  std::uint32_t saturate_top_;
  std::uint32_t fire_;
  std::uint32_t fire_once_;
};

}  // namespace goal_alignment::search
