// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/state_packing.h"

#include <algorithm>
#include <numeric>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::search {

using task::FactId;
using task::Word;

namespace {

std::uint32_t bitsFor(std::uint32_t values) {
  std::uint32_t bits = 0;
  while ((std::uint64_t{1} << bits) < values)
    ++bits;
  return bits;
}

}  // namespace

StatePacking::StatePacking(const task::Task& task, const heuristics::MutexGroups& groups,
                           const Limits& limits)
    : task_(task), groups_(groups), state_words_(task::wordsFor(task.facts.size())) {
  LimitMonitor monitor(limits);
  placeGroups(monitor);
  change_begin_.reserve(task.operators.size() + 1);
  for (const task::Operator& op : task.operators) {
    pollOrThrow(monitor, "preparing the search");
    change_begin_.push_back(static_cast<std::uint32_t>(changes_.size()));
    if (op.conditional.empty()) addChanges(op);
  }
  change_begin_.push_back(static_cast<std::uint32_t>(changes_.size()));
}

/// The widest first, each into the first word that has room for it; none lies across two words.
void StatePacking::placeGroups(LimitMonitor& monitor) {
  const std::size_t count = groups_.groups().size();
  places_.resize(count);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  const auto width = [this](std::uint32_t group) { return bitsFor(groups_.valueCount(group)); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return width(a) > width(b); });
  std::vector<std::uint32_t> used(1, 0);
  std::size_t first_with_room = 0;
  for (const std::uint32_t group : order) {
    pollOrThrow(monitor, "preparing the search");
    const std::uint32_t bits = width(group);
    while (first_with_room < used.size() && used[first_with_room] == task::kWordBits)
      ++first_with_room;
    std::size_t word = first_with_room;
    while (word < used.size() && used[word] + bits > task::kWordBits)
      ++word;
    if (word == used.size()) used.push_back(0);
    const Word mask = ((Word{1} << bits) - 1) << used[word];
    places_[group] = {static_cast<std::uint32_t>(word), used[word], mask};
    used[word] += bits;
  }
  words_ = used.size();
}

/// The fact's number in its group, in place. "None of them" is the number after the last.
Word StatePacking::value(FactId fact) const {
  const auto place = groups_.place(fact);
  return Word{place.value} << places_[place.group].shift;
}

Word StatePacking::none(std::size_t group) const {
  if (groups_.exactlyOne(group)) return 0;  // never asked for in a reachable state
  return Word{groups_.groups()[group].size()} << places_[group].shift;
}

void StatePacking::addChanges(const task::Operator& op) {
  const std::size_t begin = changes_.size();
  std::vector<std::uint32_t> added;
  for (const FactId fact : op.add) {
    const std::uint32_t group = groups_.place(fact).group;
    added.push_back(group);
    changes_.push_back({places_[group].word, true, places_[group].mask, 0, value(fact)});
  }
  for (const FactId fact : op.del) {
    const std::uint32_t group = groups_.place(fact).group;
    if (std::find(added.begin(), added.end(), group) != added.end()) continue;
    if (groups_.exactlyOne(group)) continue;  // then it is false, or another fact comes for it
    const bool needed = std::binary_search(op.precondition.begin(), op.precondition.end(), fact);
    changes_.push_back(
        {places_[group].word, needed, places_[group].mask, value(fact), none(group)});
  }
  std::stable_sort(changes_.begin() + static_cast<std::ptrdiff_t>(begin), changes_.end(),
                   [](const Change& a, const Change& b) { return a.word < b.word; });
}

void StatePacking::pack(const Word* state, Word* packed) const {
  std::fill_n(packed, words_, 0);
  for (std::size_t group = 0; group < places_.size(); ++group) {
    const auto& facts = groups_.groups()[group];
    const auto true_fact = std::find_if(facts.begin(), facts.end(),
                                        [&](FactId fact) { return task::testBit(state, fact); });
    packed[places_[group].word] |= true_fact == facts.end() ? none(group) : value(*true_fact);
  }
}

void StatePacking::unpack(const Word* packed, Word* state) const {
  std::fill_n(state, state_words_, 0);
  for (std::size_t group = 0; group < places_.size(); ++group) {
    const Place& place = places_[group];
    const Word number = (packed[place.word] & place.mask) >> place.shift;
    const auto& facts = groups_.groups()[group];
    if (number < facts.size()) task::setBit(state, facts[number]);
  }
}

void StatePacking::apply(task::OperatorId op, const Word* packed, Word* successor) const {
  if (!task_.operators[op].conditional.empty()) {
    task::State before(state_words_);
    task::State after(state_words_);
    unpack(packed, before.data());
    task::apply(task_.operators[op], before.data(), state_words_, after.data());
    pack(after.data(), successor);
    return;
  }
  std::copy_n(packed, words_, successor);
  for (std::uint32_t i = change_begin_[op]; i < change_begin_[op + 1]; ++i) {
    const Change& change = changes_[i];
    if (!change.always && (packed[change.word] & change.mask) != change.from) continue;
    successor[change.word] = (successor[change.word] & ~change.mask) | change.to;
  }
}

StatePacking::Goal StatePacking::goal(const task::Goal& goal) const {
  Goal packed;
  for (const task::FactSet& alternative : goal.alternatives) {
    packed.alternatives_.emplace_back();
    for (const FactId fact : alternative) {
      const Place& place = places_[groups_.place(fact).group];
      packed.alternatives_.back().push_back({place.word, place.mask, value(fact)});
    }
  }
  return packed;
}

}  // namespace goal_alignment::search
