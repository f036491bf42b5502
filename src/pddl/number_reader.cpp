// SPDX-License-Identifier: BSD-3-Clause
#include "number_reader.h"

#include <string>
#include <string_view>

#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

namespace {

constexpr const char* kExpected = "a non-negative whole number";

bool allDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Stops at the bound, before the multiplication could overflow.
std::int64_t wholeNumber(const TokenReader& reader, const Token& token, std::string_view digits) {
  std::int64_t value = 0;
  for (const char digit : digits) {
    value = value * 10 + (digit - '0');
    if (value > kLargestCost) {
      reader.fail(token.position, "the number " + inQuotes(token.text) + " is too large; at most " +
                                      std::to_string(kLargestCost));
    }
  }
  return value;
}

}  // namespace

bool atNumber(const TokenReader& reader) {
  if (!reader.atWord()) return false;
  const std::string_view text = reader.current().text;
  const std::size_t sign = text.front() == '-' || text.front() == '+' ? 1 : 0;
  return text.find_first_of("0123456789.", sign) == sign;
}

std::int64_t readCost(TokenReader& reader) {
  if (!atNumber(reader)) reader.failExpecting(kExpected);
  const std::string_view text = reader.current().text;
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view fraction =
      point == std::string_view::npos ? std::string_view{} : text.substr(point + 1);
  if (!allDigits(whole) || !allDigits(fraction) || whole.size() + fraction.size() == 0) {
    reader.failExpecting(kExpected);
  }
  if (fraction.find_first_not_of('0') != std::string_view::npos) {
    reader.failUnsupported(reader.current().position, "fractional action cost " + inQuotes(text));
  }
  const Token token = reader.word(kExpected);
  return wholeNumber(reader, token, whole);
}

}  // namespace goal_alignment::pddl
