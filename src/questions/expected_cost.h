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

/// The minimum expected number of questions, exactly: stochastic Boolean function evaluation of a
/// monotone DNF by expectimax over DNFs with memory (Ünlüyurt, "Sequential testing of complex
/// systems", 2004). The problem is NP-hard already for sets of two (Allen, Hellerstein, Kletenik &
/// Ünlüyurt, 2017): branch and bound with the rules and bounds of dnf_bounds.h keeps most
/// DNFs small, and an allowance of work bounds the rest. What was computed is remembered, so
/// that the states a dialogue comes to are known already.
class ExpectedCost {
 public:
  /// `poll` is called every millisecond or so; what it throws ends the computation.
  explicit ExpectedCost(const Chances& p, std::function<void()> poll = {})
      : p_(p), poll_(std::move(poll)), has_equal_chances_(p.anyEqual(~CandidateMask{0})) {}

  /// The candidates that a best dialogue may ask first, or nothing where that would take more than
  /// `work`: all that tie, or only some of them where a rule finds those without looking ahead. The
  /// DNF must not be empty. A unit of work takes some 10 ns and 5 bytes that stay allocated.
  std::optional<CandidateMask> bestFirst(const MonotoneDnf& dnf, std::uint64_t work);

  /// The minimum expected number of questions itself, or nothing where that would take more work.
  std::optional<double> of(const MonotoneDnf& dnf, std::uint64_t work);

  const Chances& chances() const { return p_; }
  std::size_t states() const { return known_.size(); }

 private:
  struct OutOfWork {};
  struct Known {
    double value = 0;
    bool exact = false;  // otherwise a lower bound
  };
  struct Hash {
    std::size_t operator()(const DnfKey& key) const { return key.low; }
  };
  /// A question with the DNFs it leads to.
  struct Option {
    std::size_t candidate;
    MonotoneDnf yes;
    MonotoneDnf no;
    double yes_bound;  // lower bounds on the cost after YES, after NO and of the option
    double no_bound;
    double lower_bound;

    void updateBound(double p) { lower_bound = 1 + p * yes_bound + (1 - p) * no_bound; }
  };

  double value(const MonotoneDnf& dnf, double cutoff);
  double minOverOptions(const MonotoneDnf& dnf, double cutoff);
  std::vector<Option> makeOptions(const MonotoneDnf& dnf);
  double valueOf(Option& option, double cutoff);
  Option makeOption(const MonotoneDnf& dnf, std::size_t candidate);
  double bound(const MonotoneDnf& dnf) const;
  void allow(std::uint64_t work);
  void spend(std::uint64_t work);

  Chances p_;
  std::function<void()> poll_;
  bool has_equal_chances_;
  std::uint64_t next_poll_ = 0;  // at this much work left
  std::unordered_map<DnfKey, Known, Hash> known_;
  std::uint64_t work_left_ = 0;
};

}  // namespace goal_alignment::questions
