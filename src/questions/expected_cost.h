// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "dnf_bounds.h"
#include "monotone_dnf.h"

namespace goal_alignment::questions {

/// The least expected number of questions, exactly: stochastic Boolean function evaluation of a
/// monotone DNF by expectimax over DNFs with memory (Ünlüyurt, "Sequential testing of complex
/// systems", 2004). The problem is NP-hard already for sets of two (Allen, Hellerstein, Kletenik &
/// Ünlüyurt, 2017): branch and bound with the rules and bounds of family_bounds.h keeps most
/// DNFs small, and an allowance of work bounds the rest. What was computed is remembered, so
/// that the states a dialogue comes to are known already.
class ExpectedCost {
 public:
  /// `poll` is called every millisecond or so; what it throws ends the computation.
  explicit ExpectedCost(const Chances& p, std::function<void()> poll = {})
      : p_(p), poll_(std::move(poll)), has_alike_(p.anyAlike(~CandidateMask{0})) {}

  /// Candidates that a best dialogue may ask first, or nothing where the work would be more than
  /// allowed: all that tie, except where a rule says without looking ahead that some are best. The
  /// dnf must not be empty. A unit of work takes some 10 ns and 5 bytes that stay.
  std::optional<CandidateMask> bestFirst(const MonotoneDnf& dnf, std::uint64_t work);

  /// The expected number itself.
  std::optional<double> of(const MonotoneDnf& dnf, std::uint64_t work);

  const Chances& chances() const { return p_; }
  std::size_t states() const { return known_.size(); }

 private:
  struct OutOfWork {};
  struct Known {
    double value = 0;
    bool exact = false;  // otherwise the true value is not below
  };
  struct Hash {
    std::size_t operator()(const DnfKey& key) const { return key.low; }
  };
  /// A question with the DNFs it leads to.
  struct Option {
    std::size_t candidate;
    MonotoneDnf yes;
    MonotoneDnf no;
    double least_yes;
    double least_no;
    double least;

    void weigh(double p) { least = 1 + p * least_yes + (1 - p) * least_no; }
  };

  double value(const MonotoneDnf& dnf, double cutoff);
  double leastOver(const MonotoneDnf& dnf, double cutoff);
  std::vector<Option> optionsOf(const MonotoneDnf& dnf);
  double valueOf(Option& option, double cutoff);
  Option optionOf(const MonotoneDnf& dnf, std::size_t candidate);
  double bound(const MonotoneDnf& dnf) const;
  void allow(std::uint64_t work);
  void spend(std::uint64_t work);

  Chances p_;
  std::function<void()> poll_;
  bool has_alike_;
  std::uint64_t next_poll_ = 0;  // at this much work left
  std::unordered_map<DnfKey, Known, Hash> known_;
  std::uint64_t work_left_ = 0;
};

}  // namespace goal_alignment::questions
