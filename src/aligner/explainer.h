// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "explanation.h"
#include "goal_alignment/Explain.h"
#include "what_if_query.h"

namespace goal_alignment::aligner {

/// Answers ~explain: WHY and WHY_NOT from what the solver thread showed last, so that nobody plans
/// for them; WHAT_IF by asking the solver thread. Thread-safe.
class Explainer {
 public:
  using Clock = std::chrono::steady_clock;

  /// `wakeUp` tells the solver thread of suppositions that wait for it.
  explicit Explainer(std::function<void()> wakeUp = {});

  /// Of the solver thread, after every step.
  void show(ExplanationContext explained);
  SuppositionQueue& suppositions() { return suppositions_; }

  /// Waits for at most `patience` until the answer is known.
  Explain::Response explain(const Explain::Request& request,
                            std::chrono::duration<double> patience);

 private:
  using Speak = Explain::Response (*)(const ExplanationContext&, const std::vector<Literal>&);

  std::shared_ptr<const ExplanationContext> shown() const;
  Explain::Response await(Speak speak, const std::vector<Literal>& fluents,
                          Clock::time_point deadline) const;
  Explain::Response suppose(const std::vector<Literal>& fluents, Clock::time_point deadline);

  SuppositionQueue suppositions_;
  mutable std::mutex mutex_;  // guards all below
  mutable std::condition_variable news_;
  std::shared_ptr<const ExplanationContext> explained_;  // null: no task yet
};

}  // namespace goal_alignment::aligner
