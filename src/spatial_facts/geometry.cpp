// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/geometry.h"

#include <algorithm>
#include <cmath>

namespace goal_alignment::spatial_facts {

namespace {

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// How far a point is outside, from how far it is beyond the faces of each direction.
double outside(double x, double y, double z) {
  const Vector beyond{std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)};
  return length(beyond) + std::min(std::max({x, y, z}), 0.0);
}

}  // namespace

Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double length(const Vector& v) {
  return std::hypot(v.x, v.y, v.z);
}

Pose::Pose(const Vector& xyz, const Vector& rpy) : origin_(xyz) {
  const double cr = std::cos(rpy.x);
  const double sr = std::sin(rpy.x);
  const double cp = std::cos(rpy.y);
  const double sp = std::sin(rpy.y);
  const double cy = std::cos(rpy.z);
  const double sy = std::sin(rpy.z);
  axes_ = {Vector{cy * cp, sy * cp, -sp},
           Vector{cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
           Vector{cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}};
}

Vector Pose::toLocal(const Vector& point) const {
  const Vector offset = point - origin_;
  return {dot(offset, axes_[0]), dot(offset, axes_[1]), dot(offset, axes_[2])};
}

double distanceTo(const Shape& shape, const Vector& point) {
  const Vector p = shape.pose.toLocal(point);
  switch (shape.kind) {
    case Shape::Kind::Box:
      return outside(std::abs(p.x) - shape.size.x / 2, std::abs(p.y) - shape.size.y / 2,
                     std::abs(p.z) - shape.size.z / 2);
    case Shape::Kind::Cylinder:
      return outside(std::hypot(p.x, p.y) - shape.radius, -kAnyHeight,
                     std::abs(p.z) - shape.height / 2);
    case Shape::Kind::Sphere:
      return length(p) - shape.radius;
  }
  return kAnyHeight;
}

double distanceTo(const Region& region, const Vector& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Shape& shape : region.shapes)
    nearest = std::min(nearest, distanceTo(shape, point));
  return nearest;
}

}  // namespace goal_alignment::spatial_facts
