// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/Explain.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// "What if these were all wanted?", understood.
struct WhatIfQuery {
  std::vector<Literal> wanted;
  std::vector<Literal> not_wanted;
  std::string refusal;  ///< why it can't be supposed; empty: it can
};

/// A fluent that is no candidate, while its negation is one, stands for that not being wanted.
/// Fluents that were asked for are wanted anyway.
WhatIfQuery supposition(const std::vector<Literal>& fluents, const session::Snapshot& snapshot,
                        const phrasing::Phrases& phrases);

/// "If it mattered that …: I would have a plan of 7 steps." `then` is how things stand after the
/// session has thought about it. The consequence is known.
Explain::Response explainConsequence(const WhatIfQuery& supposed,
                                     const session::Consequence& consequence,
                                     const session::Snapshot& then,
                                     const phrasing::Phrases& phrases);

/// What is said where nothing else can be.
Explain::Response notKnownYet(const phrasing::Phrases& phrases);

/// Suppositions on their way to the solver thread, which alone can think about them, and back.
/// Thread-safe.
class SuppositionQueue {
 public:
  using Clock = std::chrono::steady_clock;
  /// Nothing: it is not known yet, but more thought may help. What it throws becomes the answer.
  using Solve = std::function<std::optional<Explain::Response>(const std::vector<Literal>&)>;

  /// `wakeUp` tells the solver thread that there is something to think about.
  explicit SuppositionQueue(std::function<void()> wakeUp = {});

  /// Waits for the answer, or until the deadline: then nothing, and nobody thinks about it any
  /// more.
  std::optional<Explain::Response> ask(const std::vector<Literal>& fluents,
                                       Clock::time_point deadline);

  // Of the solver thread.

  bool empty() const;
  /// Answers the oldest. What is not known yet is tried again after all others, as long as its
  /// asker waits.
  void answerOne(const Solve& solve);

 private:
  struct Job {
    std::vector<Literal> fluents;
    std::optional<Explain::Response> response;
    bool given_up = false;
  };

  static std::optional<Explain::Response> attempt(const Solve& solve,
                                                  const std::vector<Literal>& fluents);

  const std::function<void()> nudge_;
  mutable std::mutex mutex_;  // guards all below
  std::condition_variable answered_;
  std::list<std::shared_ptr<Job>> jobs_;
};

}  // namespace goal_alignment::aligner
