// SPDX-License-Identifier: BSD-3-Clause
#include "region_reader.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::spatial_facts {

namespace {

using Fields = YamlReader::Fields;

constexpr double kLargest = 1e6;  // metres: nothing indoors or out is further away
constexpr double kSmallest = 0.001;
constexpr double kAngle = 7;  // radians: a full turn either way, and its rounding
constexpr std::size_t kMaxShapes = 1000;

std::vector<double> numbers(const YamlReader& reader, const YAML::Node& node,
                            const std::string& what, double low, double high) {
  std::vector<double> result;
  reader.expectList(node, what);
  for (const auto& item : node)
    result.push_back(reader.number(item, what, low, high));
  return result;
}

Vector vectorOf(const YamlReader& reader, const Fields& fields, const std::string& name,
                double largest) {
  const auto field = fields.find(name);
  if (field == fields.end()) return {};
  const std::string what = name + ": three numbers";
  const std::vector<double> v = numbers(reader, field->second, what, -largest, largest);
  if (v.size() != 3) {
    reader.fail(field->second.Mark(), what, fmt::format("{} of them", v.size()));
  }
  return {v[0], v[1], v[2]};
}

const YAML::Node& required(const YamlReader& reader, const Fields& fields, const YAML::Node& of,
                           const std::string& name) {
  const auto field = fields.find(name);
  if (field == fields.end()) reader.fail(of.Mark(), "'" + name + "'", "none");
  return field->second;
}

Vector sizeOf(const YamlReader& reader, const YAML::Node& node) {
  const std::string what = "size: two or three numbers (two: of any height)";
  const std::vector<double> given = numbers(reader, node, what, kSmallest, kLargest);
  if (given.size() != 2 && given.size() != 3) {
    reader.fail(node.Mark(), what, fmt::format("{} of them", given.size()));
  }
  Vector size{given[0], given[1], kAnyHeight};
  if (given.size() == 3) size.z = given[2];
  return size;
}

Pose poseOf(const YamlReader& reader, const Fields& fields) {
  return {vectorOf(reader, fields, "xyz", kLargest), vectorOf(reader, fields, "rpy", kAngle)};
}

Shape readBox(const YamlReader& reader, const YAML::Node& node) {
  const Fields fields = reader.fields(node, "a map with size, xyz, rpy", {"size", "xyz", "rpy"});
  Shape shape;
  shape.kind = Shape::Kind::Box;
  shape.pose = poseOf(reader, fields);
  shape.size = sizeOf(reader, required(reader, fields, node, "size"));
  return shape;
}

double readRadius(const YamlReader& reader, const Fields& fields, const YAML::Node& of) {
  return reader.number(required(reader, fields, of, "radius"), "radius: metres", kSmallest,
                       kLargest);
}

Shape readCylinder(const YamlReader& reader, const YAML::Node& node) {
  const Fields fields = reader.fields(node, "a map with radius, length, xyz, rpy",
                                      {"radius", "length", "xyz", "rpy"});
  Shape shape;
  shape.kind = Shape::Kind::Cylinder;
  shape.pose = poseOf(reader, fields);
  shape.radius = readRadius(reader, fields, node);
  const auto length = fields.find("length");
  if (length != fields.end()) {
    shape.height = reader.number(length->second, "length: metres", kSmallest, kLargest);
  }
  return shape;
}

Shape readSphere(const YamlReader& reader, const YAML::Node& node) {
  const Fields fields = reader.fields(node, "a map with radius, xyz", {"radius", "xyz"});
  Shape shape;
  shape.kind = Shape::Kind::Sphere;
  shape.pose = poseOf(reader, fields);
  shape.radius = readRadius(reader, fields, node);
  return shape;
}

Shape readShape(const YamlReader& reader, const YAML::Node& node, std::string& frame) {
  const char* const what = "a box, a cylinder or a sphere";
  Fields fields = reader.fields(node, what, {"box", "cylinder", "sphere", "frame"});
  const auto stands_in = fields.find("frame");
  if (stands_in != fields.end()) {
    const std::string given = readFrame(reader, stands_in->second);
    if (!frame.empty() && given != frame) {
      reader.fail(stands_in->second.Mark(),
                  "all shapes of a region in one frame, " + inQuotes(frame), inQuotes(given));
    }
    frame = given;
    fields.erase(stands_in);
  }
  if (fields.size() != 1) {
    reader.fail(node.Mark(), what, fields.empty() ? "none" : "more than one: write a list");
  }
  const auto& [kind, shape] = *fields.begin();
  if (kind == "box") return readBox(reader, shape);
  if (kind == "cylinder") return readCylinder(reader, shape);
  return readSphere(reader, shape);
}

}  // namespace

std::string readFrame(const YamlReader& reader, const YAML::Node& node) {
  std::string frame = reader.text(node, "the name of a tf frame");
  // tf2 would refuse it at every look-up.
  if (frame.front() == '/') {
    reader.fail(node.Mark(), "a tf2 frame, which begins with no slash", inQuotes(frame));
  }
  return frame;
}

Region readRegion(const YamlReader& reader, const YAML::Node& node,
                  const std::string& default_frame) {
  Region region;
  if (!node.IsSequence()) {
    region.shapes = {readShape(reader, node, region.frame)};
  } else {
    if (node.size() == 0 || node.size() > kMaxShapes) {
      reader.fail(node.Mark(), fmt::format("1 to {} shapes", kMaxShapes),
                  fmt::format("{}", node.size()));
    }
    // A frame named at any of them is that of all, so that it need not stand at each.
    for (const auto& shape : node)
      region.shapes.push_back(readShape(reader, shape, region.frame));
  }
  if (region.frame.empty()) region.frame = default_frame;
  return region;
}

}  // namespace goal_alignment::spatial_facts
