// SPDX-License-Identifier: BSD-3-Clause
#include "conflict_families.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace goal_alignment::benchmarks {

using achievability::CandidateSet;
using questions::Knowledge;
using questions::Situation;

namespace {

using Members = std::vector<std::size_t>;

void add(Situation& situation, const Members& members) {
  achievability::Conflict conflict{CandidateSet(situation.knowledge.size()), true, true};
  for (const std::size_t f : members)
    conflict.members.set(f);
  const auto same = [&](const auto& other) { return other.members == conflict.members; };
  auto& conflicts = situation.conflicts;
  if (std::none_of(conflicts.begin(), conflicts.end(), same)) conflicts.push_back(conflict);
}

void addRandom(Situation& situation, std::size_t size, std::size_t conflicts,
               RandomSource& random) {
  while (situation.conflicts.size() < conflicts) {
    Members members;
    while (members.size() < size) {
      const std::size_t f = random.below(situation.knowledge.size());
      if (std::count(members.begin(), members.end(), f) == 0) members.push_back(f);
    }
    add(situation, members);
  }
}

void addStars(Situation& situation, RandomSource& random) {
  const std::size_t n = situation.knowledge.size();
  const std::size_t centres = std::max<std::size_t>(1, n / 5);
  for (std::size_t f = centres; f < n; ++f) {
    add(situation, {f, random.below(centres)});
    if (random.below(2) == 0) add(situation, {f, random.below(centres)});
  }
}

/// Cuts the candidates into groups of one to `most`.
std::vector<Members> groups(std::size_t candidates, std::size_t most, RandomSource& random) {
  std::vector<Members> result;
  for (std::size_t f = 0; f < candidates;) {
    const std::size_t end = std::min(candidates, f + 1 + random.below(most));
    result.emplace_back();
    while (f < end)
      result.back().push_back(f++);
  }
  return result;
}

void addClique(Situation& situation, const Members& members) {
  if (members.size() == 1) add(situation, members);
  for (const std::size_t a : members) {
    for (const std::size_t b : members) {
      if (a < b) add(situation, {a, b});
    }
  }
}

double expected(questions::Policy& policy, Situation& situation) {
  const auto choice = policy.next(situation);
  if (!choice) return 0;
  const double p = situation.probability[choice->candidate];
  double cost = 1;
  Knowledge& asked = situation.knowledge[choice->candidate];
  if (asked != Knowledge::Open) throw std::logic_error("a policy asks what is answered");
  asked = Knowledge::Wanted;
  if (p > 0) cost += p * expected(policy, situation);
  asked = Knowledge::NotWanted;
  if (p < 1) cost += (1 - p) * expected(policy, situation);
  asked = Knowledge::Open;
  return cost;
}

}  // namespace

std::vector<std::string> conflictFamilies() {
  return {"pairs", "triples", "stars", "disjoint", "chain", "cliques"};
}

Situation conflictFamily(const std::string& family, std::size_t candidates, std::size_t conflicts,
                         double least, double most, RandomSource& random) {
  Situation situation;
  situation.knowledge.assign(candidates, Knowledge::Open);
  for (std::size_t f = 0; f < candidates; ++f)
    situation.probability.push_back(least + (most - least) * random.unit());
  if (family == "pairs" || family == "triples") {
    addRandom(situation, family == "pairs" ? 2 : 3, conflicts, random);
  } else if (family == "stars") {
    addStars(situation, random);
  } else if (family == "disjoint") {
    for (const Members& members : groups(candidates, 4, random))
      add(situation, members);
  } else if (family == "chain") {
    for (std::size_t f = 1; f < candidates; ++f)
      add(situation, {f - 1, f});
  } else if (family == "cliques") {
    for (const Members& members : groups(candidates, 5, random))
      addClique(situation, members);
  } else {
    throw std::invalid_argument("no family of conflicts is called '" + family + "'");
  }
  return situation;
}

double expectedQuestions(questions::Policy& policy, const Situation& situation) {
  Situation now = situation;
  return expected(policy, now);
}

}  // namespace goal_alignment::benchmarks
