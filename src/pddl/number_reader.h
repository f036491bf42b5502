// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "token_reader.h"

namespace goal_alignment::pddl {

/// The largest single cost: the sum over any plan that fits into memory stays within 64 bits.
constexpr std::int64_t kLargestCost = 1'000'000'000;

/// Whether the current word is meant as a number, good or bad.
bool atNumber(const TokenReader& reader);

/// A cost: a whole number from 0 to kLargestCost; `5.0` is 5, `2.5` is unsupported.
std::int64_t readCost(TokenReader& reader);

}  // namespace goal_alignment::pddl
