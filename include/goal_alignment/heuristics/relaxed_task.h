// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::heuristics {

constexpr task::Cost kInfinity = std::numeric_limits<task::Cost>::max();

/// Rows of small integers side by side in one array.
class Rows {
 public:
  /// Row i holds what `rows[i]` held.
  explicit Rows(const std::vector<std::vector<std::uint32_t>>& rows = {});

  struct Row {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Row operator[](std::size_t i) const {
    return {values_.data() + starts_[i], values_.data() + starts_[i + 1]};
  }
  std::size_t size(std::size_t i) const { return starts_[i + 1] - starts_[i]; }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> values_;
};

/// The task without deletes, for one goal, with what is irrelevant to the goal left out.
///
/// Facts keep their FactId; two are added: `goal_fact`, made true by the goal operators (cost 0,
/// one for each of the goal's alternatives), and `true_fact`, which holds always and stands in for
/// empty preconditions, so that every operator has a precondition. An operator with conditional
/// effects is taken apart into one relaxed operator for each effect that adds: whoever adds up
/// costs must count the parts of one origin once.
struct RelaxedTask {
  /// Throws LimitReached.
  RelaxedTask(const task::Task& task, const task::Goal& goal, const Limits& limits = {});

  std::size_t fact_count = 0;      ///< with the two artificial ones
  std::size_t operator_count = 0;  ///< parts of relevant ones, then the goal operators
  task::FactId true_fact = 0;
  task::FactId goal_fact = 0;
  std::uint32_t first_goal_operator = 0;
  bool several_parts = false;            ///< of any one operator
  std::vector<task::OperatorId> origin;  ///< the task's operator; the goal operators have none
  std::vector<task::Cost> cost;
  Rows parts;            ///< the task's operator → its relaxed operators
  Rows preconditions;    ///< operator → facts
  Rows effects;          ///< operator → facts
  Rows precondition_of;  ///< fact → operators
  Rows effect_of;        ///< fact → operators
};

}  // namespace goal_alignment::heuristics
