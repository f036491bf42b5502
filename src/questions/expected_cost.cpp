// SPDX-License-Identifier: BSD-3-Clause
#include "expected_cost.h"

#include <algorithm>
#include <limits>

#include "dnf_symmetry.h"
#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

constexpr double kNoCutoff = std::numeric_limits<double>::infinity();

/// DNFs remembered from one decision to the next: some 100 MiB.
constexpr std::size_t kMaxKnown = std::size_t{1} << 21U;

/// About a millisecond.
constexpr std::uint64_t kWorkBetweenPolls = 100'000;

}  // namespace

std::optional<CandidateMask> ExpectedCost::bestFirst(const MonotoneDnf& dnf, std::uint64_t work) {
  allow(work);
  if (const CandidateMask first = provablyBestFirst(dnf, p_); first != 0) return first;
  try {
    double best = kNoCutoff;
    CandidateMask result = 0;
    for (Option& option : makeOptions(dnf)) {
      const double of_option = valueOf(option, best * (1 + kTolerance));
      if (of_option > best * (1 + kTolerance)) continue;
      if (of_option < best * (1 - kTolerance)) result = 0;
      best = std::min(best, of_option);
      result |= equivalentCandidates(dnf, p_, option.candidate);
    }
    return result;
  } catch (const OutOfWork&) {
    return std::nullopt;
  }
}

std::optional<double> ExpectedCost::of(const MonotoneDnf& dnf, std::uint64_t work) {
  allow(work);
  try {
    return value(dnf, kNoCutoff);
  } catch (const OutOfWork&) {
    return std::nullopt;
  }
}

/// Exact where it is below the cutoff; otherwise a lower bound that is not below the cutoff.
double ExpectedCost::value(const MonotoneDnf& dnf, double cutoff) {
  if (isDisjoint(dnf)) return disjointCost(dnf, p_);
  const DnfKey key = keyUpToRenaming(dnf, p_);
  if (const auto found = known_.find(key); found != known_.end()) {
    if (found->second.exact || found->second.value >= cutoff) return found->second.value;
  }
  const double result = minOverOptions(dnf, cutoff);
  Known& known = known_[key];
  known = {std::max(known.value, result), result < cutoff};
  return result;
}

double ExpectedCost::minOverOptions(const MonotoneDnf& dnf, double cutoff) {
  spend(dnf.size());
  if (const CandidateMask first = provablyBestFirst(dnf, p_); first != 0) {
    Option option = makeOption(dnf, firstCandidate(first));
    return valueOf(option, cutoff);
  }
  double best = kNoCutoff;
  for (Option& option : makeOptions(dnf))
    best = std::min(best, valueOf(option, std::min(best, cutoff)));
  return best;
}

/// The most promising first, which makes the cutoff sharp for the rest.
std::vector<ExpectedCost::Option> ExpectedCost::makeOptions(const MonotoneDnf& dnf) {
  std::vector<Option> options;
  for (CandidateMask left = undominatedCandidates(dnf, p_); left != 0; left = clearLowestBit(left))
    options.push_back(makeOption(dnf, firstCandidate(left)));
  std::sort(options.begin(), options.end(),
            [](const Option& a, const Option& b) { return a.lower_bound < b.lower_bound; });
  return options;
}

/// The same as value() when this candidate is asked first.
double ExpectedCost::valueOf(Option& option, double cutoff) {
  const double p = p_[option.candidate];
  if (option.lower_bound >= cutoff) return option.lower_bound;
  if (p < 1) {
    const double no_cutoff = (cutoff - 1 - p * option.yes_bound) / (1 - p);
    option.no_bound = value(option.no, no_cutoff);
    option.updateBound(p);
    // Not by comparing the sum: rounding must not turn a bound into a value.
    if (option.no_bound >= no_cutoff) return std::max(option.lower_bound, cutoff);
  }
  if (p > 0) {
    const double yes_cutoff = (cutoff - 1 - (1 - p) * option.no_bound) / p;
    option.yes_bound = value(option.yes, yes_cutoff);
    option.updateBound(p);
    if (option.yes_bound >= yes_cutoff) return std::max(option.lower_bound, cutoff);
  }
  return option.lower_bound;
}

ExpectedCost::Option ExpectedCost::makeOption(const MonotoneDnf& dnf, std::size_t candidate) {
  Option option;
  option.candidate = candidate;
  option.yes = dnf.ifWanted(candidate);
  option.no = dnf.ifNotWanted(candidate);
  const std::size_t with = dnf.size() - option.no.size();
  const std::uint64_t work = 16 + 3 * dnf.size() + with * option.no.size();
  spend(has_equal_chances_ ? 2 * work : work);  // making keys takes as long as the rest

  const double p = p_[candidate];
  option.yes_bound = p > 0 ? bound(option.yes) : 0;
  option.no_bound = p < 1 ? bound(option.no) : 0;
  option.updateBound(p);
  return option;
}

double ExpectedCost::bound(const MonotoneDnf& dnf) const {
  if (isDisjoint(dnf)) return disjointCost(dnf, p_);
  const auto found = known_.find(keyUpToRenaming(dnf, p_));
  return found != known_.end() ? found->second.value : costLowerBound(dnf, p_);
}

void ExpectedCost::allow(std::uint64_t work) {
  if (known_.size() > kMaxKnown) known_.clear();
  work_left_ = work;
  next_poll_ = work;
}

void ExpectedCost::spend(std::uint64_t work) {
  if (work_left_ < work) throw OutOfWork();
  work_left_ -= work;
  if (!poll_ || work_left_ > next_poll_) return;
  next_poll_ = work_left_ - std::min(work_left_, kWorkBetweenPolls);
  poll_();
}

}  // namespace goal_alignment::questions
