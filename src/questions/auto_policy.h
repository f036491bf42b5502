// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimal_policy.h"

namespace goal_alignment::questions {

/// The default: OptimalPolicy with so little work for one decision that nobody waits for it.
class AutoPolicy : public OptimalPolicy {
 public:
  /// Some 20 ms; less than 50 on a machine that others use, too.
  static constexpr std::uint64_t kWork = 2'000'000;

  explicit AutoPolicy(const PolicyContext& setting) : OptimalPolicy(setting, kWork) {}
};

}  // namespace goal_alignment::questions
