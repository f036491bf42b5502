// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/svg.h"

#include <array>

#include <fmt/format.h>

namespace goal_alignment::cli {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '<') {
      result += "&lt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else if (static_cast<unsigned char>(letter) < ' ') {
      result += ' ';  // XML has no control characters
    } else {
      result += letter;
    }
  }
  return result;
}

}  // namespace

const char* plotColour(std::size_t index) {
  constexpr std::array<const char*, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                   "#e69f00", "#56b4e9", "#000000", "#8c6d31"};
  return kColours[index % kColours.size()];
}

SvgPage::SvgPage(double width, double height)
    : body_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
                        "font-family=\"sans-serif\" font-size=\"13\">\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                        width, height)) {}

void SvgPage::text(double x, double y, const std::string& text, const SvgText& style) {
  const std::string place =
      style.turned == 0 ? fmt::format("x=\"{:.1f}\" y=\"{:.1f}\"", x, y)
                        : fmt::format("transform=\"translate({:.1f} {:.1f}) rotate({:.0f})\"", x, y,
                                      style.turned);
  body_ += fmt::format("<text {} text-anchor=\"{}\" font-size=\"{:.0f}\">{}</text>\n", place,
                       style.anchor, style.size, escaped(text));
}

void SvgPage::line(double x1, double y1, double x2, double y2, const char* colour, double width) {
  body_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"{:.1f}\"/>\n",
      x1, y1, x2, y2, colour, width);
}

void SvgPage::rectangle(double x, double y, double width, double height, const char* colour) {
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{:.1f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", x, y,
      width, height, colour);
}

void SvgPage::dot(double x, double y, const char* colour) {
  body_ +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y, colour);
}

void SvgPage::path(const std::vector<std::pair<double, double>>& points, const char* colour) {
  std::string places;
  for (const auto& [x, y] : points)
    places += fmt::format("{}{:.1f},{:.1f}", places.empty() ? "" : " ", x, y);
  body_ +=
      fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n",
                  colour, places);
}

std::string SvgPage::document() const {
  return body_ + "</svg>\n";
}

}  // namespace goal_alignment::cli
