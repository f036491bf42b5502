// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::phrasing {

/// What a person said to a question. Numbers as in the ROS message Answer.
struct Reply {
  enum class Kind : std::int8_t { No = 0, Yes = 1, Unsure = 2, Decline = 3 };
  Kind kind = Kind::No;
  std::vector<std::size_t> chosen;  ///< of several fluents, those that matter; empty: `kind` is
                                    ///< said of all of them
};

/// Reads "y", "yes", "n", "no", "none", "?", "don't know", "d", "decline" and the like, or what the
/// language has instead, without case and accents; of several fluents also "all", and numbers
/// counted from 1, "1 3" or "1,3". Nothing where it is something else.
std::optional<Reply> parseReply(const std::string& line, std::size_t fluents,
                                const Frames& frames = *Frames::english());

/// The words that parseReply() takes, for a prompt: "y = yes, n = no, …".
std::string replyKeys(std::size_t fluents, const Frames& frames = *Frames::english());

/// A question that somebody answers in a terminal.
struct AskedInTerminal {
  std::size_t number = 1;
  std::string person;             ///< may be empty
  std::size_t max_remaining = 1;  ///< at most so many questions, this one included
  bool bound_is_provisional = false;
  std::string text;
};

/// "Question 2 for Ada (at most one more after it): Does it …?"
std::string questionLine(const AskedInTerminal& asked, const Phrases& phrases);

}  // namespace goal_alignment::phrasing
