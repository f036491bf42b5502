// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "events.h"
#include "goal_alignment/search/decision_diagram.h"
#include "goal_alignment/task/task.h"
#include "saturation.h"

namespace goal_alignment::search {

/// Finds a way between two states. Saturation leaves no trace of how it came to a state, and sets
/// by distance would be far larger than what it works with. So the way is divided: into events of
/// the topmost level, found by rings around the first state, each closed under all lower events,
/// and into ways that lower events make from one of these to the next, which are divided again.
class PathFinder {
 public:
  using Value = DecisionDiagram::Value;
  using Vector = std::vector<Value>;  ///< a state, by level

  /// The diagram must outlive this.
  PathFinder(DecisionDiagram& diagram, const std::vector<Event>& events,
             const std::vector<std::uint32_t>& level_of);

  /// The operators on a way, not a shortest one. `to` must be reachable from `from`. Throws
  /// LimitReached.
  task::Plan path(const Vector& from, const Vector& to);

 private:
  using Node = DecisionDiagram::Node;
  using Frame = DecisionDiagram::Frame;

  void findBackwards(const Vector& from, Vector to, std::size_t top, task::Plan& plan);
  Vector backThroughRings(const Vector& from, Vector to, std::size_t top, task::Plan& plan);
  Vector entryTo(const Vector& state, Node entries, std::size_t top);
  Vector before(const Vector& state, Node ring, std::size_t top, task::OperatorId& op) const;
  bool contains(Node set, const Vector& state) const;
  bool pick(Node set, const std::vector<std::vector<Value>>& allowed, Vector& state) const;

  DecisionDiagram& diagram_;
  std::vector<std::vector<Event>> events_;  // by topmost level; groups are levels
  Saturation forwards_;
  Saturation backwards_;
};

}  // namespace goal_alignment::search
