// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
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

/// Nothing answered yet, all conflicts of at least one member.
inline Situation anyUnanswered(RandomSource& random, std::size_t max_candidates,
                               std::size_t max_conflicts = 8) {
  const std::size_t candidates = oracles::between(random, 1, max_candidates);
  Situation situation = fresh(candidates, {});
  const double likely = random.unit();
  for (double& p : situation.probability) {
    p = oracles::chance(random, 0.3) ? static_cast<double>(random.below(11)) / 10
                                     : random.unit() * likely;
  }
  const double density = random.unit();
  for (std::size_t n = oracles::between(random, 1, max_conflicts); n > 0; --n) {
    std::uint64_t members = std::uint64_t{1} << random.below(candidates);
    for (std::size_t f = 0; f < candidates; ++f) {
      if (oracles::chance(random, density)) members |= std::uint64_t{1} << f;
    }
    situation.conflicts.push_back(conflict(candidates, members, oracles::chance(random, 0.8)));
  }
  return situation;
}

inline std::unique_ptr<Policy> policyOf(const std::string& name, std::uint64_t seed = 0) {
  PolicyContext context;
  context.seed = seed;
  return makePolicy(name, context);
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
