// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimal_policy.h"

namespace goal_alignment::questions {

/// The default: OptimalPolicy with so little work for one decision that nobody waits for it.
class AutoPolicy : public OptimalPolicy {
 public:
  /// Less than 50 ms.
  static constexpr std::uint64_t kWork = 3'000'000;

  explicit AutoPolicy(const Setting& setting) : OptimalPolicy(setting, kWork) {}
};

}  // namespace goal_alignment::questions
