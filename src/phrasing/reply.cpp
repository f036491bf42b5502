// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/reply.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/folding.h"

namespace goal_alignment::phrasing {

namespace {

/// The text called `name` lists words with commas between.
bool isOneOf(const std::string& word, const Frames& frames, const std::string& name) {
  std::istringstream words(frames.fill(name));
  for (std::string each; std::getline(words, each, ',');) {
    if (folded(trimmed(each)) == word) return true;
  }
  return false;
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

std::optional<Reply> parseReply(const std::string& line, std::size_t fluents,
                                const Frames& frames) {
  const std::string word = folded(trimmed(line));
  const bool several = fluents > 1;
  const auto is = [&](const char* name) { return isOneOf(word, frames, name); };
  if (is("reply_yes") || (several && is("reply_all"))) return Reply{Reply::Kind::Yes, {}};
  if (is("reply_no") || (several && is("reply_none"))) return Reply{Reply::Kind::No, {}};
  if (is("reply_unsure")) return Reply{Reply::Kind::Unsure, {}};
  if (is("reply_decline")) return Reply{Reply::Kind::Decline, {}};
  if (!several) return std::nullopt;
  auto numbers = parseNumbers(word, fluents);
  if (!numbers) return std::nullopt;
  return Reply{Reply::Kind::Yes, std::move(*numbers)};
}

std::string replyKeys(std::size_t fluents, const Frames& frames) {
  return frames.fill(fluents > 1 ? "ask_keys_several" : "ask_keys");
}

std::string questionLine(const AskedInTerminal& asked, const Phrases& phrases) {
  // A bound that may still change is none.
  const std::string left = asked.bound_is_provisional ? phrases.say("ask_left_unknown")
                           : asked.max_remaining < 2
                               ? phrases.say("ask_last")
                               : phrases.counted("ask_left", asked.max_remaining - 1);
  std::vector<std::string> parts = {std::to_string(asked.number), left, asked.text};
  if (asked.person.empty()) return phrases.say("ask", parts);
  parts.push_back(asked.person);
  return phrases.say("ask_for", parts);
}

}  // namespace goal_alignment::phrasing
