// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/algorithm_one.h"

#include <cmath>

namespace goal_alignment::oracles {

AlgorithmOneRun algorithmOne(const Hagl& hagl, std::vector<std::size_t> queue) {
  AlgorithmOneRun run;
  const auto bit = [](std::size_t f) { return CandidateBits{1} << f; };
  if (!hagl.achievable(0)) return run;
  if (hagl.achievable(hagl.all())) {
    run.plan_found = true;
    return run;
  }
  CandidateBits confirmed = 0;
  while (!queue.empty()) {
    const std::size_t f = queue.front();
    queue.erase(queue.begin());
    run.questions.push_back(f);
    if (hagl.wants(hagl.candidates[f])) {
      confirmed |= bit(f);
      if (!hagl.achievable(confirmed)) return run;
    } else {
      CandidateBits rest = confirmed;
      for (const std::size_t g : queue)
        rest |= bit(g);
      if (hagl.achievable(rest)) {
        run.plan_found = true;
        return run;
      }
    }
  }
  run.plan_found = hagl.achievable(confirmed);
  return run;
}

std::vector<double> valueOfQuery(const std::vector<double>& belief,
                                 const std::vector<bool>& unachievable_alone) {
  std::vector<double> values;
  for (std::size_t f = 0; f < belief.size(); ++f) {
    double product = 1;
    double product_without = 1;
    for (std::size_t g = 0; g < belief.size(); ++g) {
      if (unachievable_alone[g]) product *= belief[g];
      if (unachievable_alone[g] && g != f) product_without *= belief[g];
    }
    const double value_if_wanted = unachievable_alone[f] ? 1 : product;
    values.push_back(belief[f] * value_if_wanted + (1 - belief[f]) * product_without);
  }
  return values;
}

std::vector<double> normalisedBeliefs(const std::vector<double>& differences, double beta) {
  std::vector<double> beliefs;
  double sum = 0;
  for (const double difference : differences)
    sum += std::exp(-beta * std::abs(difference));
  for (const double difference : differences) {
    beliefs.push_back(std::exp(-beta * std::abs(difference)) / sum);
  }
  return beliefs;
}

}  // namespace goal_alignment::oracles
