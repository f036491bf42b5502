// SPDX-License-Identifier: BSD-3-Clause
#include "svg_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "goal_alignment/cli/svg.h"

namespace goal_alignment::benchmarks {

using cli::SvgPage;

namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kLeft = 80;
constexpr double kRight = 180;  // for the legend
constexpr double kTop = 40;
constexpr double kBottom = 60;

// Whole decades around the values, onto a stretch of the page.
class Axis {
 public:
  Axis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    if (values.empty()) return;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    first_ = static_cast<int>(std::floor(std::log10(*least)));
    last_ = std::max(first_ + 1, static_cast<int>(std::ceil(std::log10(*most))));
  }
  double at(double value) const {
    return from_ + (std::log10(value) - first_) / (last_ - first_) * (to_ - from_);
  }
  int first() const { return first_; }
  int last() const { return last_; }

 private:
  double from_;
  double to_;
  int first_ = 0;
  int last_ = 1;
};

std::string tick(int decade) {
  if (decade < -3 || decade > 4) return fmt::format("1e{}", decade);
  return fmt::format("{:.{}f}", std::pow(10, decade), std::max(0, -decade));
}

void drawGrid(const Axis& x, const Axis& y, SvgPage& page) {
  for (int decade = x.first(); decade <= x.last(); ++decade) {
    const double at = x.at(std::pow(10, decade));
    page.line(at, kTop, at, kHeight - kBottom);
    page.text(at, kHeight - kBottom + 18, tick(decade), {"middle"});
  }
  for (int decade = y.first(); decade <= y.last(); ++decade) {
    const double at = y.at(std::pow(10, decade));
    page.line(kLeft, at, kWidth - kRight, at);
    page.text(kLeft - 8, at + 4, tick(decade), {"end"});
  }
}

void drawSeries(const Series& series, const Axis& x, const Axis& y, bool lines, const char* colour,
                SvgPage& page) {
  std::vector<std::pair<double, double>> places;
  places.reserve(series.points.size());
  for (const auto& [px, py] : series.points)
    places.emplace_back(x.at(px), y.at(py));
  if (lines) page.path(places, colour);
  for (const auto& [px, py] : places)
    page.dot(px, py, colour);
}

// Without what a logarithm can't show; in the order of x.
std::vector<Series> drawable(std::vector<Series> all) {
  for (Series& series : all) {
    auto& points = series.points;
    points.erase(
        std::remove_if(points.begin(), points.end(),
                       [](const auto& point) { return point.first <= 0 || point.second <= 0; }),
        points.end());
    std::sort(points.begin(), points.end());
  }
  return all;
}

}  // namespace

std::string svg(const Plot& plot) {
  const std::vector<Series> all = drawable(plot.series);
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Series& series : all) {
    for (const auto& [x, y] : series.points) {
      xs.push_back(x);
      ys.push_back(y);
    }
  }
  const Axis x(xs, kLeft, kWidth - kRight);
  const Axis y(ys, kHeight - kBottom, kTop);
  const double middle = (kLeft + kWidth - kRight) / 2;
  SvgPage page(kWidth, kHeight);
  drawGrid(x, y, page);
  page.text(middle, 22, plot.title, {"middle", 15});
  page.text(middle, kHeight - 16, plot.x_label, {"middle"});
  page.text(20, (kTop + kHeight - kBottom) / 2, plot.y_label, {"middle", 13, -90});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* colour = cli::plotColour(i);
    drawSeries(all[i], x, y, plot.lines, colour, page);
    const double row = kTop + 10 + 20 * static_cast<double>(i);
    page.dot(kWidth - kRight + 20, row, colour);
    page.text(kWidth - kRight + 32, row + 4, all[i].name);
  }
  return page.document();
}

}  // namespace goal_alignment::benchmarks
