// SPDX-License-Identifier: BSD-3-Clause
#include "events.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::search {

using heuristics::MutexGroups;
using task::ConditionalEffect;
using task::FactId;
using task::FactSet;
using task::Operator;

bool LocalChange::changes() const {
  return std::any_of(pairs.begin(), pairs.end(),
                     [](auto pair) { return pair.first != pair.second; });
}

namespace {

/// More cases of conditional effects than this make no diagram that is worth its time.
constexpr std::size_t kMaxCases = 50'000;

/// What holds before and what is done in one case of an operator.
struct Case {
  std::vector<FactId> holds;
  std::vector<FactId> fails;
  std::vector<FactId> add;
  std::vector<FactId> del;
};

bool among(const std::vector<FactId>& facts, FactId fact) {
  return std::find(facts.begin(), facts.end(), fact) != facts.end();
}

void append(std::vector<FactId>& facts, const FactSet& more) {
  facts.insert(facts.end(), more.begin(), more.end());
}

/// Builds the events of one operator after the other.
class EventBuilder {
 public:
  EventBuilder(const MutexGroups& groups, const Limits& limits)
      : groups_(groups), limits_(limits), monitor_(limits) {}

  void add(task::OperatorId id, const Operator& op) {
    split(id, op, 0, {op.precondition, {}, op.add, op.del});
  }

  std::vector<Event> take() { return std::move(events_); }

 private:
  /// Goes on with the operator's effects from the index on, in the case that they come about and in
  /// those that they don't: told apart by which fact of the condition is the first to fail.
  void split(task::OperatorId id, const Operator& op, std::size_t index, const Case& so_far) {
    throwIfReached(monitor_.generated(bytes_), "the cases of conditional effects");
    if (!possible(so_far)) return;
    if (index == op.conditional.size()) {
      if (!op.conditional.empty() && ++cases_ > kMaxCases)
        throw LimitReached(LimitReason::States, "the cases of conditional effects");
      finish(id, so_far);
      return;
    }
    const ConditionalEffect& effect = op.conditional[index];
    Case next = so_far;
    for (const FactId fact : effect.condition) {
      next.fails.push_back(fact);
      split(id, op, index + 1, next);
      next.fails.pop_back();
      next.holds.push_back(fact);
    }
    append(next.add, effect.add);
    append(next.del, effect.del);
    split(id, op, index + 1, next);
  }

  bool possible(const Case& c) const {
    for (const FactId fact : c.holds) {
      if (among(c.fails, fact)) return false;
      const auto mutex = [&](FactId other) {
        return other != fact && groups_.place(other).group == groups_.place(fact).group;
      };
      if (std::any_of(c.holds.begin(), c.holds.end(), mutex)) return false;
    }
    return true;
  }

  void finish(task::OperatorId id, const Case& c) {
    std::vector<std::uint32_t> touched;
    for (const auto* facts : {&c.holds, &c.fails, &c.add, &c.del}) {
      for (const FactId fact : *facts)
        touched.push_back(groups_.place(fact).group);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    Event event;
    event.op = id;
    bool any = false;
    for (const std::uint32_t group : touched) {
      LocalChange change = localChange(c, group);
      if (change.pairs.empty()) return;
      any = any || change.changes();
      if (change.changes() || change.pairs.size() < groups_.valueCount(group)) {
        event.changes.push_back(std::move(change));
      }
    }
    if (!any) return;
    for (const LocalChange& change : event.changes)
      bytes_ += sizeof(change) + change.pairs.size() * sizeof(change.pairs[0]);
    events_.push_back(std::move(event));
  }

  /// Which value becomes which. Where two facts of the group would be true afterwards, no reachable
  /// state allows the operator; where none would, though one always is, neither.
  LocalChange localChange(const Case& c, std::uint32_t group) const {
    const FactSet& facts = groups_.groups()[group];
    const auto none = static_cast<std::uint32_t>(facts.size());
    LocalChange change;
    change.group = group;
    std::vector<std::uint32_t> added;
    for (const FactId fact : c.add) {
      if (groups_.place(fact).group == group) added.push_back(groups_.place(fact).value);
    }
    for (std::uint32_t from = 0; from < groups_.valueCount(group); ++from) {
      if (!allows(c, group, from)) continue;
      std::vector<std::uint32_t> after = added;
      if (from != none && !among(c.del, facts[from])) after.push_back(from);
      const bool several = std::any_of(after.begin(), after.end(),
                                       [&](std::uint32_t value) { return value != after[0]; });
      const std::uint32_t to = after.empty() ? none : after[0];
      if (!several && to < groups_.valueCount(group)) change.pairs.emplace_back(from, to);
    }
    return change;
  }

  bool allows(const Case& c, std::uint32_t group, std::uint32_t value) const {
    const auto is = [&](FactId fact) { return groups_.place(fact).value == value; };
    const auto here = [&](FactId fact) { return groups_.place(fact).group == group; };
    return std::all_of(c.holds.begin(), c.holds.end(),
                       [&](FactId fact) { return !here(fact) || is(fact); }) &&
           std::none_of(c.fails.begin(), c.fails.end(),
                        [&](FactId fact) { return here(fact) && is(fact); });
  }

  const MutexGroups& groups_;
  Limits limits_;
  LimitMonitor monitor_;
  std::vector<Event> events_;
  std::size_t bytes_ = 0;
  std::size_t cases_ = 0;
};

}  // namespace

std::vector<Event> makeEvents(const task::Task& task, const MutexGroups& groups,
                              const Limits& limits) {
  EventBuilder builder(groups, limits);
  for (task::OperatorId id = 0; id < task.operators.size(); ++id)
    builder.add(id, task.operators[id]);
  return builder.take();
}

}  // namespace goal_alignment::search
