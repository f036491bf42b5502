// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace goal_alignment::spatial_facts {
namespace {

constexpr double kPi = 3.14159265358979323846;

Shape box(const Vector& size, const Pose& pose = {}) {
  Shape shape;
  shape.size = size;
  shape.pose = pose;
  return shape;
}

Shape cylinder(double radius, double height = kAnyHeight, const Pose& pose = {}) {
  Shape shape;
  shape.kind = Shape::Kind::Cylinder;
  shape.radius = radius;
  shape.height = height;
  shape.pose = pose;
  return shape;
}

// Whole millimetres, so that nothing depends on the last bit.
Vector anyPoint(int most = 10000) {
  const auto one = [most] { return *rc::gen::inRange(-most, most + 1) / 1000.0; };
  const double x = one();
  const double y = one();
  return {x, y, one()};
}

Vector anyAngles() {
  return anyPoint(3141);
}

TEST(Geometry, ABoxIsAsFarAsItsNearestFaceEdgeOrCorner) {
  const Shape shape = box({4, 2, 1});
  EXPECT_DOUBLE_EQ(distanceTo(shape, {0, 0, 0}), -0.5);
  EXPECT_NEAR(distanceTo(shape, {1.9, 0, 0}), -0.1, 1e-12);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {2, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {2.5, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {5, 5, 0}), 5);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {2 + 2, 1 + 3, 0.5 + 6}), 7);
}

TEST(Geometry, ABoxOfTwoNumbersHasAnyHeight) {
  const Shape shape = box({4, 2, kAnyHeight});
  EXPECT_DOUBLE_EQ(distanceTo(shape, {0, 0, 1000}), -1);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {3, 0, -1000}), 1);
}

TEST(Geometry, ACylinderStandsUprightInItsPose) {
  EXPECT_DOUBLE_EQ(distanceTo(cylinder(1), {0, 0, 50}), -1);
  EXPECT_DOUBLE_EQ(distanceTo(cylinder(1), {3, 4, 50}), 4);
  EXPECT_DOUBLE_EQ(distanceTo(cylinder(1, 2), {0, 0, 3}), 2);
  EXPECT_DOUBLE_EQ(distanceTo(cylinder(1, 2), {4, 0, 5}), 5);
  const Shape lying = cylinder(1, 10, {{0, 0, 0}, {0, kPi / 2, 0}});
  EXPECT_NEAR(distanceTo(lying, {4, 0, 0}), -1, 1e-9);
  EXPECT_NEAR(distanceTo(lying, {0, 0, 4}), 3, 1e-9);
}

TEST(Geometry, ASphereIsRoundEachWay) {
  Shape shape;
  shape.kind = Shape::Kind::Sphere;
  shape.radius = 2;
  EXPECT_DOUBLE_EQ(distanceTo(shape, {0, 0, 0}), -2);
  EXPECT_DOUBLE_EQ(distanceTo(shape, {2, 3, 6}), 5);
}

TEST(Geometry, YawTurnsAShapeToTheLeft) {
  const Shape turned = box({4, 1, 1}, {{10, 0, 0}, {0, 0, kPi / 2}});
  EXPECT_NEAR(distanceTo(turned, {10, 1.9, 0}), -0.1, 1e-9);
  EXPECT_NEAR(distanceTo(turned, {11.9, 0, 0}), 1.4, 1e-9);
  const Pose pose({0, 0, 0}, {0, 0, kPi / 2});
  const Vector ahead = pose.toLocal({0, 1, 0});
  EXPECT_NEAR(ahead.x, 1, 1e-12);
  EXPECT_NEAR(ahead.y, 0, 1e-12);
}

TEST(Geometry, ARegionIsAllItsShapes) {
  Region region;
  region.shapes = {box({2, 2, 2}), box({2, 2, 2}, {{10, 0, 0}, {}})};
  EXPECT_DOUBLE_EQ(distanceTo(region, {0, 0, 0}), -1);
  EXPECT_DOUBLE_EQ(distanceTo(region, {10, 0, 0}), -1);
  EXPECT_DOUBLE_EQ(distanceTo(region, {3, 0, 0}), 2);
}

RC_GTEST_PROP(Geometry, APoseKeepsDistancesAndMovesItsOriginToZero, ()) {
  const Vector origin = anyPoint();
  const Pose pose(origin, anyAngles());
  RC_ASSERT(length(pose.toLocal(origin)) < 1e-9);
  const Vector a = anyPoint();
  const Vector b = anyPoint();
  RC_ASSERT(std::abs(length(a - b) - length(pose.toLocal(a) - pose.toLocal(b))) < 1e-9);
}

// Roll about x, then pitch about y, then yaw about z, all of them fixed, as URDF says.
RC_GTEST_PROP(Geometry, APoseIsThreeTurnsOneAfterTheOther, ()) {
  const Vector rpy = anyAngles();
  const Vector point = anyPoint();
  const Vector whole = Pose({}, rpy).toLocal(point);
  const Vector yawed = Pose({}, {0, 0, rpy.z}).toLocal(point);
  const Vector pitched = Pose({}, {0, rpy.y, 0}).toLocal(yawed);
  const Vector rolled = Pose({}, {rpy.x, 0, 0}).toLocal(pitched);
  RC_ASSERT(length(whole - rolled) < 1e-9);
}

// A step can't bring a point further away, or nearer, than the step is long.
RC_GTEST_PROP(Geometry, ADistanceChangesByNoMoreThanTheStep, ()) {
  const Pose pose(anyPoint(), anyAngles());
  const auto positive = [] { return *rc::gen::inRange(1, 5000) / 1000.0; };
  const double a = positive();
  const double b = positive();
  const double c = positive();
  Region region;
  region.shapes = {box({a, b, c}, pose), cylinder(a, b, pose), box({b, c, kAnyHeight}, pose)};
  const Vector from = anyPoint();
  const Vector to = anyPoint();
  RC_ASSERT(std::abs(distanceTo(region, from) - distanceTo(region, to)) <=
            length(from - to) + 1e-9);
}

}  // namespace
}  // namespace goal_alignment::spatial_facts
