// SPDX-License-Identifier: BSD-3-Clause
#include "markers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace goal_alignment::aligner {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Metres.
constexpr double kTextHeight = 0.14;
constexpr double kLineHeight = 0.19;
constexpr double kLowestText = 0.5;
constexpr double kPointerTop = 0.4;
constexpr double kPointerTip = 0.12;
constexpr double kShaft = 0.025;
constexpr double kHead = 0.07;
constexpr double kHeadLength = 0.12;

constexpr std::size_t kLinesAtAFrame = 8;  // more can't be read
constexpr int kStepRank = -1;              // on top of all candidates

struct Colour {
  float red, green, blue;
};

constexpr Colour kWhite{0.92F, 0.92F, 0.92F};
constexpr Colour kGrey{0.6F, 0.6F, 0.6F};
constexpr Colour kBlue{0.42F, 0.7F, 0.97F};
constexpr Colour kGreen{0.45F, 0.79F, 0.51F};
constexpr Colour kRed{0.95F, 0.55F, 0.51F};
constexpr Colour kAmber{0.95F, 0.75F, 0.35F};

// What is said at a frame.
struct Line {
  int rank;  // the lowest is on top
  std::string text;
  Colour colour;
};

Colour colourOf(std::uint8_t state) {
  switch (state) {
    case Candidate::SPECIFIED:
      return kWhite;
    case Candidate::ASKED:
    case Candidate::OPEN:
    case Candidate::UNSURE:
      return kAmber;
    case Candidate::WANTED:
      return kGreen;
    case Candidate::NOT_WANTED:
      return kRed;
    default:
      return kGrey;
  }
}

int rankOf(std::uint8_t state) {
  constexpr std::uint8_t kOrder[] = {Candidate::ASKED,  Candidate::OPEN,       Candidate::UNSURE,
                                     Candidate::WANTED, Candidate::NOT_WANTED, Candidate::SPECIFIED,
                                     Candidate::SETTLED};
  return static_cast<int>(std::find(std::begin(kOrder), std::end(kOrder), state) -
                          std::begin(kOrder));
}

std::string textOf(const Fluent& fluent) {
  if (!fluent.text.empty()) return fluent.text;
  std::string text = fluent.name;
  for (const std::string& arg : fluent.args)
    text += " " + arg;
  return fluent.negated != 0 ? "not " + text : text;
}

std::string stepText(const Plan& plan, std::size_t index) {
  const ActionDispatch& step = plan.steps[index];
  std::string text = step.name;
  for (const auto& parameter : step.parameters)
    text += " " + parameter.value;
  const bool spoken = index < plan.step_texts.size() && !plan.step_texts[index].empty();
  return fmt::format("{}. {}", index + 1, spoken ? plan.step_texts[index] : text);
}

class Drawing {
 public:
  explicit Drawing(const Whereabouts& whereabouts) : whereabouts_(whereabouts) {
    Marker clear;
    clear.action = Marker::DELETEALL;
    array_.markers.push_back(clear);
  }

  void add(Line line, const std::vector<std::string>& objects) {
    std::vector<std::string> frames;
    for (const std::string& object : objects) {
      std::string frame = whereabouts_.frame_of(object);
      const bool known = std::find(frames.begin(), frames.end(), frame) != frames.end();
      if (!frame.empty() && !known) frames.push_back(std::move(frame));
    }
    if (frames.empty()) return;
    for (std::size_t i = 1; i < frames.size(); ++i)
      connect(frames[i - 1], frames[i], line.colour);
    lines_[frames.front()].push_back(std::move(line));
  }

  MarkerArray finish() {
    for (auto& [frame, lines] : lines_) {
      std::stable_sort(lines.begin(), lines.end(),
                       [](const Line& a, const Line& b) { return a.rank < b.rank; });
      point(frame, lines.front().colour);
      write(frame, lines);
    }
    return std::move(array_);
  }

 private:
  Marker marker(const std::string& frame, const char* ns, int type, Colour colour) {
    Marker marker;
    marker.header.frame_id = frame;  // a zero stamp: wherever the frame is now
    marker.frame_locked = 1;
    marker.ns = ns;
    marker.id = ++last_id_;
    marker.type = type;
    marker.action = Marker::ADD;
    marker.pose.orientation.w = 1;
    marker.color.r = colour.red;
    marker.color.g = colour.green;
    marker.color.b = colour.blue;
    marker.color.a = 1;
    return marker;
  }

  void addArrow(const std::string& frame, const char* ns, const geometry_msgs::Point& from,
                const geometry_msgs::Point& to, Colour colour) {
    Marker arrow = marker(frame, ns, Marker::ARROW, colour);
    arrow.points = {from, to};
    arrow.scale.x = kShaft;
    arrow.scale.y = kHead;
    arrow.scale.z = kHeadLength;
    array_.markers.push_back(std::move(arrow));
  }

  // What stands above an object points down at it.
  void point(const std::string& frame, Colour colour) {
    geometry_msgs::Point from;
    geometry_msgs::Point to;
    from.z = kPointerTop;
    to.z = kPointerTip;
    addArrow(frame, "pointers", from, to, colour);
  }

  void connect(const std::string& from, const std::string& to, Colour colour) {
    const auto end = whereabouts_.origin(to, from);
    if (end) addArrow(from, "arrows", geometry_msgs::Point(), *end, colour);
  }

  void write(const std::string& frame, std::vector<Line>& lines) {
    if (lines.size() > kLinesAtAFrame) {
      const std::size_t left_out = lines.size() - kLinesAtAFrame + 1;
      lines.resize(kLinesAtAFrame - 1);
      lines.push_back({0, fmt::format("and {} more", left_out), kGrey});
    }
    double height = kLowestText + kLineHeight * static_cast<double>(lines.size() - 1);
    for (const Line& line : lines) {
      Marker text = marker(frame, "texts", Marker::TEXT_VIEW_FACING, line.colour);
      text.pose.position.z = height;
      text.scale.z = kTextHeight;
      text.text = line.text;
      array_.markers.push_back(std::move(text));
      height -= kLineHeight;
    }
  }

  const Whereabouts& whereabouts_;
  MarkerArray array_;
  std::map<std::string, std::vector<Line>> lines_;
  int last_id_ = 0;
};

}  // namespace

MarkerArray markersOf(const AlignmentState& state, const Plan& plan,
                      const Whereabouts& whereabouts) {
  Drawing drawing(whereabouts);
  for (const Candidate& candidate : state.candidates) {
    drawing.add({rankOf(candidate.state), textOf(candidate.fluent), colourOf(candidate.state)},
                candidate.fluent.args);
  }
  const bool current = plan.session_id == state.session_id;
  for (std::size_t i = 0; current && i < plan.steps.size(); ++i) {
    std::vector<std::string> objects;
    for (const auto& parameter : plan.steps[i].parameters)
      objects.push_back(parameter.value);
    drawing.add({kStepRank, stepText(plan, i), kBlue}, objects);
  }
  return drawing.finish();
}

}  // namespace goal_alignment::aligner
