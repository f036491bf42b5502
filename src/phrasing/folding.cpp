// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/folding.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace goal_alignment::phrasing {

namespace {

/// Letters that one text stands for, by their numbers in Unicode.
struct Letters {
  char32_t first;
  char32_t last;
  const char* plain;
};

/// Sorted. Without a table of all of Unicode: vocabularies are written in the language that is
/// spoken, and these are the letters of those that are written in Latin script.
constexpr std::array<Letters, 86> kLatin = {{
    {0xC0, 0xC5, "a"},     {0xC6, 0xC6, "ae"},    {0xC7, 0xC7, "c"},     {0xC8, 0xCB, "e"},
    {0xCC, 0xCF, "i"},     {0xD0, 0xD0, "d"},     {0xD1, 0xD1, "n"},     {0xD2, 0xD6, "o"},
    {0xD8, 0xD8, "o"},     {0xD9, 0xDC, "u"},     {0xDD, 0xDD, "y"},     {0xDE, 0xDE, "th"},
    {0xDF, 0xDF, "ss"},    {0xE0, 0xE5, "a"},     {0xE6, 0xE6, "ae"},    {0xE7, 0xE7, "c"},
    {0xE8, 0xEB, "e"},     {0xEC, 0xEF, "i"},     {0xF0, 0xF0, "d"},     {0xF1, 0xF1, "n"},
    {0xF2, 0xF6, "o"},     {0xF8, 0xF8, "o"},     {0xF9, 0xFC, "u"},     {0xFD, 0xFD, "y"},
    {0xFE, 0xFE, "th"},    {0xFF, 0xFF, "y"},     {0x100, 0x105, "a"},   {0x106, 0x10D, "c"},
    {0x10E, 0x111, "d"},   {0x112, 0x11B, "e"},   {0x11C, 0x123, "g"},   {0x124, 0x127, "h"},
    {0x128, 0x131, "i"},   {0x132, 0x133, "ij"},  {0x134, 0x135, "j"},   {0x136, 0x138, "k"},
    {0x139, 0x142, "l"},   {0x143, 0x14B, "n"},   {0x14C, 0x151, "o"},   {0x152, 0x153, "oe"},
    {0x154, 0x159, "r"},   {0x15A, 0x161, "s"},   {0x162, 0x167, "t"},   {0x168, 0x173, "u"},
    {0x174, 0x175, "w"},   {0x176, 0x178, "y"},   {0x179, 0x17E, "z"},   {0x17F, 0x17F, "s"},
    {0x1A0, 0x1A1, "o"},   {0x1AF, 0x1B0, "u"},   {0x1CD, 0x1CE, "a"},   {0x1CF, 0x1D0, "i"},
    {0x1D1, 0x1D2, "o"},   {0x1D3, 0x1DC, "u"},   {0x1E6, 0x1E7, "g"},   {0x1E8, 0x1E9, "k"},
    {0x1EA, 0x1ED, "o"},   {0x1F4, 0x1F5, "g"},   {0x1F8, 0x1F9, "n"},   {0x200, 0x203, "a"},
    {0x204, 0x207, "e"},   {0x208, 0x20B, "i"},   {0x20C, 0x20F, "o"},   {0x210, 0x213, "r"},
    {0x214, 0x217, "u"},   {0x218, 0x219, "s"},   {0x21A, 0x21B, "t"},   {0x21E, 0x21F, "h"},
    {0x226, 0x227, "a"},   {0x228, 0x229, "e"},   {0x22A, 0x231, "o"},   {0x232, 0x233, "y"},
    {0x1E20, 0x1E21, "g"}, {0x1E3E, 0x1E43, "m"}, {0x1E60, 0x1E69, "s"}, {0x1E6A, 0x1E71, "t"},
    {0x1E80, 0x1E89, "w"}, {0x1E8E, 0x1E8F, "y"}, {0x1E90, 0x1E95, "z"}, {0x1E9E, 0x1E9E, "ss"},
    {0x1EA0, 0x1EB7, "a"}, {0x1EB8, 0x1EC7, "e"}, {0x1EC8, 0x1ECB, "i"}, {0x1ECC, 0x1EE3, "o"},
    {0x1EE4, 0x1EF1, "u"}, {0x1EF2, 0x1EF9, "y"},
}};

constexpr char32_t kFirstMark = 0x300;
constexpr char32_t kLastMark = 0x36F;
constexpr char32_t kNone = 0xFFFFFFFF;

const char* plainOf(char32_t letter) {
  const auto found =
      std::lower_bound(kLatin.begin(), kLatin.end(), letter,
                       [](const Letters& letters, char32_t one) { return letters.last < one; });
  return found == kLatin.end() || letter < found->first ? nullptr : found->plain;
}

/// The character that begins at `at`, of `length` bytes; kNone of one byte where it is none.
char32_t characterAt(std::string_view text, std::size_t at, std::size_t& length) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
  char32_t character = length == 1 ? lead : lead & (0xFFU >> (length + 1));
  bool proper = (length > 1 || lead < 0x80) && at + length <= text.size();
  for (std::size_t i = at + 1; proper && i < at + length; ++i) {
    proper = (byte(i) & 0xC0U) == 0x80;
    character = character << 6U | (byte(i) & 0x3FU);
  }
  if (proper) return character;
  length = 1;
  return kNone;
}

}  // namespace

std::string folded(std::string_view text) {
  std::string result;
  bool after_letter = false;  // of ours: marks on others are a part of them
  for (std::size_t at = 0, length = 1; at < text.size(); at += length) {
    const char32_t character = characterAt(text, at, length);
    if (after_letter && character >= kFirstMark && character <= kLastMark) continue;
    const bool capital = character >= 'A' && character <= 'Z';
    const char* plain = plainOf(character);
    after_letter = capital || (character >= 'a' && character <= 'z') || plain != nullptr;
    if (plain != nullptr) {
      result += plain;
    } else if (capital) {
      result += static_cast<char>(character - 'A' + 'a');
    } else {
      result += text.substr(at, length);
    }
  }
  return result;
}

}  // namespace goal_alignment::phrasing
