// SPDX-License-Identifier: GPL-3.0-or-later
// Static searches at the extremes. The reference is geometry by hand: a box that lies flat in a
// plate comes out straight up by as much as it is in; any probe within a ball about its centre of
// mass, deep in a box, must come out to the nearest face.
#include <algorithm>
#include <cfenv>
#include <limits>
#include <numbers>
#include <random>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "engine/text/number_text.hpp"
#include "tests/extremes/press.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::brick;
using test::expect_depth;
using test::plate;

PolygonSoup scaled(PolygonSoup soup, double scale, const Vec3& offset = Vec3::Zero()) {
  for (Vec3& x : soup.points) x = scale * x + offset;
  return soup;
}

Pose flat_in_plate(double deep, double scale = 1) {
  return {Quat::Identity(), scale * Vec3(0.02, -0.01, 0.5 + 0.03 - deep)};
}

TEST(Extremes, sizes_from_1e_minus_9_to_1e9) {
  for (const double size : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
    const Pair pair(test::body(scaled(test::box(brick), size)),
                    test::body(scaled(test::box(plate), size)));
    expect_depth("size " + number_text(size), pair, flat_in_plate(0.01, size), 0.01 * size);
  }
}

// Coordinates are rounded by ε times the offset: that much the reference itself is worth.
TEST(Extremes, offsets_up_to_1e8_sizes) {
  for (const double offset : {1e2, 1e4, 1e6, 1e8}) {
    const Vec3 away = 0.1 * offset * Vec3(1, -2, 0.5).normalized();
    const Pair pair(test::body(scaled(test::box(brick), 1, away)),
                    test::body(scaled(test::box(plate), 1, away)));
    Pose pose = flat_in_plate(0.01);
    const Separation s = separate_static(pair, pose);
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * offset;
    if (s.status == Status::failed) {  // a flag is an answer, too
      std::printf("  offset %g: %s\n", offset, s.reason);
      continue;
    }
    EXPECT_EQ(s.status, Status::penetrating) << offset;
    EXPECT_NEAR(s.depth, 0.01, 2e-6 + rounding) << offset;
    EXPECT_LE(s.lower_bound.value_or(0), 0.01 + rounding) << offset;
    std::printf("  offset %-37g %10.3g %10.2g %10.2g\n", offset, 0.01, s.depth / 0.01 - 1,
                s.lower_bound.value_or(0) / 0.01);
  }
}

TEST(Extremes, ratios_of_sizes_up_to_1e5) {
  for (const double ratio : {1e2, 1e3, 1e5}) {
    const Pair pair(test::body(test::box(brick)),
                    test::body(scaled(test::box({1, 1, 1}), 0.1 * ratio)));
    const double top = 0.05 * ratio;
    expect_depth("ratio " + number_text(ratio), pair,
                 {Quat::Identity(), Vec3(0, 0, top + 0.03 - 0.01)}, 0.01);
  }
}

TEST(Extremes, depths_of_1e_minus_12_and_of_10_sizes) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box(plate)));
  for (const double depth : {1e-2, 1e-4, 1e-6})
    expect_depth("depth " + number_text(depth), pair, flat_in_plate(depth), depth);
  // Less than the clearance: contact, and no more than that.
  const Separation least = separate_static(pair, flat_in_plate(1e-12));
  EXPECT_EQ(least.status, Status::penetrating);
  EXPECT_LE(least.depth, 2e-9);
  // A small probe 10 of its sizes under the face.
  const auto small = test::body(scaled(test::box(brick), 0.2));
  const double half = 0.2 * 0.03;
  expect_depth("ten sizes deep", {small, test::body(test::box(plate))},
               {Quat::Identity(), Vec3(0, 0, 0.5 - 0.2)}, 0.2 + half);
}

TEST(Extremes, exact_touch_is_contact_without_depth) {
  const auto cube = test::body(test::box({1, 1, 1}));
  for (const Vec3& at : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    const Separation s = separate_static({cube, cube}, {Quat::Identity(), at});
    EXPECT_EQ(s.status, Status::penetrating);
    EXPECT_LE(s.depth, 1e-8);
    EXPECT_EQ(s.lower_bound, 0);
  }
}

TEST(Extremes, faces_that_say_nothing_new) {
  const auto wall = test::body(test::box(plate));
  const auto with = [](auto change) {
    PolygonSoup soup = test::box(brick);
    change(soup);
    return soup;
  };
  const std::pair<const char*, PolygonSoup> probes[] = {
      {"every face twice", with([](PolygonSoup& s) {
         const auto faces = s.polygons;
         s.polygons.insert(s.polygons.end(), faces.begin(), faces.end());
       })},
      {"every face a thousand times", with([](PolygonSoup& s) {
         const auto faces = s.polygons;
         for (int i = 1; i < 1000; ++i)
           s.polygons.insert(s.polygons.end(), faces.begin(), faces.end());
       })},
      {"inside out", with([](PolygonSoup& s) {
         for (auto& face : s.polygons) std::ranges::reverse(face);
       })},
      {"faces without area", with([](PolygonSoup& s) {
         s.polygons.push_back({0, 1, 1});
         s.polygons.push_back({2, 2, 2});
       })}};
  for (const auto& [name, soup] : probes)
    expect_depth(name, {test::body(soup), wall}, flat_in_plate(0.01), 0.01);
}

// Reference: the centre of mass of both is as deep as the pose says, and has to come out. The cap
// lies flat, so that is enough; the needle stands on end, and its own length is.
TEST(Extremes, needles_and_caps_of_aspect_1e10) {
  const auto wall = test::body(test::box(plate));
  const auto needle = test::body({{{0, 0, 0}, {0, 1e-11, 0.1}, {0, 0, 0.1}}, {{0, 1, 2}}});
  const auto cap = test::body({{{-0.05, 0, 0}, {0.05, 0, 0}, {0, 0, -1e-11}}, {{0, 1, 2}}});
  expect_depth("cap of aspect 1e10", {cap, wall}, {Quat::Identity(), Vec3(0.02, 0, 0.49)}, 0.01);
  const Separation s = separate_static({needle, wall}, {Quat::Identity(), Vec3(0.02, 0, 0.42)});
  ASSERT_EQ(s.status, Status::penetrating);
  EXPECT_GE(s.depth, (0.5 - 0.42 - 0.1 * 2 / 3) * (1 - 1e-6));
  EXPECT_LE(s.depth, 0.08 * (1 + 1e-4));
  EXPECT_LE(s.lower_bound.value_or(0), s.depth);
  EXPECT_FALSE(overlap(*needle, *wall, Transform(s.separated), Doubt::exact));
}

TEST(Extremes, one_triangle_through_one_triangle) {
  const auto flat = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const auto upright = test::body({{{-0.2, 0, -0.5}, {0.2, 0, -0.5}, {0, 0, 0.1}}, {{0, 1, 2}}});
  const Separation s = separate_static({upright, flat}, {});
  EXPECT_EQ(s.status, Status::penetrating);
  EXPECT_LE(s.depth, 0.1 * (1 + 1e-4));  // the tip sticks out by that
  EXPECT_FALSE(s.lower_bound);
}

// Reference: no two cubes of one centre are apart before the one has gone half a side at least (the
// centre must come out), and a whole side is enough.
TEST(Extremes, identical_bodies_at_one_pose_and_nested_ones) {
  const auto cube = test::body(test::box({1, 1, 1})), small = test::body(test::box(brick));
  const Separation same = separate_static({cube, cube}, {});
  EXPECT_LE(same.depth, 1 + 1e-4);
  EXPECT_GE(same.depth, 0.5);
  const Separation nested = separate_static({small, cube}, {});
  EXPECT_GE(nested.depth, 0.5);  // its centre of mass has to come to the face
  EXPECT_LE(nested.depth, 0.53 * (1 + 1e-4));
  EXPECT_LE(nested.lower_bound.value_or(0), nested.depth);
}

// Reference: the same body, turned by itself: a brick turned by π about an axis of its own is the
// same brick.
TEST(Extremes, turns_next_to_pi) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box(plate)));
  for (const double off : {0.0, 1e-16, 1e-12, 1e-9})
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      Pose pose = flat_in_plate(0.01);
      pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi - off, axis));
      expect_depth("turn of pi less " + number_text(off), pair, pose, 0.01);
    }
}

TEST(Extremes, flat_and_line_like_probes) {
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  const auto needle = test::body({{{0, 0, 0}, {0.2, 0, 0}, {0.2, 1e-10, 0}}, {{0, 1, 2}}});
  const auto leaf = test::body(test::box({0.1, 0.15, 0}));
  for (const auto& probe : {needle, leaf}) {
    const Pose flat{Quat::Identity(), Vec3(0.05, 0.03, 0.045) - probe->mass.com};
    expect_depth("lies 5 mm under the face", {probe, block}, flat, 0.005);
  }
}

// Reference: the answer of the same build in round-to-nearest, without flushing.
TEST(Extremes, a_host_program_s_rounding_and_flushing) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box(plate)));
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const Separation s = separate_static(pair, flat_in_plate(0.01));
    std::fesetround(FE_TONEAREST);
    EXPECT_NEAR(s.depth, 0.01, 2e-6) << mode;
    EXPECT_FALSE(overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact)) << mode;
  }
#if defined(__SSE__)
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);  // denormals are zero, and flushed to it
  const Separation flushed = separate_static(pair, flat_in_plate(0.01));
  _mm_setcsr(before);
  EXPECT_NEAR(flushed.depth, 0.01, 2e-6);
#endif
}

// The bound far away may be weak, but not nothing.
TEST(Extremes, the_bound_far_from_the_origin) {
  for (const double offset : {1e3, 1e5}) {
    const Vec3 away = offset * Vec3(1, 1, 1);
    const Pair pair(test::body(scaled(test::box(brick), 1, away)),
                    test::body(scaled(test::box(plate), 1, away)));
    const Separation s = separate_static(pair, flat_in_plate(0.01));
    ASSERT_TRUE(s.lower_bound);
    EXPECT_GT(*s.lower_bound, 0.001) << offset;
  }
}

TEST(Extremes, Full_a_million_copies_of_one_triangle) {
  PolygonSoup many{{{-0.05, -0.04, -0.03}, {0.05, -0.04, -0.03}, {0, 0.04, -0.03}}, {}};
  many.polygons.assign(1'000'000, {0, 1, 2});
  expect_depth("a million copies of one triangle", {test::body(many), test::body(test::box(plate))},
               flat_in_plate(0.01), 0.01);
}

}  // namespace
}  // namespace sonde
