// SPDX-License-Identifier: BSD-3-Clause
#include "bar_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "goal_alignment/cli/svg.h"

namespace goal_alignment::cli {

namespace {

constexpr double kLeft = 76;
constexpr double kRight = 24;
constexpr double kPanelTitle = 34;
constexpr double kPlot = 180;
constexpr double kLegendRow = 20;
constexpr double kMinPlotWidth = 520;
constexpr double kSmall = 11;
constexpr double kLetter = 6.2;  // about as wide as one is at that size
constexpr std::size_t kLongestLabel = 24;
constexpr const char* kInk = "#000000";

double height(const Bar& bar) {
  return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0);
}

/// In letters, not in bytes.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U;
  }));
}

std::string shortened(const std::string& label) {
  if (length(label) <= kLongestLabel) return label;
  std::string result;
  for (std::size_t i = 0; i < label.size() && length(result + label[i]) < kLongestLabel; ++i)
    result += label[i];
  return result + "…";
}

/// From zero in steps of 1, 2 or 5 times a power of ten to at least the largest value.
class Scale {
 public:
  Scale(double most, double top, double bottom) : top_(top), bottom_(bottom) {
    if (!(most > 0)) most = 1;
    const double power = std::pow(10, std::floor(std::log10(most / 4)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
      step_ = factor * power;
      if (step_ * 5 >= most) break;
    }
    steps_ = static_cast<int>(std::ceil(most / step_ - 1e-9));
  }
  double at(double value) const { return bottom_ - value / (step_ * steps_) * (bottom_ - top_); }
  int steps() const { return steps_; }
  double value(int step) const { return step * step_; }
  std::string tick(int step) const {
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step_) + 1e-9)));
    return fmt::format("{:.{}f}", value(step), digits);
  }

 private:
  double top_;
  double bottom_;
  double step_ = 1;
  int steps_ = 1;
};

/// Where things stand, the same for all panels.
struct Layout {
  double bar = 9;
  double group = 0;
  double plot_width = 0;
  double head = 0;        // title and legend
  double labels = 0;      // below each plot
  double first_row = 52;  // of the legend

  explicit Layout(const BarChart& chart);
  double width() const { return kLeft + plot_width + kRight; }
  double panel() const { return kPanelTitle + kPlot + labels; }
};

double legendWidth(const std::string& entry) {
  return 30 + 7.2 * static_cast<double>(length(entry));
}

/// The legend's entries and the place of each, in rows as wide as the plot.
std::vector<std::pair<double, double>> legendPlaces(const BarChart& chart, double width,
                                                    double first_row) {
  std::vector<std::string> entries = chart.legend;
  if (!chart.mark.empty()) entries.push_back(chart.mark);
  std::vector<std::pair<double, double>> places;
  double x = 0;
  double y = first_row;
  for (const std::string& entry : entries) {
    if (x > 0 && x + legendWidth(entry) > width) {
      x = 0;
      y += kLegendRow;
    }
    places.emplace_back(kLeft + x, y);
    x += legendWidth(entry);
  }
  return places;
}

Layout::Layout(const BarChart& chart) {
  std::size_t groups = 1;
  std::size_t bars = 1;
  std::size_t longest = 1;
  for (const BarPanel& panel : chart.panels) {
    groups = std::max(groups, panel.groups.size());
    for (const BarGroup& each : panel.groups) {
      bars = std::max(bars, each.bars.size());
      longest = std::max(longest, length(shortened(each.label)));
    }
  }
  const double gap = 14;
  const auto count = static_cast<double>(bars);
  group = std::max({count * bar + gap, kMinPlotWidth / static_cast<double>(groups), 2 * gap});
  bar = std::min((group - gap) / count, 28.0);
  plot_width = group * static_cast<double>(groups);
  const auto places = legendPlaces(chart, plot_width, first_row);
  head = (places.empty() ? first_row : places.back().second) + 8;
  labels = 26 + std::sqrt(0.5) * kLetter * static_cast<double>(longest);
}

void drawLegend(const BarChart& chart, const Layout& layout, SvgPage& page) {
  const auto places = legendPlaces(chart, layout.plot_width, layout.first_row);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [x, y] = places[i];
    if (i < chart.legend.size())
      page.rectangle(x, y - 10, 11, 11, plotColour(i));
    else
      page.line(x, y - 4, x + 13, y - 4, kInk, 2);
    page.text(x + 17, y, i < chart.legend.size() ? chart.legend[i] : chart.mark);
  }
}

void drawBar(const Bar& bar, double x, double width, const Scale& scale, SvgPage& page) {
  double below = 0;
  for (std::size_t i = 0; i < bar.parts.size(); ++i) {
    const double above = below + bar.parts[i];
    if (above > below)
      page.rectangle(x, scale.at(above), width, scale.at(below) - scale.at(above),
                     plotColour(bar.first + i));
    below = above;
  }
  if (bar.deviation <= 0) return;
  const double middle = x + width / 2;
  const double low = scale.at(std::max(0.0, below - bar.deviation));
  const double high = scale.at(below + bar.deviation);
  page.line(middle, low, middle, high, "#444444");
  for (const double end : {low, high})
    page.line(middle - 2, end, middle + 2, end, "#444444");
}

void drawPanel(const BarPanel& panel, const std::string& y_label, double top, const Layout& layout,
               SvgPage& page) {
  const double bottom = top + kPanelTitle + kPlot;
  double most = 0;
  for (const BarGroup& group : panel.groups) {
    for (const Bar& bar : group.bars)
      most = std::max(most, height(bar) + bar.deviation);
    most = std::max(most, group.mark.value_or(0));
  }
  const Scale scale(most, top + kPanelTitle, bottom);
  page.text(kLeft, top + kPanelTitle - 10, panel.title, {"start", 14});
  page.text(18, bottom - kPlot / 2, y_label, {"middle", 13, -90});
  for (int step = 0; step <= scale.steps(); ++step) {
    const double y = scale.at(scale.value(step));
    page.line(kLeft, y, kLeft + layout.plot_width, y);
    page.text(kLeft - 8, y + 4, scale.tick(step), {"end", kSmall});
  }
  double middle = kLeft + layout.group / 2;
  for (const BarGroup& group : panel.groups) {
    const double width = layout.bar * static_cast<double>(group.bars.size());
    double x = middle - width / 2;
    for (const Bar& bar : group.bars) {
      drawBar(bar, x, layout.bar - 1, scale, page);
      x += layout.bar;
    }
    if (group.mark) {
      const double y = scale.at(*group.mark);
      page.line(middle - width / 2, y, middle + width / 2 - 1, y, kInk, 1.5);
    }
    page.text(middle + 4, bottom + 14, shortened(group.label), {"end", kSmall, -45});
    middle += layout.group;
  }
  page.line(kLeft, bottom, kLeft + layout.plot_width, bottom, "#444444");
}

}  // namespace

std::string svg(const BarChart& chart) {
  const Layout layout(chart);
  const auto panels = static_cast<double>(chart.panels.size());
  SvgPage page(layout.width(), layout.head + panels * layout.panel());
  page.text(kLeft, 26, chart.title, {"start", 16});
  drawLegend(chart, layout, page);
  double top = layout.head;
  for (const BarPanel& panel : chart.panels) {
    drawPanel(panel, chart.y_label, top, layout, page);
    top += layout.panel();
  }
  return page.document();
}

}  // namespace goal_alignment::cli
