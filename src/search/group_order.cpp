// SPDX-License-Identifier: BSD-3-Clause
#include "group_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::search {

namespace {

constexpr int kRounds = 100;

using GroupSets = std::vector<std::vector<std::uint32_t>>;

/// The sets of groups that events touch, each once.
GroupSets touchedSets(const std::vector<Event>& events) {
  GroupSets sets;
  for (const Event& event : events) {
    std::vector<std::uint32_t> touched;
    for (const LocalChange& change : event.changes)
      touched.push_back(change.group);
    sets.push_back(std::move(touched));
  }
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

std::vector<double> positions(const GroupOrder& order) {
  std::vector<double> position(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    position[order[i]] = static_cast<double>(i);
  return position;
}

/// How far the sets stretch, all in all.
double span(const GroupOrder& order, const GroupSets& sets) {
  const std::vector<double> position = positions(order);
  double sum = 0;
  for (const auto& set : sets) {
    const auto [first, last] = std::minmax_element(
        set.begin(), set.end(), [&](auto a, auto b) { return position[a] < position[b]; });
    sum += position[*last] - position[*first];
  }
  return sum;
}

/// Moves every group to the mean of the centres of its sets.
GroupOrder pulledTogether(GroupOrder order, const GroupSets& sets) {
  const std::vector<double> position = positions(order);
  std::vector<double> sum(order.size(), 0);
  std::vector<double> count(order.size(), 0);
  for (const auto& set : sets) {
    double centre = 0;
    for (const std::uint32_t group : set)
      centre += position[group] / static_cast<double>(set.size());
    for (const std::uint32_t group : set) {
      sum[group] += centre;
      count[group] += 1;
    }
  }
  const auto target = [&](std::uint32_t group) {
    return count[group] > 0 ? sum[group] / count[group] : position[group];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return target(a) < target(b); });
  return order;
}

}  // namespace

std::vector<GroupOrder> groupOrders(std::size_t groups, const std::vector<Event>& events,
                                    const Limits& limits) {
  LimitMonitor monitor(limits);
  const GroupSets sets = touchedSets(events);
  std::vector<std::size_t> degree(groups, 0);
  for (const auto& set : sets) {
    for (const std::uint32_t group : set)
      ++degree[group];
  }
  GroupOrder order(groups);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return degree[a] < degree[b]; });
  const GroupOrder hubs_last = order;
  const GroupOrder hubs_first(order.rbegin(), order.rend());
  GroupOrder close = order;
  double least = span(order, sets);
  for (int round = 0; round < kRounds; ++round) {
    pollOrThrow(monitor, "the order of the mutex groups");
    order = pulledTogether(std::move(order), sets);
    const double now = span(order, sets);
    if (now >= least) continue;
    least = now;
    close = order;
  }
  return {close, hubs_last, hubs_first};
}

}  // namespace goal_alignment::search
