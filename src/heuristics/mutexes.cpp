// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/mutexes.h"

#include <deque>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::heuristics {

using task::FactId;
using task::FactSet;
using task::OperatorId;
using task::Word;

namespace {

/// Operators waiting for another look, each at most once.
class WorkList {
 public:
  explicit WorkList(std::size_t operators) : waiting_(operators, false) {}

  void push(OperatorId op) {
    if (waiting_[op]) return;
    waiting_[op] = true;
    queue_.push_back(op);
  }
  bool empty() const { return queue_.empty(); }
  OperatorId pop() {
    const OperatorId op = queue_.front();
    queue_.pop_front();
    waiting_[op] = false;
    return op;
  }

 private:
  std::vector<bool> waiting_;
  std::deque<OperatorId> queue_;
};

void checkMemory(std::size_t bytes, const Limits& limits) {
  if (bytes > limits.bytes) throw LimitReached(LimitReason::Memory, "the mutex table");
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

MutexTable::MutexTable(const task::Task& task, const Limits& limits)
    : fact_count_(task.facts.size()),
      words_(task::wordsFor(task.facts.size())),
      applicable_(task.operators.size(), false) {
  checkMemory(words_ * task.facts.size() * sizeof(Word), limits);
  together_.assign(words_ * task.facts.size(), 0);
  std::vector<std::vector<OperatorId>> needed_by(task.facts.size());
  std::vector<OperatorId> without_precondition;
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    if (task.operators[op].precondition.empty()) without_precondition.push_back(op);
    for (const FactId fact : task.operators[op].precondition)
      needed_by[fact].push_back(op);
  }

  const task::State initial = task::initialState(task);
  for (const FactId fact : task.initial)
    reachTogether(fact, initial);

  LimitMonitor monitor(limits);
  WorkList work(task.operators.size());
  for (OperatorId op = 0; op < task.operators.size(); ++op)
    work.push(op);
  std::vector<Word> after(words_);
  while (!work.empty()) {
    if (const LimitReason reason = monitor.poll(); reason != LimitReason::None) {
      throw LimitReached(reason, "the mutex table");
    }
    const OperatorId id = work.pop();
    const task::Operator& op = task.operators[id];
    if (!applicable_[id] && contains(op.precondition)) continue;
    applicable_[id] = true;
    possibleAfter(op, after);
    // A pair {f, g} is news for the operators that need f, and for those that need g.
    const auto news = [&](std::size_t fact) {
      for (const OperatorId user : needed_by[fact])
        work.push(user);
    };
    bool any = false;
    for (const FactId fact : op.add) {
      const std::vector<Word> before(row(fact), row(fact) + words_);
      if (!reachTogether(fact, after)) continue;
      any = true;
      news(fact);
      std::vector<Word> fresh(row(fact), row(fact) + words_);
      for (std::size_t i = 0; i < words_; ++i)
        fresh[i] &= ~before[i];
      task::forEachBit(fresh.data(), words_, news);
    }
    if (any) {
      for (const OperatorId user : without_precondition)
        work.push(user);
    }
  }
}

/// What may be true right after the operator: what may stand beside its precondition, but for the
/// deletes, and the adds.
void MutexTable::possibleAfter(const task::Operator& op, std::vector<Word>& after) const {
  if (op.precondition.empty()) {
    after.assign(words_, 0);
    for (FactId fact = 0; fact < fact_count_; ++fact) {
      if (!mutex(fact, fact)) task::setBit(after.data(), fact);
    }
  } else {
    after.assign(words_, ~Word{0});
  }
  for (const FactId fact : op.precondition) {
    for (std::size_t i = 0; i < words_; ++i)
      after[i] &= row(fact)[i];
  }
  for (const FactId fact : op.del)
    task::clearBit(after.data(), fact);
  for (const FactId fact : op.add)
    task::setBit(after.data(), fact);
}

task::Task MutexTable::withoutInapplicable(task::Task task) const {
  std::vector<task::Operator> kept;
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    if (applicable_[op]) kept.push_back(std::move(task.operators[op]));
  }
  task.operators = std::move(kept);
  return task;
}

bool MutexTable::contains(const FactSet& facts, FactSet* pair) const {
  for (std::size_t i = 0; i < facts.size(); ++i) {
    for (std::size_t j = i; j < facts.size(); ++j) {
      if (!mutex(facts[i], facts[j])) continue;
      if (pair != nullptr) *pair = i == j ? FactSet{facts[i]} : FactSet{facts[i], facts[j]};
      return true;
    }
  }
  return false;
}

}  // namespace goal_alignment::heuristics
