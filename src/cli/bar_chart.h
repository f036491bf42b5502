// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::cli {

/// A bar: its parts stand on each other in the colours of the chart's legend, whose first entries
/// they are, or of which `first` is the first.
struct Bar {
  std::vector<double> parts;
  std::size_t first = 0;
  double deviation = 0;  ///< a whisker to either side of the top
};

/// Bars side by side, at one place of the axis.
struct BarGroup {
  std::string label;
  std::vector<Bar> bars;
  std::optional<double> mark;  ///< a line across all of them
};

struct BarPanel {
  std::string title;
  std::vector<BarGroup> groups;
};

/// Panels one below the other, each with a scale of its own that begins at zero.
struct BarChart {
  std::string title;
  std::string y_label;
  std::vector<std::string> legend;
  std::string mark;  ///< what the marks mean; empty: there are none
  std::vector<BarPanel> panels;
};

/// The chart as an SVG document, as wide as its bars need.
std::string svg(const BarChart& chart);

}  // namespace goal_alignment::cli
