// SPDX-License-Identifier: BSD-3-Clause
#include "dnf_bounds.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <utility>

#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

/// What is known of one set asked member by member.
struct SetCost {
  double all = 1;      ///< P(all wanted)
  double cost = 0;     ///< E[questions until that is known]
  double inverse = 0;  ///< Σ 1/p
};

SetCost costOf(CandidateMask set, const Chances& p) {
  SetCost result;
  for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstCandidate(left);
    result.cost += result.all;
    result.all *= p[f];
    result.inverse += p.perYes(f);
  }
  return result;
}

/// The candidates that are in more than one set.
CandidateMask inSeveral(const MonotoneDnf& dnf) {
  CandidateMask once = 0;
  CandidateMask several = 0;
  for (const CandidateMask set : dnf) {
    several |= once & set;
    once |= set;
  }
  return several;
}

/// The first candidate of the set, and those as likely.
CandidateMask leastLikely(CandidateMask set, const Chances& p) {
  const double lowest = p[firstCandidate(set)];
  CandidateMask result = 0;
  for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) {
    if (p[firstCandidate(left)] > lowest * (1 + kTolerance)) break;
    result |= maskOf(firstCandidate(left));
  }
  return result;
}

/// Rule 1 of provablyBestFirst().
CandidateMask firstOfLoneSets(const MonotoneDnf& dnf, const Chances& p) {
  const CandidateMask several = inSeveral(dnf);
  double best_ratio = -1;
  double rest = 0;
  CandidateMask first = 0;
  for (const CandidateMask set : dnf) {
    const SetCost cost = costOf(set, p);
    if ((set & several) != 0) {
      rest = std::max(rest, 1 / cost.inverse);
      continue;
    }
    const double ratio = cost.all / cost.cost;
    if (ratio < best_ratio * (1 - kTolerance)) continue;
    if (ratio > best_ratio * (1 + kTolerance)) first = 0;
    best_ratio = std::max(best_ratio, ratio);
    first |= leastLikely(set, p);
  }
  return best_ratio >= rest ? first : 0;
}

/// Rule 2 of provablyBestFirst().
CandidateMask firstOfCore(const MonotoneDnf& dnf, const Chances& p) {
  CandidateMask core = ~CandidateMask{0};
  for (const CandidateMask set : dnf)
    core &= set;
  if (core == 0) return 0;
  const CandidateMask first = leastLikely(core, p);
  const CandidateMask ignored = maskOf(firstCandidate(first));
  double rest = 0;
  CandidateMask used = ignored;
  for (const CandidateMask set : dnf) {
    if ((set & used & ~ignored) != 0) continue;
    used |= set;
    rest += p.perNo(firstCandidate(set & ~ignored));
  }
  return p.perNo(firstCandidate(first)) <= rest ? first : 0;
}

/// Which candidates are interchangeable because they occur in the same company.
struct CandidateSymmetry {
  CandidateMask all = 0;
  std::array<CandidateMask, kMaxCandidates> beside;  // what is in every set with it
  std::array<DnfKey, kMaxCandidates> links{};        // the sets with it, without it

  explicit CandidateSymmetry(const MonotoneDnf& dnf) {
    beside.fill(~CandidateMask{0});
    for (const CandidateMask set : dnf) {
      all |= set;
      for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) {
        const std::size_t f = firstCandidate(left);
        beside[f] &= set;
        addTo(links[f], set & ~maskOf(f));
      }
    }
  }
  bool together(std::size_t a, std::size_t b) const {
    return (beside[a] & maskOf(b)) != 0 && (beside[b] & maskOf(a)) != 0;
  }
  bool exchangeable(std::size_t a, std::size_t b) const { return links[a] == links[b]; }

  /// Asking b instead of a never costs more; of equals, the first one is kept.
  bool replaces(std::size_t b, std::size_t a, const Chances& p) const {
    if (together(a, b)) return p[b] < p[a] || (p[b] == p[a] && b < a);
    if (exchangeable(a, b)) return p[b] > p[a] || (p[b] == p[a] && b < a);
    return false;
  }
};

}  // namespace

Chances::Chances(const std::vector<double>& rising) {
  for (std::size_t f = 0; f < rising.size(); ++f) {
    const bool same = f > 0 && rising[f] == rising[f - 1];
    of_[f] = {rising[f], 1 / rising[f], 1 / (1 - rising[f]),
              same ? of_[f - 1].first_with_same_chance : f};
  }
}

bool Chances::anyEqual(CandidateMask set) const {
  std::size_t last = kMaxCandidates;
  for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) {
    const std::size_t first = firstWithSameChance(firstCandidate(left));
    if (first == last && first != kMaxCandidates) return true;
    last = first;
  }
  return false;
}

bool isDisjoint(const MonotoneDnf& dnf) {
  return inSeveral(dnf) == 0;
}

double disjointCost(const MonotoneDnf& dnf, const Chances& p) {
  boost::container::small_vector<SetCost, 12> sets;
  for (const CandidateMask set : dnf)
    sets.push_back(costOf(set, p));
  std::sort(sets.begin(), sets.end(),
            [](const SetCost& a, const SetCost& b) { return a.all / a.cost > b.all / b.cost; });
  double sum = 0;
  double reached = 1;
  for (const SetCost& set : sets) {
    sum += reached * set.cost;
    reached *= 1 - set.all;
  }
  return sum;
}

double costLowerBound(const MonotoneDnf& dnf, const Chances& p) {
  double smallest = kMaxCandidates;
  double disjoint = 0;
  double min_yes = 1e300;  // min_S Σ_S a
  double min_no = 0;       // min_H Σ_H b, from below
  double no = 1;           // P(no), from below
  double disjoint_no = 1;  // P(none of the disjoint sets is all wanted)
  CandidateMask used = 0;
  for (const CandidateMask set : dnf) {
    const SetCost cost = costOf(set, p);
    smallest = std::min(smallest, static_cast<double>(candidateCount(set)));
    min_yes = std::min(min_yes, cost.inverse);
    no *= 1 - cost.all;
    if ((set & used) != 0) continue;
    used |= set;
    ++disjoint;
    disjoint_no *= 1 - cost.all;
    min_no += p.perNo(firstCandidate(set));
  }
  const double yes = 1 - disjoint_no;  // P(yes), from below
  double by_time = std::min(smallest, disjoint);
  for (double t = smallest; t < disjoint; ++t)
    by_time += std::max(no, 1 - t / min_yes);
  if (disjoint < smallest) by_time += yes * (smallest - disjoint);
  return std::max({by_time, yes > 0 ? yes * min_yes : 0, no > 0 ? no * min_no : 0});
}

CandidateMask provablyBestFirst(const MonotoneDnf& dnf, const Chances& p) {
  const CandidateMask lone = firstOfLoneSets(dnf, p);
  return lone != 0 ? lone : firstOfCore(dnf, p);
}

CandidateMask undominatedCandidates(const MonotoneDnf& dnf, const Chances& p) {
  const CandidateSymmetry symmetry(dnf);
  CandidateMask result = 0;
  for (CandidateMask left = symmetry.all; left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstCandidate(left);
    bool replaced = false;
    for (CandidateMask others = symmetry.all; others != 0 && !replaced;
         others = clearLowestBit(others)) {
      const std::size_t other = firstCandidate(others);
      replaced = other != f && symmetry.replaces(other, f, p);
    }
    if (!replaced) result |= maskOf(f);
  }
  return result;
}

CandidateMask equivalentCandidates(const MonotoneDnf& dnf, const Chances& p,
                                   std::size_t candidate) {
  const CandidateSymmetry symmetry(dnf);
  CandidateMask result = 0;
  for (CandidateMask left = symmetry.all; left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstCandidate(left);
    const bool symmetric = symmetry.together(f, candidate) || symmetry.exchangeable(f, candidate);
    if (symmetric && p[f] == p[candidate]) result |= maskOf(f);
  }
  return result;
}

}  // namespace goal_alignment::questions
