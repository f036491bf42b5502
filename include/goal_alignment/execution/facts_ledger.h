// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/execution/precondition_monitor.h"

namespace goal_alignment::execution {

/// What the steps have changed, for the aligner to know. What can't be told waits until it can be,
/// also when the plan has ended; an aligner that was started anew while a plan runs is told again
/// what it was told in this run. Not thread-safe.
class FactsLedger {
 public:
  explicit FactsLedger(AlignerLink& aligner) : aligner_(aligner) {}

  /// A plan begins. What earlier ones have told is forgotten, what they could not tell is not.
  void beginRun();

  /// These are so now, and are told unless the aligner does not answer.
  void enter(const std::vector<Literal>& changes);

  /// Tells what waits; false: it goes on waiting.
  bool tell();
  /// Tells all of this run once more: the aligner has begun with other facts.
  void tellAgain();
  bool waits() const;

  /// What is so says the aligner: what others have changed since is not told again.
  void compare(const WorldState& world);

 private:
  struct Entry {
    bool holds = false;
    bool told = false;
  };

  void noticeRestart(const std::string& life);

  AlignerLink& aligner_;
  std::map<GroundName, Entry> entries_;
  std::string life_;          // of the aligner that was told last
  bool is_lamented_ = false;  // that it does not answer
};

}  // namespace goal_alignment::execution
