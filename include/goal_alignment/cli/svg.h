// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace goal_alignment::cli {

/// Eight colours that colour-blind readers tell apart, too (Okabe and Ito); they repeat from there.
const char* plotColour(std::size_t index);

/// How a text stands on the page.
struct SvgText {
  const char* anchor = "start";  ///< or middle, end
  double size = 13;
  double turned = 0;  ///< degrees, clockwise, around the place that is given
};

/// A drawing, as an SVG document without fonts or files of others. Places in pixels from the upper
/// left corner; what is drawn later covers what was drawn before.
class SvgPage {
 public:
  SvgPage(double width, double height);

  void text(double x, double y, const std::string& text, const SvgText& style = {});
  void line(double x1, double y1, double x2, double y2, const char* colour = "#dddddd",
            double width = 1);
  void rectangle(double x, double y, double width, double height, const char* colour);
  void dot(double x, double y, const char* colour);
  void path(const std::vector<std::pair<double, double>>& points, const char* colour);

  std::string document() const;

 private:
  std::string body_;
};

}  // namespace goal_alignment::cli
