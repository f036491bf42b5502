// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/mutex_groups.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::heuristics {

using task::ConditionalEffect;
using task::FactId;
using task::FactSet;
using task::has;
using task::Operator;
using task::OperatorId;
using task::Task;
using task::Word;

namespace {

void poll(LimitMonitor& monitor) {
  pollOrThrow(monitor, "the mutex groups");
}

/// A set of facts that also knows its members by a bit each.
struct Members {
  explicit Members(std::size_t fact_count) : bits(task::wordsFor(fact_count), 0) {}

  bool has(FactId fact) const { return task::testBit(bits.data(), fact); }
  void add(FactId fact) {
    task::setBit(bits.data(), fact);
    facts.push_back(fact);
  }
  void cutTo(std::size_t count) {
    for (; facts.size() > count; facts.pop_back())
      task::clearBit(bits.data(), facts.back());
  }

  std::vector<Word> bits;
  std::vector<FactId> facts;  // in the order of their coming
};

/// Whether the operator may leave the group without a true fact, where one was true before.
bool mayEmpty(const Operator& op, const Members& group) {
  const auto any = [&](const FactSet& facts) {
    return std::any_of(facts.begin(), facts.end(), [&](FactId f) { return group.has(f); });
  };
  bool deletes = any(op.del);
  for (const ConditionalEffect& effect : op.conditional)
    deletes = deletes || (any(effect.del) && !any(effect.add));
  if (!deletes || any(op.add)) return false;
  // The one true fact is known where the precondition names it; what it doesn't delete stays.
  return std::none_of(op.precondition.begin(), op.precondition.end(), [&](FactId f) {
    const auto deleted_by = [&](const ConditionalEffect& e) { return has(e.del, f); };
    return group.has(f) && !has(op.del, f) &&
           std::none_of(op.conditional.begin(), op.conditional.end(), deleted_by);
  });
}

}  // namespace

MutexGroups::MutexGroups(const Task& task, std::vector<FactSet> groups, const Limits& limits)
    : groups_(std::move(groups)), places_(task.facts.size()), exactly_one_(groups_.size(), false) {
  for (std::uint32_t group = 0; group < groups_.size(); ++group) {
    for (std::uint32_t value = 0; value < groups_[group].size(); ++value)
      places_[groups_[group][value]] = {group, value};
  }
  for (const FactId fact : task.initial)
    exactly_one_[places_[fact].group] = true;
  Members members(task.facts.size());
  std::vector<std::uint32_t> touched;
  LimitMonitor monitor(limits);
  for (const Operator& op : task.operators) {
    poll(monitor);
    touched.clear();
    const auto touch = [&](const FactSet& facts) {
      for (const FactId fact : facts)
        touched.push_back(places_[fact].group);
    };
    touch(op.del);
    for (const ConditionalEffect& effect : op.conditional)
      touch(effect.del);
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::uint32_t group : touched) {
      if (!exactly_one_[group]) continue;
      for (const FactId fact : groups_[group])
        members.add(fact);
      if (mayEmpty(op, members)) exactly_one_[group] = false;
      members.cutTo(0);
    }
  }
}

namespace {

/// Takes the largest group that is on offer, cuts the others down to what it leaves, and so on;
/// facts that no group holds stand alone.
class Cover {
 public:
  Cover(std::size_t facts, LimitMonitor& monitor) : monitor_(monitor), covered_(facts, false) {}

  void offer(FactSet group) {
    if (!group.empty()) offers_.push({group.size(), ~offer_count_++, std::move(group)});
  }

  /// `regrow` gets the rest of a group of which facts were taken, and says what to offer instead.
  template <typename Regrow>
  std::vector<FactSet> take(Regrow&& regrow) {
    std::vector<FactSet> taken;
    while (!offers_.empty()) {
      poll(monitor_);
      FactSet group = std::get<2>(offers_.top());
      offers_.pop();
      const std::size_t offered = group.size();
      group.erase(std::remove_if(group.begin(), group.end(), [&](FactId f) { return covered_[f]; }),
                  group.end());
      if (group.size() < offered) {
        offer(regrow(std::move(group)));
        continue;
      }
      for (const FactId fact : group)
        covered_[fact] = true;
      taken.push_back(std::move(group));
    }
    for (FactId fact = 0; fact < covered_.size(); ++fact) {
      if (!covered_[fact]) taken.push_back({fact});
    }
    std::sort(taken.begin(), taken.end(), [this](const FactSet& a, const FactSet& b) {
      poll(monitor_);
      return a < b;
    });
    return taken;
  }

  bool covered(FactId fact) const { return covered_[fact]; }

 private:
  using Offer = std::tuple<std::size_t, std::uint64_t, FactSet>;  // the larger, then the earlier

  LimitMonitor& monitor_;
  std::vector<bool> covered_;
  std::uint64_t offer_count_ = 0;
  std::priority_queue<Offer> offers_;
};

/// Grows a clique of the mutex graph around the fact, out of `open` facts: always by the fact that
/// leaves most others to choose from.
FactSet growClique(FactId seed, const std::vector<std::vector<Word>>& mutex_rows,
                   std::vector<Word> open, LimitMonitor& monitor) {
  const std::size_t words = open.size();
  FactSet clique = {seed};
  const auto keep = [&](FactId fact) {
    for (std::size_t i = 0; i < words; ++i)
      open[i] &= mutex_rows[fact][i];
    task::clearBit(open.data(), fact);
  };
  keep(seed);
  for (;;) {
    poll(monitor);
    int most = -1;
    FactId best = 0;
    task::forEachBit(open.data(), words, [&](std::size_t fact) {
      int common = 0;
      for (std::size_t i = 0; i < words; ++i)
        common += __builtin_popcountll(open[i] & mutex_rows[fact][i]);
      if (common > most) {
        most = common;
        best = static_cast<FactId>(fact);
      }
    });
    if (most < 0) return task::makeFactSet(std::move(clique));
    clique.push_back(best);
    keep(best);
  }
}

}  // namespace

MutexGroups groupsFromPairs(const Task& task, const MutexTable& mutexes, const Limits& limits) {
  const std::size_t facts = task.facts.size();
  const std::size_t words = task::wordsFor(facts);
  if (facts * words * sizeof(Word) > limits.bytes) {
    throw LimitReached(LimitReason::Memory, "the mutex groups");
  }
  LimitMonitor monitor(limits);
  std::vector<std::vector<Word>> rows(facts, std::vector<Word>(words, 0));
  std::vector<Word> open(words, 0);
  for (FactId f = 0; f < facts; ++f) {
    poll(monitor);
    for (FactId g = 0; g < facts; ++g) {
      if (mutexes.mutex(f, g)) task::setBit(rows[f].data(), g);
    }
    task::setBit(open.data(), f);
  }
  Cover cover(facts, monitor);
  // A clique that contains a fact is found again from it: one seed a clique is enough to begin
  // with.
  std::vector<bool> seen(facts, false);
  for (FactId f = 0; f < facts; ++f) {
    if (seen[f]) continue;
    FactSet clique = growClique(f, rows, open, monitor);
    for (const FactId member : clique)
      seen[member] = true;
    cover.offer(std::move(clique));
  }
  return {task, cover.take([&](FactSet rest) -> FactSet {
            if (rest.empty()) return rest;
            for (FactId f = 0; f < facts; ++f) {
              if (cover.covered(f)) task::clearBit(open.data(), f);
            }
            return growClique(rest.front(), rows, open, monitor);
          }),
          limits};
}

namespace {

/// Searches for fact-alternating mutex groups around single facts.
class InvariantSearch {
 public:
  InvariantSearch(const Task& task, LimitMonitor& monitor)
      : task_(task),
        monitor_(monitor),
        adders_(task.facts.size()),
        users_(task.facts.size()),
        initial_(task.facts.size()),
        group_(task.facts.size()) {
    for (const FactId fact : task.initial)
      initial_.add(fact);
    for (OperatorId id = 0; id < task.operators.size(); ++id) {
      poll(monitor);
      const Operator& op = task.operators[id];
      note(op.add, id, adders_);
      note(op.precondition, id, users_);
      for (const ConditionalEffect& effect : op.conditional)
        note(effect.add, id, adders_);
    }
  }

  /// A group with the fact in it, as large as the search gets it; empty: none was found.
  FactSet around(FactId fact) {
    group_.cutTo(0);
    steps_left_ = kMaxSteps;
    if (!include(fact)) return {};
    extend();
    return task::makeFactSet(group_.facts);
  }

 private:
  static constexpr int kMaxSteps = 2000;

  static void note(const FactSet& facts, OperatorId id,
                   std::vector<std::vector<OperatorId>>& where) {
    for (const FactId fact : facts) {
      if (where[fact].empty() || where[fact].back() != id) where[fact].push_back(id);
    }
  }

  std::size_t countTrueAtFirst() const {
    return static_cast<std::size_t>(std::count_if(group_.facts.begin(), group_.facts.end(),
                                                  [&](FactId f) { return initial_.has(f); }));
  }

  /// Takes the fact in, and what repairs the operators that this puts out of balance. False: it
  /// can't be, and the group is as before.
  bool include(FactId fact) {
    poll(monitor_);
    const std::size_t before = group_.facts.size();
    group_.add(fact);
    if (countTrueAtFirst() <= 1 && balanceFrom(before)) return true;
    group_.cutTo(before);
    return false;
  }

  /// Looks at the operators that add the members from the index on, and repairs the first that is
  /// out of balance in one way after another.
  bool balanceFrom(std::size_t index) {
    for (; index < group_.facts.size(); ++index) {
      for (const OperatorId id : adders_[group_.facts[index]]) {
        const Operator& op = task_.operators[id];
        if (balanced(op)) continue;
        if (--steps_left_ < 0) return false;
        for (const FactId fact : op.precondition) {
          if (has(op.del, fact) && !group_.has(fact) && include(fact)) return balanceFrom(index);
        }
        return false;
      }
    }
    return true;
  }

  /// Whether the operator takes at least as many members away as it brings. What conditional
  /// effects bring must be paid for by the unconditional deletes: they may all come about.
  bool balanced(const Operator& op) const {
    std::size_t brought = 0;
    const auto count = [&](const FactSet& add) {
      for (const FactId fact : add) {
        const bool stays =
            has(op.precondition, fact) && !has(op.del, fact) && op.conditional.empty();
        if (group_.has(fact) && !stays) ++brought;
      }
    };
    count(op.add);
    for (const ConditionalEffect& effect : op.conditional)
      count(effect.add);
    std::size_t taken = 0;
    for (const FactId fact : op.precondition) {
      if (group_.has(fact) && has(op.del, fact)) ++taken;
    }
    return brought <= taken;
  }

  /// What operators make out of members may be members too.
  void extend() {
    for (std::size_t index = 0; index < group_.facts.size(); ++index) {  // NOLINT: it grows
      const FactId member = group_.facts[index];
      for (const OperatorId id : users_[member]) {
        const Operator& op = task_.operators[id];
        if (!has(op.del, member)) continue;
        for (const FactId fact : op.add) {
          if (!group_.has(fact) && steps_left_ > 0) include(fact);
        }
      }
    }
  }

  const Task& task_;
  LimitMonitor& monitor_;
  std::vector<std::vector<OperatorId>> adders_;  // by fact
  std::vector<std::vector<OperatorId>> users_;   // by fact of their precondition
  Members initial_;
  Members group_;
  int steps_left_ = 0;
};

}  // namespace

MutexGroups groupsFromInvariants(const Task& task, const Limits& limits) {
  LimitMonitor monitor(limits);
  InvariantSearch search(task, monitor);
  Cover cover(task.facts.size(), monitor);
  std::vector<bool> seen(task.facts.size(), false);
  for (FactId fact = 0; fact < task.facts.size(); ++fact) {
    if (seen[fact]) continue;
    FactSet group = search.around(fact);
    for (const FactId member : group)
      seen[member] = true;
    cover.offer(std::move(group));
  }
  return {task, cover.take([](FactSet rest) { return rest; }), limits};
}

MutexGroups mutexGroups(const Task& task, const MutexTable& mutexes, const Limits& limits) {
  return mutexes.known() ? groupsFromPairs(task, mutexes, limits)
                         : groupsFromInvariants(task, limits);
}

}  // namespace goal_alignment::heuristics
