// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/reply.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::phrasing {

namespace {

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "1 3" or "1,3"; nothing where there is anything else, or a number out of range.
std::optional<std::vector<std::size_t>> parseNumbers(std::string text, std::size_t count) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  std::vector<std::size_t> indices;
  for (std::size_t number = 0; in >> number;) {
    if (number < 1 || number > count) return std::nullopt;
    const bool again = std::count(indices.begin(), indices.end(), number - 1) > 0;
    if (!again) indices.push_back(number - 1);
  }
  if (!in.eof() || indices.empty()) return std::nullopt;
  return indices;
}

}  // namespace

std::optional<Reply> parseReply(const std::string& line, std::size_t fluents) {
  const std::string word = toLower(trimmed(line));
  const bool several = fluents > 1;
  if (isOneOf(word, {"y", "yes"}) || (several && word == "all")) return Reply{Reply::Kind::Yes, {}};
  if (isOneOf(word, {"n", "no"}) || (several && word == "none")) return Reply{Reply::Kind::No, {}};
  if (isOneOf(word, {"?", "u", "unsure", "don't know", "dont know", "i don't know"}))
    return Reply{Reply::Kind::Unsure, {}};
  if (isOneOf(word, {"d", "decline"})) return Reply{Reply::Kind::Decline, {}};
  if (!several) return std::nullopt;
  auto numbers = parseNumbers(word, fluents);
  if (!numbers) return std::nullopt;
  return Reply{Reply::Kind::Yes, std::move(*numbers)};
}

std::string replyKeys(std::size_t fluents) {
  if (fluents > 1) {
    return "the numbers of those that matter, n = none, y = all, ? = don't know, "
           "d = no more questions";
  }
  return "y = yes, n = no, ? = don't know, d = no more questions";
}

}  // namespace goal_alignment::phrasing
