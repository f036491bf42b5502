// SPDX-License-Identifier: BSD-3-Clause
#include "saturation.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace goal_alignment::search {

namespace {

using Changes = std::vector<LocalChange>;  // of an event, from the last level up

std::vector<Changes> byLevels(const std::vector<Event>& events,
                              const std::vector<std::uint32_t>& level_of) {
  std::vector<Changes> result;
  for (const Event& event : events) {
    Changes changes = event.changes;
    for (LocalChange& change : changes)
      change.group = level_of[change.group];
    std::sort(changes.begin(), changes.end(),
              [](const LocalChange& a, const LocalChange& b) { return a.group > b.group; });
    result.push_back(std::move(changes));
  }
  return result;
}

/// Makes one event of those that differ in nothing but what they do at this level, such as the one
/// that takes the last token and the one that takes the last but one.
std::vector<Changes> mergedAt(std::uint32_t level, std::vector<Changes> events) {
  const auto less = [](const LocalChange& a, const LocalChange& b) {
    return std::tie(a.group, a.pairs) < std::tie(b.group, b.pairs);
  };
  const auto all_less = [&](const Changes& a, const Changes& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  };
  std::map<Changes, std::size_t, decltype(all_less)> known(all_less);
  std::vector<Changes> merged;
  for (Changes& event : events) {
    const auto here = std::find_if(event.begin(), event.end(), [&](const LocalChange& change) {
      return change.group == level;
    });
    if (here == event.end()) {
      merged.push_back(std::move(event));
      continue;
    }
    const auto pairs = std::exchange(here->pairs, {});
    const auto [at, is_new] = known.try_emplace(event, merged.size());
    if (is_new) merged.push_back(event);
    auto& united = merged[at->second][static_cast<std::size_t>(here - event.begin())].pairs;
    united.insert(united.end(), pairs.begin(), pairs.end());
  }
  for (const auto& [event, index] : known) {
    for (LocalChange& change : merged[index]) {
      if (change.group != level) continue;
      std::sort(change.pairs.begin(), change.pairs.end());
      change.pairs.erase(std::unique(change.pairs.begin(), change.pairs.end()), change.pairs.end());
    }
  }
  return merged;
}

}  // namespace

Saturation::Saturation(DecisionDiagram& diagram, const std::vector<Event>& events,
                       const std::vector<std::uint32_t>& level_of)
    : diagram_(diagram),
      links_(1),
      moves_(diagram.levels()),
      saturate_(diagram.newOperation()),
      saturate_top_(diagram.newOperation()),
      fire_(diagram.newOperation()),
      fire_once_(diagram.newOperation()) {
  for (std::size_t level = 0; level < moves_.size(); ++level)
    moves_[level].resize(diagram.domain(level));
  std::vector<Changes> merged = byLevels(events, level_of);
  for (std::size_t level = moves_.size(); level-- > 0;) {
    diagram.step();
    merged = mergedAt(static_cast<std::uint32_t>(level), std::move(merged));
  }
  for (const Changes& changes : merged) {
    Chain rest = kDone;
    for (std::size_t i = 0; i + 1 < changes.size(); ++i)
      rest = link(changes[i].group, changes[i].pairs, rest);
    addMoves(changes.back(), rest);
  }
}

void Saturation::addMoves(const LocalChange& top, Chain rest) {
  for (const auto& [from, to] : top.pairs) {
    if (from == to && rest == kDone) continue;  // changes nothing: merged with others that do
    std::vector<Move>& moves = moves_[top.group][from];
    const auto same = [to = to, rest](const Move& m) { return m.to == to && m.rest == rest; };
    if (std::none_of(moves.begin(), moves.end(), same)) moves.push_back({to, rest});
  }
}

Saturation::Chain Saturation::link(std::uint32_t level, const Pairs& pairs, Chain next) {
  const auto [at, is_new] =
      known_links_.try_emplace({level, pairs, next}, static_cast<Chain>(links_.size()));
  if (is_new) links_.push_back({level, pairs, next});
  return at->second;
}

Saturation::Node Saturation::closeBelow(Node set, std::size_t level, std::size_t first) {
  if (level == first) return saturate(set, level);
  if (set == DecisionDiagram::kEmpty) return set;
  Frame children(diagram_, diagram_.domain(level));
  for (Value value = 0; value < diagram_.domain(level); ++value)
    children[value] = closeBelow(diagram_.child(set, value), level + 1, first);
  return diagram_.make(level, children);
}

Saturation::Node Saturation::saturate(Node node, std::size_t level) {
  if (node == DecisionDiagram::kEmpty || level == diagram_.levels()) return node;
  const Node known = diagram_.recall(saturate_, 0, node);
  if (known != DecisionDiagram::kUnknown) return known;
  diagram_.step();
  const Value size = diagram_.domain(level);
  Frame children(diagram_, size + 1);
  for (Value value = 0; value < size; ++value)
    children[value] = saturate(diagram_.child(node, value), level + 1);
  children[size] = diagram_.make(level, children);
  const Node result = saturateTop(children[size], level);
  diagram_.remember(saturate_, 0, node, result);
  return result;
}

/// Of a node whose children are saturated.
Saturation::Node Saturation::saturateTop(Node node, std::size_t level) {
  if (node == DecisionDiagram::kEmpty) return node;
  const Node known = diagram_.recall(saturate_top_, 0, node);
  if (known != DecisionDiagram::kUnknown) return known;
  Frame children(diagram_, diagram_.domain(level) + 1);
  for (Value value = 0; value < diagram_.domain(level); ++value)
    children[value] = diagram_.child(node, value);
  saturateChildren(children, level);
  const Node result = diagram_.make(level, children);
  diagram_.remember(saturate_top_, 0, node, result);
  return result;
}

/// Fires the events of this level until nothing comes of it. A value whose child has grown is
/// looked at again; what it leads to is taken in at once.
void Saturation::saturateChildren(Frame& children, std::size_t level) {
  const Value size = diagram_.domain(level);
  std::vector<bool> grown(size, true);
  for (bool any = true; any;) {
    any = false;
    for (Value from = 0; from < size; ++from) {
      if (!grown[from]) continue;
      grown[from] = false;
      for (const Move& move : moves_[level][from]) {
        if (children[from] == DecisionDiagram::kEmpty) break;
        children[size] = fire(move.rest, children[from], level + 1, true);
        const Node larger = diagram_.unite(children[move.to], children[size], level + 1);
        if (larger == children[move.to]) continue;
        children[move.to] = larger;
        grown[move.to] = true;
        any = true;
      }
    }
  }
}

/// What the rest of an event makes of a node; of a saturated node, if so wanted, saturated.
Saturation::Node Saturation::fire(Chain chain, Node node, std::size_t level, bool saturated) {
  if (chain == kDone || node == DecisionDiagram::kEmpty) return node;
  const std::uint32_t operation = saturated ? fire_ : fire_once_;
  const Node known = diagram_.recall(operation, chain, node);
  if (known != DecisionDiagram::kUnknown) return known;
  diagram_.step();
  const Value size = diagram_.domain(level);
  Frame children(diagram_, size + 1);
  if (level < links_[chain].level) {
    for (Value value = 0; value < size; ++value)
      children[value] = fire(chain, diagram_.child(node, value), level + 1, saturated);
  } else {
    for (const auto& [from, to] : links_[chain].pairs) {
      children[size] = fire(links_[chain].next, diagram_.child(node, from), level + 1, saturated);
      children[to] = diagram_.unite(children[to], children[size], level + 1);
    }
  }
  children[size] = diagram_.make(level, children);
  const Node result = saturated ? saturateTop(children[size], level) : children[size];
  diagram_.remember(operation, chain, node, result);
  return result;
}

Saturation::Node Saturation::afterBelow(Node set, std::size_t level, std::size_t top) {
  if (set == DecisionDiagram::kEmpty) return set;
  const Value size = diagram_.domain(level);
  Frame children(diagram_, size + 1);
  for (Value from = 0; from < size; ++from) {
    const Node child = diagram_.child(set, from);
    if (level < top) {
      children[from] = afterBelow(child, level + 1, top);
      continue;
    }
    for (const Move& move : moves_[level][from]) {
      children[size] = fire(move.rest, child, level + 1, false);
      children[move.to] = diagram_.unite(children[move.to], children[size], level + 1);
    }
  }
  return diagram_.make(level, children);
}

}  // namespace goal_alignment::search
