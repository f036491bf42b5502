// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

/// Points and regions. Lengths in metres, angles in radians, as everywhere in ROS.
namespace goal_alignment::spatial_facts {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

Vector operator-(const Vector& a, const Vector& b);
double length(const Vector& v);

/// Where a shape stands in its region's frame, as in URDF: fixed-axis roll, pitch, yaw.
class Pose {
 public:
  Pose() = default;
  Pose(const Vector& xyz, const Vector& rpy);

  /// A point of the frame, as the shape sees it.
  Vector toLocal(const Vector& point) const;

 private:
  Vector origin_;
  std::array<Vector, 3> axes_{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
};

constexpr double kAnyHeight = std::numeric_limits<double>::infinity();

/// A box, an upright cylinder or a sphere around its pose.
struct Shape {
  enum class Kind { Box, Cylinder, Sphere };
  Kind kind = Kind::Box;
  Pose pose;
  Vector size;                 ///< of a box; z may be kAnyHeight
  double radius = 0;           ///< of the others
  double height = kAnyHeight;  ///< of a cylinder
};

/// A part of the world that has a name: all its shapes together.
struct Region {
  std::string frame;
  std::vector<Shape> shapes;
};

// How far a point of the frame is outside; inside, negative: how far it is to the nearest face. In
// between shapes that overlap it is the depth in the one it is deepest in.
double distanceTo(const Shape& shape, const Vector& point);
double distanceTo(const Region& region, const Vector& point);

}  // namespace goal_alignment::spatial_facts
