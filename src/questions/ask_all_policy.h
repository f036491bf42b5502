// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// The naive upper bound that the paper compares with: every candidate in order, until the outcome
/// is certain.
class AskAllPolicy : public Policy {
 public:
  explicit AskAllPolicy(PolicyContext context) : context_(std::move(context)) {}
  std::optional<Choice> next(const Situation& situation) override;
  bool usesConflicts() const override { return false; }

 private:
  PolicyContext context_;
};

}  // namespace goal_alignment::questions
