// SPDX-License-Identifier: BSD-3-Clause
#include "bench_truth.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "goal_alignment/common/random_source.h"

namespace goal_alignment::cli {

namespace {

/// Fowler, Noll and Vo's hash, for std::hash is not the same everywhere.
std::uint64_t hashed(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  return hash;
}

Truth truthNamed(const std::string& name) {
  if (name == "own") return {name, std::nullopt};
  double probability = 0;
  if (!CLI::detail::lexical_cast(name, probability) || !(probability >= 0 && probability <= 1)) {
    throw CLI::ValidationError(
        "--truth", "expected own or a probability between 0 and 1, found '" + name + "'");
  }
  return {name, probability};
}

}  // namespace

std::vector<Truth> truthsNamed(const std::vector<std::string>& names) {
  if (names.empty()) return truthsNamed({"own", "0.2", "0.5"});
  std::vector<Truth> truths;
  for (const std::string& name : names) {
    if (std::none_of(truths.begin(), truths.end(),
                     [&](const Truth& truth) { return truth.name == name; })) {
      truths.push_back(truthNamed(name));
    }
  }
  return truths;
}

Wants drawnTruth(double probability, const std::string& instance, std::uint64_t seed) {
  const std::string key = std::to_string(seed) + ' ' + instance + ' ';
  return [=](const Literal& fluent) {
    return RandomSource(hashed(key + fluent.text())).unit() < probability;
  };
}

}  // namespace goal_alignment::cli
