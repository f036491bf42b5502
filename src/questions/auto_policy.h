// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// The default. Asks only inside live conflicts: the one with the fewest open candidates, there the
/// candidate least likely to be wanted, since a single NO settles the conflict. Among equals the
/// one in most live conflicts, then by the seed.
class AutoPolicy : public Policy {
 public:
  explicit AutoPolicy(const Setting& setting) : random_(setting.seed) {}
  std::optional<Choice> next(const Situation& situation) override;
  bool usesConflicts() const override { return true; }

 private:
  RandomSource random_;
};

}  // namespace goal_alignment::questions
