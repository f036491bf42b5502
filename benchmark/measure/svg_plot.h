// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace goal_alignment::benchmarks {

struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< those that are not positive are left out
};

/// A plot with logarithmic axes: a straight line is a power, its slope the exponent.
struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  bool lines = true;  ///< joins a series' points in the order of x
};

/// The plot as an SVG document.
std::string svg(const Plot& plot);

}  // namespace goal_alignment::benchmarks
