// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace goal_alignment::aligner {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Candidate candidate(const std::string& name, const std::vector<std::string>& args, int state) {
  Candidate message;
  message.fluent.name = name;
  message.fluent.args = args;
  message.state = static_cast<std::uint8_t>(state);
  return message;
}

// Frames table and sink, a metre apart, and one for the cup; nobody knows where that is.
Whereabouts kitchen() {
  Whereabouts whereabouts;
  whereabouts.frame_of = [](const std::string& object) -> std::string {
    if (object == "cup") return "cup_link";
    return object == "table" || object == "sink" ? object : "";
  };
  whereabouts.origin = [](const std::string& frame,
                          const std::string& seen_from) -> std::optional<geometry_msgs::Point> {
    if (frame == "cup_link" || seen_from == "cup_link") return std::nullopt;
    geometry_msgs::Point point;
    point.x = frame == "sink" ? 1 : -1;
    return point;
  };
  return whereabouts;
}

std::vector<Marker> ofType(const MarkerArray& array, int type) {
  std::vector<Marker> found;
  std::copy_if(
      array.markers.begin(), array.markers.end(), std::back_inserter(found),
      [&](const Marker& marker) { return marker.action == Marker::ADD && marker.type == type; });
  return found;
}

std::vector<Marker> texts(const MarkerArray& array) {
  return ofType(array, Marker::TEXT_VIEW_FACING);
}

std::vector<Marker> arrows(const MarkerArray& array, const std::string& ns) {
  std::vector<Marker> all = ofType(array, Marker::ARROW);
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const Marker& marker) { return marker.ns != ns; }),
      all.end());
  return all;
}

TEST(Markers, oldOnesAreDeletedFirst) {
  const MarkerArray array = markersOf(AlignmentState{}, Plan{}, kitchen());
  ASSERT_EQ(array.markers.size(), 1U);
  EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
}

TEST(Markers, aCandidateStandsAtTheFrameOfItsObject) {
  AlignmentState state;
  state.candidates = {candidate("clean", {"cup"}, Candidate::OPEN)};
  state.candidates[0].fluent.text = "the cup is clean";
  const auto shown = texts(markersOf(state, Plan{}, kitchen()));
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].header.frame_id, "cup_link");
  EXPECT_TRUE(shown[0].header.stamp.isZero());
  EXPECT_TRUE(shown[0].frame_locked);
  EXPECT_EQ(shown[0].text, "the cup is clean");
  EXPECT_GT(shown[0].color.a, 0);
}

TEST(Markers, whatHasNoFrameIsLeftOut) {
  AlignmentState state;
  state.candidates = {candidate("clean", {"plate"}, Candidate::OPEN),
                      candidate("tea-served", {}, Candidate::SPECIFIED)};
  EXPECT_EQ(markersOf(state, Plan{}, kitchen()).markers.size(), 1U);
}

TEST(Markers, anArrowLeadsToTheNextObject) {
  AlignmentState state;
  state.candidates = {candidate("beside", {"table", "plate", "sink"}, Candidate::OPEN)};
  const MarkerArray array = markersOf(state, Plan{}, kitchen());
  const auto shown = arrows(array, "arrows");
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].header.frame_id, "table");
  ASSERT_EQ(shown[0].points.size(), 2U);
  EXPECT_EQ(shown[0].points[0].x, 0);
  EXPECT_EQ(shown[0].points[1].x, 1);
}

TEST(Markers, whereTheWayIsNotKnownThereIsNoArrow) {
  AlignmentState state;
  state.candidates = {candidate("beside", {"table", "cup"}, Candidate::OPEN)};
  const MarkerArray array = markersOf(state, Plan{}, kitchen());
  EXPECT_TRUE(arrows(array, "arrows").empty());
  EXPECT_EQ(texts(array).size(), 1U);
}

TEST(Markers, linesAtAFrameAreStackedWithWhatMattersOnTop) {
  AlignmentState state;
  state.candidates = {candidate("a", {"table"}, Candidate::SETTLED),
                      candidate("b", {"table"}, Candidate::ASKED),
                      candidate("c", {"table"}, Candidate::WANTED)};
  auto shown = texts(markersOf(state, Plan{}, kitchen()));
  ASSERT_EQ(shown.size(), 3U);
  std::sort(shown.begin(), shown.end(),
            [](const Marker& x, const Marker& y) { return x.pose.position.z > y.pose.position.z; });
  EXPECT_EQ(shown[0].text, "b table");
  EXPECT_EQ(shown[1].text, "c table");
  EXPECT_EQ(shown[2].text, "a table");
  EXPECT_GE(shown[0].pose.position.z - shown[1].pose.position.z, shown[0].scale.z);
}

TEST(Markers, coloursTellStatesApart) {
  std::set<std::vector<float>> colours;
  for (const int state : {Candidate::SPECIFIED, Candidate::ASKED, Candidate::WANTED,
                          Candidate::NOT_WANTED, Candidate::SETTLED}) {
    AlignmentState message;
    message.candidates = {candidate("a", {"table"}, state)};
    const auto colour = texts(markersOf(message, Plan{}, kitchen())).at(0).color;
    colours.insert({colour.r, colour.g, colour.b});
  }
  EXPECT_EQ(colours.size(), 5U);
}

TEST(Markers, aCrowdAtAFrameIsCutShort) {
  AlignmentState state;
  for (int i = 0; i < 1000; ++i)
    state.candidates.push_back(candidate("on" + std::to_string(i), {"table"}, Candidate::OPEN));
  const auto shown = texts(markersOf(state, Plan{}, kitchen()));
  ASSERT_EQ(shown.size(), 8U);
  EXPECT_EQ(shown.back().text, "and 993 more");
}

Plan going() {
  Plan plan;
  plan.session_id = "s";
  plan.plan_id = 1;
  ActionDispatch step;
  step.name = "go";
  step.parameters.resize(2);
  step.parameters[0].value = "table";
  step.parameters[1].value = "sink";
  plan.steps = {step};
  return plan;
}

TEST(Markers, stepsOfThePlanAreShownWithTheirNumber) {
  AlignmentState state;
  state.session_id = "s";
  Plan plan = going();
  MarkerArray array = markersOf(state, plan, kitchen());
  ASSERT_EQ(texts(array).size(), 1U);
  EXPECT_EQ(texts(array)[0].text, "1. go table sink");
  EXPECT_EQ(arrows(array, "arrows").size(), 1U);
  plan.step_texts = {"go from the table to the sink"};
  EXPECT_EQ(texts(markersOf(state, plan, kitchen()))[0].text, "1. go from the table to the sink");
}

TEST(Markers, aPlanOfAnEarlierSessionIsLeftOut) {
  AlignmentState state;
  state.session_id = "another";
  EXPECT_EQ(markersOf(state, going(), kitchen()).markers.size(), 1U);
}

TEST(Markers, eachHasAnIdOfItsOwn) {
  AlignmentState state;
  state.session_id = "s";
  state.candidates = {candidate("a", {"table", "sink"}, Candidate::OPEN),
                      candidate("b", {"sink", "table"}, Candidate::OPEN)};
  const MarkerArray array = markersOf(state, going(), kitchen());
  std::set<int> ids;
  for (const Marker& marker : array.markers)
    EXPECT_TRUE(ids.insert(marker.id).second);
}

}  // namespace
}  // namespace goal_alignment::aligner
