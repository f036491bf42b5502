// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "goal_alignment/Explain.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::ros_interface {

/// What ~explain speaks of: the session as it stood after its last step.
struct Explained {
  session::Snapshot snapshot;
  std::vector<Literal> open_question;  ///< empty: none is open
  std::vector<Literal>
      outcome_conflict;  ///< what the outcome rests on; empty: nothing, or none yet
  phrasing::Phrases phrases;
};

/// Why each fluent is asked, or can't be had, or is of no account. No fluents: why the open
/// question is asked, or the conflict that the outcome rests on. `known` is false as long as the
/// search for conflicts may still bring up a reason.
Explain::Response explainWhy(const Explained& explained, const std::vector<Literal>& fluents);

/// Answers ~explain from what the solver thread showed last; nobody plans for it. Thread-safe.
class Explainer {
 public:
  using Clock = std::chrono::steady_clock;

  /// Of the solver thread, after every step.
  void show(Explained explained);

  /// Waits for at most `patience` until the reason is known.
  Explain::Response explain(const Explain::Request& request,
                            std::chrono::duration<double> patience) const;

 private:
  mutable std::mutex mutex_;  // guards all below
  mutable std::condition_variable shown_;
  std::shared_ptr<const Explained> explained_;  // null: no task yet
};

}  // namespace goal_alignment::ros_interface
