// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/boxes/box_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "engine/proximity/boxes/sweep_lanes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Boxes of all shapes, thin ones and points among them, in random places.
struct Boxes {
  Tree::Node node{};
  PlacedBox one;
};

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Mat3 turn(std::mt19937_64& random) { return test::random_rotation(random).toRotationMatrix(); }

float side(std::mt19937_64& random) {
  return random() % 4 == 0 ? 0.0f : static_cast<float>(uniform(random, 0, 0.5));
}

Boxes random_boxes(std::mt19937_64& random) {
  Boxes out;
  for (std::uint32_t k = 0; k < Tree::width; ++k) {
    const Mat3 R = turn(random);
    for (int i = 0; i < 3; ++i) {
      out.node.center[i][k] = static_cast<float>(uniform(random, -1, 1));
      out.node.half[i][k] = side(random);
      for (int a = 0; a < 2; ++a) out.node.axis[a][i][k] = static_cast<float>(R(i, a));
    }
    out.node.child[k] = k;
  }
  const Mat3 R = turn(random);
  const Vec3 n = turn(random).col(0);
  for (int i = 0; i < 3; ++i) {
    out.one.origin[i] = static_cast<float>(uniform(random, -1, 1));
    out.one.center[i] = static_cast<float>(uniform(random, -1, 1)) - out.one.origin[i];
    out.one.half[i] = side(random);
    out.one.direction[i] = static_cast<float>(n[i]);
    out.one.shift[i] = static_cast<float>(uniform(random, -0.5, 0.5));
    for (int a = 0; a < 3; ++a) out.one.axis[a][i] = static_cast<float>(R(i, a));
  }
  return out;
}

Vec3 center(const PlacedBox& box) {
  Vec3 x;
  for (int i = 0; i < 3; ++i)
    x[i] = static_cast<double>(box.origin[i]) + static_cast<double>(box.center[i]);
  return x;
}

/// A corner, or any other point, of a box: u in [-1, 1]³.
Vec3 point_of(const PlacedBox& box, const Vec3& u) {
  Vec3 x = center(box);
  for (int a = 0; a < 3; ++a)
    x += u[a] * box.half[a] * Vec3(box.axis[a][0], box.axis[a][1], box.axis[a][2]);
  return x;
}
Vec3 point_of(const Tree::Node& node, std::uint32_t k, const Vec3& u) {
  const auto at = [k](const float(&rows)[3][Tree::width]) {
    return Vec3(rows[0][k], rows[1][k], rows[2][k]);
  };
  const Vec3 a = at(node.axis[0]), b = at(node.axis[1]), half = at(node.half);
  return at(node.center) + u[0] * half[0] * a + u[1] * half[1] * b + u[2] * half[2] * a.cross(b);
}

Vec3 anywhere(std::mt19937_64& random) {
  Vec3 u(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  if (random() % 2 == 0)
    for (int i = 0; i < 3; ++i) u[i] = u[i] < 0 ? -1 : 1;
  return u;
}

/// What is taken off for rounding at most: |d| along the axes reaches 6, sizes 1.5 each.
constexpr double taken_off = box_rounding * 9;

// Reference: points of the boxes, in double precision. The nearest of many bounds from above.
TEST(BoxLanes, no_two_points_are_nearer_than_the_bound) {
  std::mt19937_64 random(1);
  int separated = 0;
  for (int i = 0; i < 300; ++i) {
    const Boxes boxes = random_boxes(random);
    Lanes distances, gaps;
    box_kernels().distances(boxes.one, boxes.node, 1, distances);
    box_kernels().gaps(boxes.one, boxes.node, 1, gaps);
    for (std::uint32_t k = 0; k < Tree::width; ++k) {
      double nearest = 1e30;
      for (int p = 0; p < 200; ++p)
        nearest = std::min(nearest, (point_of(boxes.one, anywhere(random)) -
                                     point_of(boxes.node, k, anywhere(random)))
                                        .norm());
      EXPECT_LE(distances.value[k], nearest);
      EXPECT_LE(gaps.value[k], nearest);
      EXPECT_LE(gaps.value[k], distances.value[k]);
      separated += distances.value[k] > 0;
    }
  }
  EXPECT_GT(separated, 1000);
}

// Reference: points of the boxes, in double precision, anywhere along the shift.
TEST(BoxLanes, no_two_points_come_nearer_along_the_shift_than_the_bound) {
  std::mt19937_64 random(5);
  int separated = 0, as_far = 0;
  for (int i = 0; i < 300; ++i) {
    Boxes boxes = random_boxes(random);
    const Vec3 shift(boxes.one.shift[0], boxes.one.shift[1], boxes.one.shift[2]);
    Lanes shifted, standing;
    box_kernels().gaps_shifted(boxes.one, boxes.node, 1, shifted);
    box_kernels().gaps(boxes.one, boxes.node, 1, standing);
    for (std::uint32_t k = 0; k < Tree::width; ++k) {
      double nearest = 1e30;
      for (int p = 0; p < 200; ++p)
        nearest = std::min(nearest,
                           (point_of(boxes.one, anywhere(random)) + uniform(random, 0, 1) * shift -
                            point_of(boxes.node, k, anywhere(random)))
                               .norm());
      EXPECT_LE(shifted.value[k], nearest);
      EXPECT_LE(shifted.value[k], standing.value[k]);
      separated += shifted.value[k] > 0;
      // What leads away or along takes nothing off but rounding.
      as_far += shifted.value[k] > 0 && standing.value[k] - shifted.value[k] < 1e-4f;
    }
  }
  EXPECT_GT(separated, 1000);
  EXPECT_GT(as_far, 200);
}

// Reference: the distance of a point from a box in double precision, in the box's own axes.
TEST(BoxLanes, point_distances_are_those_of_the_boxes) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const Boxes boxes = random_boxes(random);
    const Vec3 x = center(boxes.one);
    PlacedPoint point;
    std::copy_n(boxes.one.origin, 3, point.origin);
    std::copy_n(boxes.one.center, 3, point.rest);
    Lanes out;
    box_kernels().point_distances(point, boxes.node, 1, out);
    for (std::uint32_t k = 0; k < Tree::width; ++k) {
      const Vec3 center = point_of(boxes.node, k, Vec3::Zero());
      Vec3 outside;
      for (int a = 0; a < 3; ++a) {
        const double half = boxes.node.half[a][k];
        // The axis, from the boxes' own points: of a flat box it is the product of the others.
        Vec3 axis = Vec3::Zero();
        for (int c = 0; c < 3; ++c)
          if (a < 2) axis[c] = boxes.node.axis[a][c][k];
        if (a == 2) {
          const auto at = [&](int b) {
            return Vec3(boxes.node.axis[b][0][k], boxes.node.axis[b][1][k],
                        boxes.node.axis[b][2][k]);
          };
          axis = at(0).cross(at(1));
        }
        outside[a] = std::max(0.0, std::abs(axis.dot(x - center)) - half);
      }
      EXPECT_LE(out.value[k], outside.norm());
      EXPECT_GE(out.value[k], outside.norm() - 2 * taken_off);
    }
  }
}

// Reference: points along the ray that lie in the box.
TEST(BoxLanes, a_ray_through_a_box_has_no_gap) {
  std::mt19937_64 random(3);
  std::ptrdiff_t missed = 0;
  for (int i = 0; i < 300; ++i) {
    const Boxes boxes = random_boxes(random);
    for (std::uint32_t k = 0; k < Tree::width; ++k) {
      const Vec3 x = center(boxes.one);
      const Vec3 way = point_of(boxes.node, k, anywhere(random)) - x;
      PlacedRay ray;
      for (int c = 0; c < 3; ++c) {
        ray.from.origin[c] = boxes.one.origin[c];
        ray.from.rest[c] = boxes.one.center[c];
        ray.direction[c] = static_cast<float>(way.normalized()[c]);
      }
      Lanes out;
      box_kernels().ray_gaps(ray, boxes.node, 1, out);
      EXPECT_LE(out.value[k], 0);
      missed +=
          std::count_if(out.value, out.value + Tree::width, [](float gap) { return gap > 0; });
    }
  }
  EXPECT_GT(missed, 1000);  // it is not that all are hit
}

TEST(BoxLanes, lanes_at_most_the_limit_are_the_used_ones) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    Boxes boxes = random_boxes(random);
    const auto used = static_cast<std::uint32_t>(1 + random() % Tree::width);
    for (std::uint32_t k = used; k < Tree::width; ++k) boxes.node.child[k] = Tree::none;
    Lanes x;
    for (float& value : x.value) value = static_cast<float>(uniform(random, -1, 1));
    const std::uint32_t found = at_most(x, 0.25f, boxes.node);
    for (std::uint32_t k = 0; k < 32; ++k)
      EXPECT_EQ(found >> k & 1u, k < used && x.value[k % Tree::width] <= 0.25f) << k;
  }
}

TEST(BoxLanes, every_instruction_set_gives_the_same_bits) {
  std::mt19937_64 random(5);
  EXPECT_GE(all_box_kernels().size(), 1u);
  for (int i = 0; i < 2000; ++i) {
    const Boxes boxes = random_boxes(random);
    PlacedPoint point;
    PlacedRay ray;
    std::copy_n(boxes.one.origin, 3, point.origin);
    std::copy_n(boxes.one.center, 3, point.rest);
    ray.from = point;
    std::copy_n(boxes.one.direction, 3, ray.direction);
    PlacedVelocity velocity;
    PathBounds path{};
    for (int c = 0; c < 3; ++c) {
      velocity.at_origin[c] = static_cast<float>(uniform(random, -1, 1));
      velocity.angular[c] = static_cast<float>(uniform(random, -1, 1));
      path.com[c] = static_cast<float>(uniform(random, -1, 1));
    }
    path.acceleration = static_cast<float>(uniform(random, 0, 1));
    path.clearance = 1e-3f;
    Lanes expected[7], got[7];
    const auto fill = [&](const BoxKernels& box, const SweepKernels& sweep, Lanes(&out)[7]) {
      box.distances(boxes.one, boxes.node, 0.5f, out[0]);
      box.gaps(boxes.one, boxes.node, 0.5f, out[1]);
      box.point_distances(point, boxes.node, 0.5f, out[2]);
      box.ray_gaps(ray, boxes.node, 0.5f, out[3]);
      sweep.box_moves(boxes.one, velocity, path, boxes.node, 0.5f, out[4]);
      sweep.node_moves(boxes.one, velocity, path, boxes.node, 0.5f, out[5]);
      box.gaps_shifted(boxes.one, boxes.node, 0.5f, out[6]);
    };
    fill(all_box_kernels()[0], all_sweep_kernels()[0], expected);
    for (std::size_t set = 1; set < all_box_kernels().size(); ++set) {
      fill(all_box_kernels()[set], all_sweep_kernels()[set], got);
      ASSERT_EQ(std::memcmp(expected, got, sizeof got), 0) << "set " << set;
    }
  }
}

}  // namespace
}  // namespace sonde
