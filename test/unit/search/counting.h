// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/task/task.h"

/// Tasks whose conflicts are matters of counting: no pair of goals shows them.
namespace goal_alignment::search::samples {

/// Pigeons that move into holes, one into each, and out again.
struct Pigeonholes {
  Pigeonholes(std::size_t pigeons, std::size_t holes) {
    for (std::size_t hole = 0; hole < holes; ++hole)
      task.initial.push_back(newFact());
    for (std::size_t pigeon = 0; pigeon < pigeons; ++pigeon) {
      const task::FactId outside = newFact();
      task.initial.push_back(outside);
      housed.push_back(newFact());
      for (task::FactId hole = 0; hole < holes; ++hole) {
        const task::FactId inside = newFact();
        task.operators.push_back(
            {{"in", {}}, {hole, outside}, {housed.back(), inside}, {hole, outside}, 1});
        task.operators.push_back(
            {{"out", {}}, {inside}, {hole, outside}, {housed.back(), inside}, 1});
      }
    }
  }

  task::Task task;
  task::FactSet housed;  ///< by pigeon: it is in some hole

 private:
  task::FactId newFact() {
    task.facts.emplace_back();
    return static_cast<task::FactId>(task.facts.size() - 1);
  }
};

}  // namespace goal_alignment::search::samples
