// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// Asks inside the live conflict with the highest P(all of it wanted) / E[questions until that is
/// known], and there the candidate least likely to be wanted; among equals the one in the most
/// live conflicts. Optimal where conflicts are disjoint (Boros & Ünlüyurt, "Diagnosing double
/// regular systems", 1999); a good guess where they are not. O(total size of the conflicts).
class RatioPolicy : public Policy {
 public:
  explicit RatioPolicy(const PolicyContext& context) : random_(context.seed) {}
  std::optional<Choice> next(const Situation& situation) override;
  bool usesConflicts() const override { return true; }

 private:
  RandomSource random_;
};

}  // namespace goal_alignment::questions
