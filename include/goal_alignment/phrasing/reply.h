// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::phrasing {

/// What a person said to a question. Numbers as in the ROS message Answer.
struct Reply {
  enum class Kind : std::int8_t { No = 0, Yes = 1, Unsure = 2, Decline = 3 };
  Kind kind = Kind::No;
  std::vector<std::size_t> chosen;  ///< of several fluents, those that matter; empty: `kind` is
                                    ///< said of all of them
};

/// Reads "y", "yes", "n", "no", "none", "?", "don't know", "d", "decline" and the like without
/// case; of several fluents also "all", and numbers counted from 1, "1 3" or "1,3". Nothing where
/// it is something else.
std::optional<Reply> parseReply(const std::string& line, std::size_t fluents);

/// The words that parseReply() takes, for a prompt: "y = yes, n = no, …".
std::string replyKeys(std::size_t fluents);

}  // namespace goal_alignment::phrasing
