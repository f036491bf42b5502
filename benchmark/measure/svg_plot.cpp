// SPDX-License-Identifier: BSD-3-Clause
#include "svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace goal_alignment::benchmarks {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kLeft = 80;
constexpr double kRight = 180;  // for the legend
constexpr double kTop = 40;
constexpr double kBottom = 60;

// Told apart by colour-blind readers too (Okabe and Ito).
constexpr std::array<const char*, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#000000", "#8c6d31"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '<') {
      result += "&lt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else {
      result += letter;
    }
  }
  return result;
}

std::string label(double x, double y, const std::string& text, const std::string& attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes,
                     escaped(text));
}

std::string line(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>\n", x1,
      y1, x2, y2);
}

std::string dot(double x, double y, const std::string& colour) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y, colour);
}

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

std::string grid(const Axis& x, const Axis& y) {
  std::string text;
  for (int decade = x.first(); decade <= x.last(); ++decade) {
    const double at = x.at(std::pow(10, decade));
    text += line(at, kTop, at, kHeight - kBottom);
    text += label(at, kHeight - kBottom + 18, tick(decade), "text-anchor=\"middle\"");
  }
  for (int decade = y.first(); decade <= y.last(); ++decade) {
    const double at = y.at(std::pow(10, decade));
    text += line(kLeft, at, kWidth - kRight, at);
    text += label(kLeft - 8, at + 4, tick(decade), "text-anchor=\"end\"");
  }
  return text;
}

std::string drawn(const Series& series, const Axis& x, const Axis& y, bool lines,
                  const std::string& colour) {
  std::string path;
  std::string dots;
  for (const auto& [px, py] : series.points) {
    path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "" : " ", x.at(px), y.at(py));
    dots += dot(x.at(px), y.at(py), colour);
  }
  if (!lines) return dots;
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n",
                     colour, path) +
         dots;
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
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" "
      "font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  text += grid(x, y);
  text += label(middle, 22, plot.title, "text-anchor=\"middle\" font-size=\"15\"");
  text += label(middle, kHeight - 16, plot.x_label, "text-anchor=\"middle\"");
  text += label(0, 0, plot.y_label,
                fmt::format("text-anchor=\"middle\" transform=\"translate(20 {}) rotate(-90)\"",
                            (kTop + kHeight - kBottom) / 2));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string colour = kColours[i % kColours.size()];
    text += drawn(all[i], x, y, plot.lines, colour);
    const double row = kTop + 10 + 20 * static_cast<double>(i);
    text += dot(kWidth - kRight + 20, row, colour);
    text += label(kWidth - kRight + 32, row + 4, all[i].name, "");
  }
  return text + "</svg>\n";
}

}  // namespace goal_alignment::benchmarks
