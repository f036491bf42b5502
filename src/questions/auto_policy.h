// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimal_policy.h"

namespace goal_alignment::questions {

/// The default: OptimalPolicy with so little work per decision that nobody notices the wait.
class AutoPolicy : public OptimalPolicy {
 public:
  /// About 20 ms, and less than 50 ms on a busy machine.
  static constexpr std::uint64_t kWork = 2'000'000;

  explicit AutoPolicy(const PolicyContext& context) : OptimalPolicy(context, kWork) {}
};

}  // namespace goal_alignment::questions
