// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/facing_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/proximity/triangles/triangle_pair.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using Kind = FeatureRow::Kind;

const Vec3 small_brick(0.06, 0.04, 0.1);  // m
constexpr double brick_gap = 1e-4;        // m, of the brick above the slab
/// Beside the diagonals of the slab's upper face, along which it may be cut into triangles.
const Vec3 above_slab(0.3, 0.02, 0.15 + brick_gap);

std::shared_ptr<const Body> brick_body() { return test::body(test::box(small_brick)); }
std::shared_ptr<const Body> slab_body() { return test::body(test::box({1, 1, 0.2})); }

/// The gap of each row at X, by row_at (tested by itself).
std::vector<double> gaps_of(const FacingFeatures& features, const Transform& X) {
  std::vector<double> out;
  for (const FeatureRow& row : features.rows()) out.push_back(row_at(row, X, Vec3::Zero()).gap);
  return out;
}

// Reference: by hand.
TEST(FacingFeatures, of_a_box_on_a_slab_are_its_four_corners_each_once) {
  const auto brick = brick_body(), slab = slab_body();
  const Transform X(Mat3::Identity(), above_slab);
  FacingFeatures features(*brick, *slab);
  features.begin(X, 0.08);  // beyond the diagonal of its lower face, not up to the upper one
  const Vec3 corner = above_slab + 0.5 * Vec3(small_brick.x(), small_brick.y(), -small_brick.z());
  const Vec3 below(corner.x(), corner.y(), 0.1);
  EXPECT_GE(features.add_around(corner, below, Vec3::UnitZ()), 4);
  ASSERT_EQ(features.rows().size(), 4u);
  for (const FeatureRow& row : features.rows()) {
    EXPECT_EQ(row.kind, Kind::vertex_on_face);
    EXPECT_EQ(row.along_b, Vec3(Vec3::UnitZ()));
    EXPECT_EQ(row.a.z(), -0.5 * small_brick.z());
    EXPECT_EQ(row.b.z(), 0.1);
  }
  for (const double gap : gaps_of(features, X)) EXPECT_NEAR(gap, brick_gap, 1e-15);
  // Known ones are counted, but not listed again.
  EXPECT_GE(features.add_around(corner, below, Vec3::UnitZ()), 4);
  EXPECT_EQ(features.rows().size(), 4u);
  EXPECT_FALSE(features.overflowed());
  features.begin(X, 0.08);
  EXPECT_TRUE(features.rows().empty());
}

TEST(FacingFeatures, with_the_roles_exchanged_the_faces_are_the_probes) {
  const auto brick = brick_body(), slab = slab_body();
  const Transform X(Mat3::Identity(), -above_slab);
  FacingFeatures features(*slab, *brick);
  features.begin(X, 0.08);
  const Vec3 corner(0.5 * small_brick.x(), 0.5 * small_brick.y(), -0.5 * small_brick.z());
  features.add_around(corner - Vec3(0, 0, brick_gap), corner, -Vec3::UnitZ());
  ASSERT_EQ(features.rows().size(), 4u);
  for (const FeatureRow& row : features.rows()) {
    EXPECT_EQ(row.kind, Kind::face_on_vertex);
    EXPECT_LT((row.along_a + Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_EQ(row.b.z(), -0.5 * small_brick.z());
  }
  for (const double gap : gaps_of(features, X)) EXPECT_NEAR(gap, brick_gap, 1e-15);
}

TEST(FacingFeatures, what_is_further_apart_than_the_reach_or_faces_elsewhere_does_not_count) {
  const auto brick = brick_body(), slab = slab_body();
  const Transform X(Mat3::Identity(), above_slab);
  FacingFeatures features(*brick, *slab);
  const Vec3 corner = above_slab + 0.5 * Vec3(small_brick.x(), small_brick.y(), -small_brick.z());
  const Vec3 below(corner.x(), corner.y(), 0.1);
  features.begin(X, 0.9 * brick_gap);
  EXPECT_EQ(features.add_around(corner, below, Vec3::UnitZ()), 0);
  for (const double tilt : {1e-5, 1e-3}) {  // sine; 1e-4 is what agrees
    features.begin(X, 0.01);
    features.add_around(corner, below, Vec3(tilt, 0, 1).normalized());
    EXPECT_EQ(features.rows().empty(), tilt > 1e-4) << tilt;
  }
  // A corner beside the face lies on none of it.
  const Transform beside(Mat3::Identity(), Vec3(0.5 + 0.031, 0.02, 0.15 + brick_gap));
  features.begin(beside, 0.01);
  features.add_around(beside * (corner - above_slab), {0.5, 0.02, 0.1}, Vec3::UnitZ());
  EXPECT_TRUE(features.rows().empty());
}

PolygonSoup on_edge(PolygonSoup soup, const Vec3& axis) {
  for (Vec3& x : soup.points) x = Eigen::AngleAxisd(std::numbers::pi / 4, axis) * x;
  return soup;
}

// Reference: by hand. Two bars on their edges, one across the other.
TEST(FacingFeatures, of_two_crossed_edges_are_those_edges) {
  const double side = 0.03, down = side / std::sqrt(2.0), gap = 1e-4;
  const auto above = test::body(on_edge(test::box({0.1, side, side}), Vec3::UnitX()));
  const auto under = test::body(on_edge(test::box({side, 0.2, side}), Vec3::UnitY()));
  for (const bool turned : {false, true}) {
    const Quat q(Eigen::AngleAxisd(turned ? std::numbers::pi : 0, Vec3::UnitZ()));
    const Transform X(Pose{q, {0.01, 0.02, 2 * down + gap}});
    FacingFeatures features(*above, *under);
    features.begin(X, 2e-3);
    features.add_around({0, 0.02, down + gap}, {0, 0.02, down}, Vec3::UnitZ());
    ASSERT_EQ(features.rows().size(), 1u);
    const FeatureRow& row = features.rows().front();
    EXPECT_EQ(row.kind, Kind::edge_on_edge);
    EXPECT_NEAR(std::abs(row.along_a.x()), 1, 1e-12);
    EXPECT_NEAR(std::abs(row.along_b.y()), 1, 1e-12);
    const FeatureRowAt at = row_at(row, X, Vec3::Zero());
    EXPECT_NEAR(at.gap, gap, 1e-12);
    EXPECT_LT((at.normal - Vec3::UnitZ()).norm(), 1e-12);
  }
  // Past the end of the lower bar, its edge is not there.
  const Transform past(Mat3::Identity(), Vec3(0, 0.102, 2 * down + gap));
  FacingFeatures features(*above, *under);
  features.begin(past, 2e-3);
  features.add_around({0, 0.102, down + gap}, {0, 0.1, down}, Vec3::UnitZ());
  EXPECT_TRUE(features.rows().empty());
}

// Reference: by hand. The lower edge of a box lies along floor and wall: a contact with the floor
// has the floor alone around it, whatever normal counts the wall as well.
TEST(FacingFeatures, in_a_hollow_those_along_other_normals_count_too) {
  PolygonSoup floor = test::box({1, 1, 0.2});
  const PolygonSoup wall = test::scaled_and_moved(test::box({0.2, 1, 1}), 1, {-0.6, 0, 0.4});
  for (auto polygon : wall.polygons) {
    for (std::size_t& corner : polygon) corner += floor.points.size();
    floor.polygons.push_back(polygon);
  }
  floor.points.insert(floor.points.end(), wall.points.begin(), wall.points.end());
  const auto corner_of_room = test::body(floor);
  const auto brick = brick_body();
  const double above = 1e-4, off = 1.5e-4;
  const Transform X(Mat3::Identity(), Vec3(-0.47 + off, 0.02, 0.15 + above));
  const Vec3 on_probe(-0.5 + off, 0, 0.1 + above), on_floor(-0.5 + off, 0, 0.1);
  FacingFeatures features(*brick, *corner_of_room);
  features.begin(X, 4e-4);
  features.add_around(on_probe, on_floor, Vec3::UnitZ());
  const auto along = [&](const Vec3& n) {
    return std::ranges::count_if(features.rows(), [&](const FeatureRow& row) {
      return row.kind == Kind::vertex_on_face && (row.along_b - n).norm() < 1e-12;
    });
  };
  EXPECT_EQ(along(Vec3::UnitX()), 0);
  features.begin(X, 0.05);
  features.add_hollow(on_probe, on_floor, Vec3(1, 0, 1).normalized());
  EXPECT_GE(along(Vec3::UnitZ()), 2);
  EXPECT_GE(along(Vec3::UnitX()), 2);
  for (const FeatureRow& row : features.rows())
    EXPECT_GT(row_at(row, X, Vec3::Zero()).gap, 0.4 * above);
}

/// The same triangle in the frame of a probe at X, its corners in either order.
std::shared_ptr<const Body> triangle_seen_from(const Pose& X, Corners t, bool reversed) {
  if (reversed) std::swap(t[1], t[2]);
  PolygonSoup out{{}, {{0, 1, 2}}};
  for (const Vec3& x : t) out.points.push_back(inverse(X) * x);
  return test::body(out);
}

// Reference: by hand; the order of corners and the pose of the probe's frame change nothing.
TEST(FacingFeatures, of_two_triangles_have_the_gap_between_them_in_any_order_and_frame) {
  std::mt19937_64 random(1);
  const Corners floor{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)};
  const Corners ridge{Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, -3)};
  const double gap = 0.25;
  const Corners tip{Vec3(0, 0, gap), Vec3(1, 0.5, 3), Vec3(-1, 0.5, 3)};
  const Corners blade{Vec3(0.5, -1, gap), Vec3(1.5, 1, gap), Vec3(0, 0, 4)};
  const Corners below{Vec3(0, 0, 0), Vec3(1, 0.5, -3), Vec3(-1, 0.5, -3)};
  Corners ceiling = floor;
  for (Vec3& x : ceiling) x.z() = gap;
  const struct {
    const Corners &a, &b;
    Kind kind;
  } pairs[] = {{tip, floor, Kind::vertex_on_face},
               {ceiling, below, Kind::face_on_vertex},
               {blade, ridge, Kind::edge_on_edge}};
  for (const auto& pair : pairs)
    for (int i = 0; i < 8; ++i) {
      const Pose X{test::random_rotation(random), test::random_in_ball(random, 1)};
      const auto a = triangle_seen_from(X, pair.a, i & 1);
      const auto b = triangle_seen_from(Pose(), pair.b, i & 2);
      FacingFeatures features(*a, *b);
      features.begin(Transform(X), 1);
      EXPECT_EQ(features.add_pair(0, 0, Vec3::UnitZ()), 1);
      ASSERT_EQ(features.rows().size(), 1u);
      EXPECT_EQ(features.rows().front().kind, pair.kind);
      const FeatureRowAt at = row_at(features.rows().front(), Transform(X), Vec3::Zero());
      EXPECT_NEAR(at.gap, gap, 1e-12);
      EXPECT_LT((at.normal - Vec3::UnitZ()).norm(), 1e-12);
      features.begin(Transform(X), 1);
      EXPECT_EQ(features.add_pair(0, 0, Vec3(1e-3, 1e-3, 1).normalized()), 0);
    }
}

TEST(FacingFeatures, more_triangles_around_a_point_than_there_is_room_for_overflow) {
  const auto ball = test::body(test::sphere(0.1, 12, 100));  // a hundred about its pole
  const auto slab = slab_body();
  FacingFeatures features(*ball, *slab);
  Vec3 pole = Vec3::Zero();
  for (const Vec3& x : surface(*ball).vertices)
    if (x.z() < pole.z()) pole = x;
  const Transform X(Mat3::Identity(), Vec3(0.3, 0.02, 0.1001 - pole.z()));
  features.begin(X, 1e-3);
  features.add_around(X * pole, {0.3, 0.02, 0.1}, Vec3::UnitZ());
  EXPECT_TRUE(features.overflowed());
  features.begin(X, 1e-3);
  EXPECT_FALSE(features.overflowed());
}

TEST(FacingFeatures, does_not_allocate) {
  const auto brick = brick_body(), slab = slab_body();
  FacingFeatures features(*brick, *slab);
  test::AllocationCounter counter;
  features.begin(Transform(Mat3::Identity(), above_slab), 0.08);
  features.add_around(above_slab, above_slab, Vec3::UnitZ());
  features.add_hollow(above_slab, above_slab, Vec3::UnitZ());
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << features.rows().size();
}

}  // namespace
}  // namespace sonde
