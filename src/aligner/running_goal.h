// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include "goal_alignment/session/session.h"
#include "goal_ticket.h"

namespace goal_alignment::aligner {

/// The goal whose session runs. It ends by its outcome or by a cancel, never by both. Thread-safe.
class RunningGoal {
 public:
  /// Of the solver thread.
  void begin(const GoalTicket& ticket, std::shared_ptr<session::Session> session);
  void end();
  /// Claims the goal for its outcome. False: a cancel was faster; the session then has ended as
  /// well and can be continued. Of the solver thread.
  bool claimOutcome(GoalTicket& ticket);

  /// Claims the goal, running or not, for a cancel, and cancels its session if it runs. False: the
  /// goal has ended already. Of any thread.
  bool cancel(GoalTicket& ticket);

 private:
  std::mutex mutex_;                    // guards the two below, and claims
  const GoalTicket* ticket_ = nullptr;  // null: none runs, or its outcome is known
  std::shared_ptr<session::Session> session_;
};

}  // namespace goal_alignment::aligner
