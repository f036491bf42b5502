// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/mutexes.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::heuristics {

using task::ConditionalEffect;
using task::FactId;
using task::FactSet;
using task::OperatorId;
using task::Word;

namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;
/// In words of a row that are looked at: some seconds.
constexpr std::uint64_t kMaxSteps = 4'000'000'000;

/// Indices waiting for another look, each at most once.
class WorkList {
 public:
  explicit WorkList(std::size_t size) : waiting_(size, false) {}

  void push(std::uint32_t index) {
    if (waiting_[index]) return;
    waiting_[index] = true;
    queue_.push_back(index);
  }
  bool empty() const { return queue_.empty(); }
  std::uint32_t pop() {
    const std::uint32_t index = queue_.front();
    queue_.pop_front();
    waiting_[index] = false;
    return index;
  }

 private:
  std::vector<bool> waiting_;
  std::deque<std::uint32_t> queue_;
};

/// One way an operator may act: with none of its conditional effects for certain, or with one.
struct Part {
  OperatorId op;
  FactSet precondition;  // the effect's condition included
  FactSet add;
  FactSet del;                                // what is deleted for certain
  std::vector<const ConditionalEffect*> may;  // what may happen besides
};

bool implies(const FactSet& facts, const FactSet& condition) {
  return std::includes(facts.begin(), facts.end(), condition.begin(), condition.end());
}

Part makePart(const task::Task& task, OperatorId id, const ConditionalEffect* effect) {
  const task::Operator& op = task.operators[id];
  Part part = {id, op.precondition, op.add, op.del, {}};
  if (effect != nullptr) part.precondition = task::unite(part.precondition, effect->condition);
  for (const ConditionalEffect& other : op.conditional) {
    if (implies(part.precondition, other.condition)) {
      part.add = task::unite(part.add, other.add);
      part.del = task::unite(part.del, other.del);
    } else if (!other.add.empty()) {
      part.may.push_back(&other);
    }
  }
  return part;
}

std::vector<Part> partsOf(const task::Task& task, LimitMonitor& monitor) {
  std::vector<Part> parts;
  parts.reserve(task.operators.size());
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    pollOrThrow(monitor, "the mutex table");
    parts.push_back(makePart(task, op, nullptr));
    for (const ConditionalEffect& effect : task.operators[op].conditional) {
      if (!effect.add.empty()) parts.push_back(makePart(task, op, &effect));
    }
  }
  return parts;
}

}  // namespace

/// Marks f as possible together with each of `others`; true when that is news.
bool MutexTable::reachTogether(FactId f, const std::vector<Word>& others) {
  bool changed = false;
  Word* const own = row(f);
  for (std::size_t i = 0; i < words_; ++i) {
    Word fresh = others[i] & ~own[i];
    if (fresh == 0) continue;
    changed = true;
    own[i] |= fresh;
    for (; fresh != 0; fresh &= fresh - 1) {
      const auto g = i * task::kWordBits + static_cast<std::size_t>(__builtin_ctzll(fresh));
      task::setBit(row(static_cast<FactId>(g)), f);
    }
  }
  return changed;
}

/// Applies the parts until no new pair turns up.
class MutexTable::Fixpoint {
 public:
  Fixpoint(MutexTable& table, const task::Task& task, const Limits& limits)
      : table_(table),
        monitor_(limits),
        parts_(partsOf(task, monitor_)),
        needed_by_(task.facts.size()),
        work_(parts_.size()),
        after_(table.words_) {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      poll();
      work_.push(i);
      FactSet needed = parts_[i].precondition;
      for (const ConditionalEffect* effect : parts_[i].may)
        needed = task::unite(needed, effect->condition);
      if (parts_[i].precondition.empty()) without_precondition_.push_back(i);
      for (const FactId fact : needed)
        needed_by_[fact].push_back(i);
    }
  }

  /// False when it would take too long.
  bool run() {
    while (!work_.empty()) {
      if (steps_ > kMaxSteps) return false;
      poll();
      const Part& part = parts_[work_.pop()];
      if (!possible_[&part - parts_.data()] && table_.contains(part.precondition)) continue;
      possible_[&part - parts_.data()] = true;
      table_.applicable_[part.op] = true;
      possibleAfter(part);
      if (!reachAdded(part)) continue;
      for (const std::uint32_t user : without_precondition_)
        work_.push(user);
    }
    return true;
  }

 private:
  void poll() { pollOrThrow(monitor_, "the mutex table"); }

  /// What may be true right after the part: what may stand beside its precondition, but for the
  /// deletes, and the adds.
  void possibleAfter(const Part& part) {
    if (part.precondition.empty()) {
      after_.assign(table_.words_, 0);
      for (FactId fact = 0; fact < table_.fact_count_; ++fact) {
        if (!table_.mutex(fact, fact)) task::setBit(after_.data(), fact);
      }
    } else {
      after_.assign(table_.words_, ~Word{0});
    }
    for (const FactId fact : part.precondition) {
      for (std::size_t i = 0; i < table_.words_; ++i)
        after_[i] &= table_.row(fact)[i];
    }
    added_ = part.add;
    for (const ConditionalEffect* effect : part.may) {
      if (!table_.contains(task::unite(part.precondition, effect->condition)))
        added_ = task::unite(added_, effect->add);
    }
    for (const FactId fact : part.del)
      task::clearBit(after_.data(), fact);
    for (const FactId fact : added_)
      task::setBit(after_.data(), fact);
    steps_ += table_.words_ * (part.precondition.size() + part.add.size() + 1);
  }

  /// True when a pair was news. One {f, g} is news for the parts that need f, and those that need
  /// g.
  bool reachAdded(const Part& part) {
    const auto news = [this](std::size_t fact) {
      for (const std::uint32_t user : needed_by_[fact])
        work_.push(user);
    };
    bool any = false;
    for (const FactId fact : part.add) {
      before_.assign(table_.row(fact), table_.row(fact) + table_.words_);
      if (!table_.reachTogether(fact, after_)) continue;
      any = true;
      news(fact);
      for (std::size_t i = 0; i < table_.words_; ++i)
        before_[i] = table_.row(fact)[i] & ~before_[i];
      task::forEachBit(before_.data(), table_.words_, news);
    }
    return any;
  }

  MutexTable& table_;
  LimitMonitor monitor_;
  std::vector<Part> parts_;
  std::vector<bool> possible_ = std::vector<bool>(parts_.size(), false);
  std::vector<std::vector<std::uint32_t>> needed_by_;
  std::vector<std::uint32_t> without_precondition_;
  WorkList work_;
  std::vector<Word> after_;
  std::vector<Word> before_;
  FactSet added_;
  std::uint64_t steps_ = 0;
};

MutexTable::MutexTable(const task::Task& task, const Limits& limits)
    : fact_count_(task.facts.size()),
      words_(task::wordsFor(task.facts.size())),
      applicable_(task.operators.size(), false) {
  if (words_ * fact_count_ * sizeof(Word) <= std::min(kMaxBytes, limits.bytes / 4)) {
    together_.assign(words_ * fact_count_, 0);
    const task::State initial = task::initialState(task);
    for (const FactId fact : task.initial)
      reachTogether(fact, initial);
    if (!Fixpoint(*this, task, limits).run()) together_.clear();
  }
  if (!known()) applicable_.assign(task.operators.size(), true);
}

task::Task MutexTable::withoutInapplicable(task::Task task) const {
  std::size_t kept = 0;
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    if (!applicable_[op]) continue;
    if (kept != op) task.operators[kept] = std::move(task.operators[op]);
    ++kept;
  }
  task.operators.resize(kept);
  return task;
}

bool MutexTable::contains(const FactSet& facts, FactSet* pair) const {
  if (!known()) return false;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    for (std::size_t j = i; j < facts.size(); ++j) {
      if (!mutex(facts[i], facts[j])) continue;
      if (pair != nullptr) *pair = i == j ? FactSet{facts[i]} : FactSet{facts[i], facts[j]};
      return true;
    }
  }
  return false;
}

bool MutexTable::rulesOut(const task::Goal& goal) const {
  return std::all_of(goal.alternatives.begin(), goal.alternatives.end(),
                     [this](const FactSet& alternative) { return contains(alternative); });
}

}  // namespace goal_alignment::heuristics
