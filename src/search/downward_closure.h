// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "goal_alignment/search/decision_diagram.h"

namespace goal_alignment::search {

/// How the values of one level are seen.
struct LevelView {
  using Value = DecisionDiagram::Value;
  static constexpr Value kHidden = static_cast<Value>(-1);

  std::vector<Value> seen_as;  ///< by value; kHidden: vectors with it are left out
  Value values = 1;            ///< how many they are seen as; where it is one the level is dropped
};

/// The set of vectors as seen through the views, and all that is below it: a vector is below
/// another that it becomes by setting some of its values to 0. In `target`, which has a level for
/// each that is not dropped. Throws LimitReached.
DecisionDiagram::Node closedBelow(const DecisionDiagram& source, DecisionDiagram::Node set,
                                  const std::vector<LevelView>& views, DecisionDiagram& target);

/// The minimal ones of the vectors that are not in a set that is closed below. Recursive, as
/// Knuth's operations on families of sets are (The Art of Computer Programming 4A, 7.1.4). Throws
/// LimitReached.
DecisionDiagram::Node minimalOutside(DecisionDiagram& diagram, DecisionDiagram::Node closed);

/// Visits the vectors of a set until that returns false.
using VisitVector = std::function<bool(const std::vector<DecisionDiagram::Value>&)>;
bool forEachVector(const DecisionDiagram& diagram, DecisionDiagram::Node set,
                   const VisitVector& visit);

}  // namespace goal_alignment::search
