// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// The published Algorithm 1 to the letter: one queue over S^H
/// \ G^H by falling V^Q, ties at random. Its stopping tests are the session's own.
class PaperPolicy : public Policy {
 public:
  explicit PaperPolicy(PolicyContext context) : context_(std::move(context)) {}
  std::optional<Choice> next(const Situation& situation) override;
  bool usesConflicts() const override { return false; }

 private:
  void fillQueue();

  PolicyContext context_;
  bool queue_filled_ = false;
  std::vector<std::size_t> queue_;  // the next question stands last
};

/// V^Q(f) = p(f)·Ṽ(f ∈ G*) + (1 − p(f))·Ṽ(f ∉ G*), the lower bound of section 4, for every
/// candidate.
std::vector<double> valueOfQuery(const std::vector<double>& belief,
                                 const std::vector<bool>& unachievable_alone);

}  // namespace goal_alignment::questions
