// SPDX-License-Identifier: BSD-3-Clause
#include "md5.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace goal_alignment::any_message {
namespace {

constexpr std::size_t kBlock = 64;  // bytes
constexpr std::size_t kLengthAt = 56;
constexpr std::uint8_t kFirstOfThePadding = 0x80;

using State = std::array<std::uint32_t, 4>;
using Shifts = std::array<unsigned, 4>;
constexpr std::array<Shifts, 4> kShifts = {
    {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}}};

std::uint32_t rotated(std::uint32_t value, unsigned by) {
  return (value << by) | (value >> (32 - by));
}

// The RFC's table T.
std::uint32_t sine(unsigned step) {
  return static_cast<std::uint32_t>(std::floor(std::abs(std::sin(step + 1.0)) * 4294967296.0));
}

std::uint32_t word(const std::string& text, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(text[at + i])) << (8 * i);
  return value;
}

// The function of the round, and which word of the block it takes.
std::pair<std::uint32_t, unsigned> round(unsigned step, std::uint32_t b, std::uint32_t c,
                                         std::uint32_t d) {
  switch (step / 16) {
    case 0:
      return {(b & c) | (~b & d), step};
    case 1:
      return {(d & b) | (~d & c), (5 * step + 1) % 16};
    case 2:
      return {b ^ c ^ d, (3 * step + 5) % 16};
    default:
      return {c ^ (b | ~d), (7 * step) % 16};
  }
}

void addBlock(State& state, const std::string& text, std::size_t begin) {
  auto [a, b, c, d] = state;
  for (unsigned step = 0; step < 64; ++step) {
    const auto [mixed, index] = round(step, b, c, d);
    const std::uint32_t sum = a + mixed + sine(step) + word(text, begin + 4 * index);
    a = std::exchange(
        d, std::exchange(c, std::exchange(b, b + rotated(sum, kShifts[step / 16][step % 4]))));
  }
  state = {state[0] + a, state[1] + b, state[2] + c, state[3] + d};
}

}  // namespace

std::string md5Of(const std::string& text) {
  std::string padded = text + static_cast<char>(kFirstOfThePadding);
  while (padded.size() % kBlock != kLengthAt)
    padded += '\0';
  const std::uint64_t bits = std::uint64_t{text.size()} * 8;
  for (unsigned i = 0; i < 8; ++i)
    padded += static_cast<char>(bits >> (8 * i));
  State state = {0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
  for (std::size_t begin = 0; begin < padded.size(); begin += kBlock)
    addBlock(state, padded, begin);
  std::string hex;
  for (const std::uint32_t value : state) {
    for (unsigned i = 0; i < 4; ++i)
      hex += fmt::format("{:02x}", (value >> (8 * i)) & 0xffU);
  }
  return hex;
}

}  // namespace goal_alignment::any_message
