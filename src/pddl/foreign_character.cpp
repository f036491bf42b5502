// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_character.h"

#include <algorithm>
#include <array>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::pddl {

namespace {

/// Characters from `first` to `last` that stand in no name.
struct Refused {
  char32_t first;
  char32_t last;
  const char* what;
};

constexpr const char* kBlank = "a blank other than ' '";
constexpr const char* kDash = "a dash other than '-'";
constexpr const char* kBracket = "a bracket other than '(' and ')'";
constexpr const char* kQuote = "a quotation mark";
constexpr const char* kUnseen = "a character that nobody sees";

constexpr std::array<Refused, 20> kRefused{{
    {0x80, 0x9F, kUnseen},
    {0xA0, 0xA0, kBlank},
    {0xAB, 0xAB, kQuote},
    {0xAD, 0xAD, kUnseen},
    {0xBB, 0xBB, kQuote},
    {0x2000, 0x200B, kBlank},
    {0x200E, 0x200F, kUnseen},
    {0x2010, 0x2015, kDash},
    {0x2018, 0x201F, kQuote},
    {0x2028, 0x202E, kUnseen},
    {0x202F, 0x202F, kBlank},
    {0x205F, 0x205F, kBlank},
    {0x2060, 0x206F, kUnseen},
    {0x2212, 0x2212, kDash},
    {0x3000, 0x3000, kBlank},
    {0xFEFF, 0xFEFF, kUnseen},
    {0xFF08, 0xFF09, kBracket},
    {0xFF0D, 0xFF0D, kDash},
    {0xFF1B, 0xFF1B, "a semicolon other than ';'"},
    {0xFFFD, 0xFFFF, "what stands for a letter that got lost"},
}};

/// Of one well-formed character beyond ASCII.
char32_t codePoint(std::string_view character) {
  // The lead byte has as many bits less as there are bytes.
  char32_t code = static_cast<unsigned char>(character.front()) & (0xFFU >> (character.size() + 1));
  for (const char next : character.substr(1))
    code = code << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  return code;
}

const Refused* findRefused(std::string_view character) {
  const char32_t code = codePoint(character);
  const auto* found = std::find_if(kRefused.begin(), kRefused.end(), [&](const Refused& range) {
    return range.first <= code && code <= range.last;
  });
  return found == kRefused.end() ? nullptr : found;
}

std::string hexadecimal(char32_t number, int digits) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (int i = digits - 1; i >= 0; --i)
    text += kDigits[number >> (4U * static_cast<unsigned>(i)) & 15U];
  return text;
}

/// Latin-1's letters are Unicode's first ones.
std::string latin1Letter(unsigned char byte) {
  return {static_cast<char>(0xC0U | byte >> 6U), static_cast<char>(0x80U | (byte & 0x3FU))};
}

bool isUtf16(std::string_view text) {
  const std::string_view mark = text.substr(0, 2);
  return mark == "\xFF\xFE" || mark == "\xFE\xFF";
}

}  // namespace

bool passesForLetter(std::string_view character) {
  return findRefused(character) == nullptr;
}

std::string foreignCharacter(std::string_view text, std::size_t offset) {
  const std::string_view here = text.substr(offset);
  const std::size_t length = utf8CharacterLength(here);
  if (length > 1) {
    const std::string_view character = here.substr(0, length);
    const Refused* refused = findRefused(character);
    return "U+" + hexadecimal(codePoint(character), 4) +
           (refused == nullptr ? "" : std::string(", ") + refused->what);
  }
  const auto byte = static_cast<unsigned char>(here.front());
  std::string found = "the byte 0x" + hexadecimal(byte, 2);
  if (byte < 0x80U) return found;
  if (offset == 0 && isUtf16(text)) return found + "; the text is UTF-16, and UTF-8 is read";
  constexpr unsigned char kFirstLetter = 0xC0;
  return found + ", which is no UTF-8" +
         (byte < kFirstLetter ? "" : "; in Latin-1 it is '" + latin1Letter(byte) + "'");
}

}  // namespace goal_alignment::pddl
