// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "goal_alignment/questions/policy.h"

/// Dialogues by brute force: every order of questions, every combination of answers.
namespace goal_alignment::oracles {

/// Every conflict is hit by a NO, or one that is not has no open candidate left.
bool hasEnded(const questions::Situation& situation);

/// The least expected number of questions from here and from every situation that answers of YES
/// and NO lead to, with independent answers. O(3^open · conflicts).
class BestDialogue {
 public:
  explicit BestDialogue(questions::Situation situation) : situation_(std::move(situation)) {}

  double cost(const std::vector<questions::Knowledge>& knowledge);
  /// Of asking this candidate first.
  double costOf(std::vector<questions::Knowledge> knowledge, std::size_t candidate);

 private:
  questions::Situation situation_;
  std::map<std::vector<questions::Knowledge>, double> known_;
};

}  // namespace goal_alignment::oracles
