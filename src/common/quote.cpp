// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/quote.h"

namespace goal_alignment {

namespace {

constexpr std::size_t kLongestQuote = 60;

/// Bytes that a character takes by its first one; 0 where none begins like that.
std::size_t lengthByLead(unsigned lead) {
  if (lead < 0x80U) return 1;
  if (lead >= 0xC2U && lead <= 0xDFU) return 2;
  if (lead >= 0xE0U && lead <= 0xEFU) return 3;
  return lead >= 0xF0U && lead <= 0xF4U ? 4 : 0;
}

}  // namespace

std::size_t utf8CharacterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = lengthByLead(byte(0));
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  if (length < 3) return length;
  // Longer than need be, half a surrogate pair, beyond U+10FFFF.
  const unsigned first_two = byte(0) << 8U | byte(1);
  const bool wrong = (first_two >= 0xE080U && first_two < 0xE0A0U) ||
                     (first_two >= 0xEDA0U && first_two < 0xEE80U) ||
                     (first_two >= 0xF080U && first_two < 0xF090U) || first_two >= 0xF490U;
  return wrong ? 0 : length;
}

std::size_t utf8Length(std::string_view text, std::size_t most) {
  std::size_t length = 0;
  while (length < text.size()) {
    const std::size_t next = utf8CharacterLength(text.substr(length));
    if (next == 0 || length + next > most) break;
    length += next;
  }
  return length;
}

std::string shortened(std::string_view text, std::size_t most) {
  const std::size_t length = utf8Length(text, most);
  return std::string(text.substr(0, length)) + (length < text.size() ? "…" : "");
}

std::string inQuotes(std::string_view text) {
  return "'" + shortened(text, kLongestQuote) + "'";
}

}  // namespace goal_alignment
