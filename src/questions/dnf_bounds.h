// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "monotone_dnf.h"

/// What can be said of the best dialogue over a DNF without looking ahead. A best dialogue is one
/// with the smallest expected number of questions. Everything here is proven for independent
/// answers.
namespace goal_alignment::questions {

/// The chance of a YES by candidate. Candidates are numbered by rising chance, so that the first
/// one of a set is its least likely member.
class Chances {
 public:
  Chances() = default;
  explicit Chances(const std::vector<double>& rising);
  double operator[](std::size_t candidate) const { return of_[candidate].yes; }
  /// 1/p and 1/(1−p).
  double perYes(std::size_t candidate) const { return of_[candidate].per_yes; }
  double perNo(std::size_t candidate) const { return of_[candidate].per_no; }
  /// The first candidate with the same chance.
  std::size_t firstWithSameChance(std::size_t candidate) const {
    return of_[candidate].first_with_same_chance;
  }
  /// Whether two candidates of the set have the same chance.
  bool anyEqual(CandidateMask set) const;

 private:
  struct Chance {
    double yes = 0;
    double per_yes = 0;
    double per_no = 0;
    std::size_t first_with_same_chance = kMaxCandidates;  // there is no such candidate
  };
  std::array<Chance, kMaxCandidates> of_;
};

/// Whether no two sets share a candidate: then the best dialogue is known.
bool isDisjoint(const MonotoneDnf& dnf);

/// The expected number of questions of the best dialogue over a disjoint DNF, which asks sets by
/// falling P/E and their members by rising p. O(n log n).
double disjointCost(const MonotoneDnf& dnf, const Chances& p);

/// A lower bound on the expected number of questions of any dialogue. O(total size).
///
/// Give each YES a value a and each NO a value b so that a question brings 1 at most on average:
/// p·a + (1−p)·b ≤ 1. A dialogue that ends with YES has then collected all of a set, one that ends
/// with NO one member at least of each set, so that
/// E[questions] ≥ P(yes)·min_S Σ_S a + P(no)·min_H Σ_H b. Taken at a = 1/p and at b = 1/(1−p), with
/// P(no) ≥ Π_S (1 − P(S)) (Harris 1960) and hitting sets H bounded by disjoint sets.
///
/// Or: E[questions] = Σ_t P(more than t). Fewer than the disjoint sets don't end it with NO, fewer
/// than the smallest set not with YES, and P(ends with YES by t) ≤ min(P(yes), t / min_S Σ_S 1/p).
double costLowerBound(const MonotoneDnf& dnf, const Chances& p);

/// Candidates each of which some best dialogue asks first; none where no rule applies.
///
/// 1. Of a set that shares nothing with others the least likely member, where its P/E is not below
///    the rate P(ends with YES before τ)/E[questions before τ] that any strategy on the rest
///    reaches by any time τ. With a as above that rate is at most max_S 1/Σ_S(1/p), or P/E for lone
///    sets. Moving the lone set to the front of a dialogue then costs nothing.
/// 2. Likewise with YES and NO exchanged: a member of every set, where 1/(1−p) is not above what
///    the b of the other members add up to in every hitting set of the rest.
CandidateMask provablyBestFirst(const MonotoneDnf& dnf, const Chances& p);

/// The candidates that no other one dominates: of those in exactly the same sets only the least
/// likely, and of those that are exchangeable (each set with one has a twin with the other) only
/// the likeliest. A dialogue that asks the dominated one first costs no less than one that asks the
/// two in exchanged places.
CandidateMask undominatedCandidates(const MonotoneDnf& dnf, const Chances& p);

/// The candidates that cost as much to ask first as `candidate`, itself included, because they are
/// as likely and in exactly the same sets or exchangeable as above.
CandidateMask equivalentCandidates(const MonotoneDnf& dnf, const Chances& p, std::size_t candidate);

}  // namespace goal_alignment::questions
