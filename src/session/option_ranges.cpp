// SPDX-License-Identifier: BSD-3-Clause
#include "option_ranges.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::session {

namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace

void requireInRange(const Options& options) {
  require(options.belief.beta >= 0 && std::isfinite(options.belief.beta),
          "beta must be a number and not negative");
  require(options.belief.kappa > 0 && std::isfinite(options.belief.kappa),
          "kappa must be a positive number");
  require(options.belief.flat >= 0 && options.belief.flat <= 1,
          "a flat belief must lie between 0 and 1");
  require(options.time_limit > 0, "the time limit must be positive");
  require(options.memory_limit > 0, "the memory limit must be positive");
  require(options.threads >= 1, "the number of threads must be 1 or more");
  require(options.max_questions >= -1, "the question limit must be -1 (none) or more");
  require(options.max_group_size >= 1, "a question must offer 1 fluent or more");
  require(options.max_extra_cost >= 0, "the extra cost let pass must not be negative");
  questions::makePolicy(options.policy, {});  // throws for an unknown name
}

}  // namespace goal_alignment::session
