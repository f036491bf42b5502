// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::questions {

/// Why the answer about a fluent matters.
struct Reason {
  std::vector<Literal> conflict;  ///< a live conflict with the fluent; may be empty under the
                                  ///< policies `paper` and `ask-all`
  bool proven = false;            ///< false: "I could not make sure …"
  std::int64_t extra_cost = 0;    ///< without a conflict: keeping the fluent costs so much more
  bool alone = false;             ///< proven: the conflict's one fluent can't be had whatever else
                                  ///< is asked for

  friend bool operator==(const Reason& a, const Reason& b) {
    return a.conflict == b.conflict && a.proven == b.proven && a.extra_cost == b.extra_cost;
  }
};

}  // namespace goal_alignment::questions
