// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"
#include "oracles/seeds.h"

/// What the tests of `questions` share.
namespace goal_alignment::questions::samples {

inline achievability::Conflict conflict(std::size_t candidates, std::uint64_t members,
                                        bool proven = true) {
  return {achievability::CandidateSet(candidates, members), proven, proven};
}

/// Nothing answered yet, all beliefs one half.
inline Situation fresh(std::size_t candidates, std::vector<achievability::Conflict> conflicts) {
  return {std::vector<Knowledge>(candidates, Knowledge::Open), std::vector<double>(candidates, 0.5),
          std::move(conflicts)};
}

/// Random answers, beliefs and conflicts.
inline Situation anySituation(RandomSource& random) {
  const std::size_t candidates = oracles::between(random, 1, 7);
  Situation situation = fresh(candidates, {});
  for (std::size_t f = 0; f < candidates; ++f) {
    if (oracles::chance(random, 0.5)) {
      situation.knowledge[f] = static_cast<Knowledge>(random.below(4));
    }
    situation.probability[f] = static_cast<double>(random.below(5)) / 5;
  }
  const std::uint64_t sets = std::uint64_t{1} << candidates;
  for (std::size_t n = random.below(5); n > 0; --n) {
    situation.conflicts.push_back(
        conflict(candidates, 1 + random.below(sets - 1), oracles::chance(random, 0.7)));
  }
  return situation;
}

/// The candidates that a policy asks when every answer is the same, in order.
inline std::vector<std::size_t> askedAll(Policy& policy, Situation situation, Knowledge answer) {
  std::vector<std::size_t> asked;
  while (const auto choice = policy.next(situation)) {
    asked.push_back(choice->candidate);
    situation.knowledge[choice->candidate] = answer;
    if (asked.size() > situation.knowledge.size()) break;  // it asks something twice
  }
  return asked;
}

}  // namespace goal_alignment::questions::samples
