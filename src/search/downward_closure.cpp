// SPDX-License-Identifier: BSD-3-Clause
#include "downward_closure.h"

namespace goal_alignment::search {

namespace {

using Node = DecisionDiagram::Node;
using Value = DecisionDiagram::Value;
using Frame = DecisionDiagram::Frame;

/// Works down the source; what it made of a node is remembered by the target's cache.
class Projection {
 public:
  Projection(const DecisionDiagram& source, const std::vector<LevelView>& views,
             DecisionDiagram& target)
      : source_(source), views_(views), target_(target), operation_(target.newOperation()) {}

  Node project(Node node, std::size_t from, std::size_t to) {
    if (node <= DecisionDiagram::kEnd) return node;
    const Node known = target_.recall(operation_, node, DecisionDiagram::kEnd);
    if (known != DecisionDiagram::kUnknown) return known;
    target_.step();
    const LevelView& view = views_[from];
    const bool dropped = view.values == 1;
    const std::size_t below = dropped ? to : to + 1;
    Frame children(target_, view.values + 1);
    for (Value value = 0; value < source_.domain(from); ++value) {
      const Value seen = view.seen_as[value];
      if (seen == LevelView::kHidden) continue;
      const Node projected = project(source_.child(node, value), from + 1, below);
      children[view.values] = projected;
      unite(children, seen, projected, below);
      if (seen != 0) unite(children, 0, projected, below);
    }
    const Node result = dropped ? children[0] : target_.make(to, children);
    target_.remember(operation_, node, DecisionDiagram::kEnd, result);
    return result;
  }

 private:
  void unite(Frame& children, Value value, Node more, std::size_t level) {
    const Node united = target_.unite(children[value], more, level);
    children[value] = united;
  }

  const DecisionDiagram& source_;
  const std::vector<LevelView>& views_;
  DecisionDiagram& target_;
  std::uint32_t operation_;
};

class Outside {
 public:
  explicit Outside(DecisionDiagram& diagram)
      : diagram_(diagram),
        operation_(diagram.newOperation()),
        zeros_(diagram, diagram.levels() + 1) {
    zeros_[diagram.levels()] = DecisionDiagram::kEnd;
    for (std::size_t level = diagram.levels(); level-- > 0;) {
      Frame children(diagram, diagram.domain(level));
      children[0] = zeros_[level + 1];
      zeros_[level] = diagram.make(level, children);
    }
  }

  /// A minimal vector outside starts with 0 and goes on minimally outside of what may follow; or
  /// with another value, then only 0 instead of that lets it in.
  Node minimal(Node closed, std::size_t level) {
    if (closed == DecisionDiagram::kEmpty) return zeros_[level];
    if (closed == DecisionDiagram::kEnd) return DecisionDiagram::kEmpty;
    const Node known = diagram_.recall(operation_, 0, closed);
    if (known != DecisionDiagram::kUnknown) return known;
    diagram_.step();
    Frame children(diagram_, diagram_.domain(level));
    for (Value value = 0; value < diagram_.domain(level); ++value) {
      children[value] = minimal(diagram_.child(closed, value), level + 1);
      if (value == 0) continue;
      children[value] = diagram_.intersect(children[value], diagram_.child(closed, 0), level + 1);
    }
    const Node result = diagram_.make(level, children);
    diagram_.remember(operation_, 0, closed, result);
    return result;
  }

 private:
  DecisionDiagram& diagram_;
  std::uint32_t operation_;
  Frame zeros_;  // by level: the vector of zeros from there on
};

bool visitBelow(const DecisionDiagram& diagram, Node node, std::vector<Value>& vector,
                const VisitVector& visit) {
  if (node == DecisionDiagram::kEmpty) return true;
  if (node == DecisionDiagram::kEnd) return visit(vector);
  for (Value value = 0; value < diagram.domain(vector.size()); ++value) {
    const Node child = diagram.child(node, value);
    vector.push_back(value);
    const bool goes_on = visitBelow(diagram, child, vector, visit);
    vector.pop_back();
    if (!goes_on) return false;
  }
  return true;
}

}  // namespace

Node closedBelow(const DecisionDiagram& source, Node set, const std::vector<LevelView>& views,
                 DecisionDiagram& target) {
  return Projection(source, views, target).project(set, 0, 0);
}

Node minimalOutside(DecisionDiagram& diagram, Node closed) {
  return Outside(diagram).minimal(closed, 0);
}

bool forEachVector(const DecisionDiagram& diagram, Node set, const VisitVector& visit) {
  std::vector<Value> vector;
  return visitBelow(diagram, set, vector, visit);
}

}  // namespace goal_alignment::search
