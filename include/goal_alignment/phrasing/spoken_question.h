// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/phrasing/vocabulary.h"

namespace goal_alignment::phrasing {

/// One question in a spoken dialogue: what the robot says next, given what it hears or does not
/// hear. After `retries` of either kind it falls silent, and still understands a clear answer.
class SpokenQuestion {
 public:
  /// `text` asks about all of `offered`, `why` may be empty. `vocabulary` outlives this.
  SpokenQuestion(const Vocabulary& vocabulary, const std::string& text, std::string why,
                 std::vector<std::string> offered, int retries);

  /// What the person's words lead to.
  struct Turn {
    std::optional<Reply> reply;  ///< the question is answered
    std::string say;             ///< else what to say; empty: nothing
  };

  /// The question as it is said: of several things each with its number.
  const std::string& asked() const { return asked_; }

  Turn hear(const std::string& said);

  /// For as long as one waits for an answer nothing was heard: the question again, or nothing.
  std::string silence();

 private:
  const Vocabulary& vocabulary_;
  std::string asked_;
  std::string why_;
  std::vector<std::string> offered_;
  int misunderstandings_left_;
  int silences_left_;
};

}  // namespace goal_alignment::phrasing
