// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::cli {

/// While one lives, Ctrl-C and SIGTERM cancel what it was given instead of ending the process; a
/// second one ends it. One at a time.
class InterruptGuard {
 public:
  explicit InterruptGuard(session::Session& session);
  explicit InterruptGuard(CancelToken& token);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace goal_alignment::cli
