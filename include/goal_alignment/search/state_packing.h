// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/task/state.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// How states are written down: of every mutex group the number of the fact that is true, in as few
/// bits as that takes (Edelkamp & Helmert, "Exhibiting Knowledge in Planning Problems to Minimize
/// State Encoding Length", ECP 1999). Exact for reachable states.
class StatePacking {
 public:
  /// The task must outlive this. Throws LimitReached.
  StatePacking(const task::Task& task, const heuristics::MutexGroups& groups,
               const Limits& limits = {});

  /// Words of a packed state, at least one.
  std::size_t words() const { return words_; }

  void pack(const task::Word* state, task::Word* packed) const;
  /// O(groups + words of a state).
  void unpack(const task::Word* packed, task::Word* state) const;

  /// Writes the packed state after the operator. O(words + effects), and with conditional effects
  /// O(groups).
  void apply(task::OperatorId op, const task::Word* packed, task::Word* successor) const;

  /// A goal as it shows in packed states.
  class Goal {
   public:
    bool holdsIn(const task::Word* packed) const {
      for (const std::vector<Field>& alternative : alternatives_) {
        bool holds = true;
        for (const Field& field : alternative)
          holds = holds && (packed[field.word] & field.mask) == field.value;
        if (holds) return true;
      }
      return false;
    }

   private:
    friend class StatePacking;
    struct Field {
      std::uint32_t word;
      task::Word mask;
      task::Word value;
    };
    std::vector<std::vector<Field>> alternatives_;
  };
  Goal goal(const task::Goal& goal) const;

 private:
  /// Where a group stands.
  struct Place {
    std::uint32_t word;
    std::uint32_t shift;
    task::Word mask;  // in place
  };
  /// What an operator without conditional effects does to one group.
  struct Change {
    std::uint32_t word;
    bool always;
    task::Word mask;
    task::Word from;  // unless always: it applies to this value alone
    task::Word to;
  };

  void placeGroups(LimitMonitor& monitor);
  void addChanges(const task::Operator& op);
  task::Word value(task::FactId fact) const;
  task::Word none(std::size_t group) const;

  const task::Task& task_;
  heuristics::MutexGroups groups_;
  std::size_t words_ = 1;
  std::size_t state_words_;
  std::vector<Place> places_;                // by group
  std::vector<std::uint32_t> change_begin_;  // by operator, and one more
  std::vector<Change> changes_;
};

}  // namespace goal_alignment::search
