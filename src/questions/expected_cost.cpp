// SPDX-License-Identifier: BSD-3-Clause
#include "expected_cost.h"

#include <algorithm>
#include <limits>

#include "dnf_symmetry.h"
#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

constexpr double kNoCutoff = std::numeric_limits<double>::infinity();

/// Families remembered from one decision to the next: some 100 MiB.
constexpr std::size_t kMaxKnown = std::size_t{1} << 21U;

/// About a millisecond.
constexpr std::uint64_t kWorkBetweenPolls = 100'000;

}  // namespace

std::optional<CandidateMask> ExpectedCost::bestFirst(const MonotoneDnf& dnf, std::uint64_t work) {
  allow(work);
  if (const CandidateMask first = certainlyFirst(dnf, p_); first != 0) return first;
  try {
    double best = kNoCutoff;
    CandidateMask result = 0;
    for (Option& option : optionsOf(dnf)) {
      const double of_option = valueOf(option, best * (1 + kTolerance));
      if (of_option > best * (1 + kTolerance)) continue;
      if (of_option < best * (1 - kTolerance)) result = 0;
      best = std::min(best, of_option);
      result |= alike(dnf, p_, option.candidate);
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

/// Exact where it is below the cutoff; otherwise no more than the true value, and not below the
/// cutoff.
double ExpectedCost::value(const MonotoneDnf& dnf, double cutoff) {
  if (isDisjoint(dnf)) return disjointCost(dnf, p_);
  const DnfKey key = keyUpToNames(dnf, p_);
  if (const auto found = known_.find(key); found != known_.end()) {
    if (found->second.exact || found->second.value >= cutoff) return found->second.value;
  }
  const double result = leastOver(dnf, cutoff);
  Known& known = known_[key];
  known = {std::max(known.value, result), result < cutoff};
  return result;
}

double ExpectedCost::leastOver(const MonotoneDnf& dnf, double cutoff) {
  spend(dnf.size());
  if (const CandidateMask first = certainlyFirst(dnf, p_); first != 0) {
    Option option = optionOf(dnf, firstBit(first));
    return valueOf(option, cutoff);
  }
  double best = kNoCutoff;
  for (Option& option : optionsOf(dnf))
    best = std::min(best, valueOf(option, std::min(best, cutoff)));
  return best;
}

/// The most promising first, which makes the cutoff sharp for the rest.
std::vector<ExpectedCost::Option> ExpectedCost::optionsOf(const MonotoneDnf& dnf) {
  std::vector<Option> options;
  for (CandidateMask left = worthAsking(dnf, p_); left != 0; left = clearLowestBit(left))
    options.push_back(optionOf(dnf, firstBit(left)));
  std::sort(options.begin(), options.end(),
            [](const Option& a, const Option& b) { return a.least < b.least; });
  return options;
}

/// As value(), of asking this first.
double ExpectedCost::valueOf(Option& option, double cutoff) {
  const double p = p_[option.candidate];
  if (option.least >= cutoff) return option.least;
  if (p < 1) {
    const double no_cutoff = (cutoff - 1 - p * option.least_yes) / (1 - p);
    option.least_no = value(option.no, no_cutoff);
    option.weigh(p);
    // Not by comparing the sum: rounding must not turn a bound into a value.
    if (option.least_no >= no_cutoff) return std::max(option.least, cutoff);
  }
  if (p > 0) {
    const double yes_cutoff = (cutoff - 1 - (1 - p) * option.least_no) / p;
    option.least_yes = value(option.yes, yes_cutoff);
    option.weigh(p);
    if (option.least_yes >= yes_cutoff) return std::max(option.least, cutoff);
  }
  return option.least;
}

ExpectedCost::Option ExpectedCost::optionOf(const MonotoneDnf& dnf, std::size_t candidate) {
  Option option;
  option.candidate = candidate;
  option.yes = dnf.ifWanted(candidate);
  option.no = dnf.ifNotWanted(candidate);
  const std::size_t with = dnf.size() - option.no.size();
  const std::uint64_t work = 16 + 3 * dnf.size() + with * option.no.size();
  spend(has_alike_ ? 2 * work : work);  // keys take as long as all the rest

  const double p = p_[candidate];
  option.least_yes = p > 0 ? bound(option.yes) : 0;
  option.least_no = p < 1 ? bound(option.no) : 0;
  option.weigh(p);
  return option;
}

double ExpectedCost::bound(const MonotoneDnf& dnf) const {
  if (isDisjoint(dnf)) return disjointCost(dnf, p_);
  const auto found = known_.find(keyUpToNames(dnf, p_));
  return found != known_.end() ? found->second.value : leastCost(dnf, p_);
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
