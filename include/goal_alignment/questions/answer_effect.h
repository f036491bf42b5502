// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace goal_alignment::questions {

enum class Knowledge : std::uint8_t;
struct Situation;

/// Where an answer would lead, as far as the known conflicts tell.
struct AnswerEffect {
  enum class Ending : std::uint8_t {
    Open,       ///< more questions follow
    Plan,       ///< no conflict is left: everything else can be had
    NoPlan,     ///< a proven conflict lies within what is wanted
    Undecided,  ///< a conflict is left that no answer settles any more
  };
  Ending ending = Ending::Open;
  std::size_t settled = 0;  ///< other candidates that matter now and would no longer do so
  std::size_t left = 0;     ///< other candidates that may still be asked about afterwards
};

/// What follows when all of `candidates` get this answer. O(conflicts · candidates).
AnswerEffect answerEffect(const Situation& situation, const std::vector<std::size_t>& candidates,
                          Knowledge answer);

}  // namespace goal_alignment::questions
