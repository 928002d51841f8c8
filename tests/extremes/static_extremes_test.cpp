// SPDX-License-Identifier: GPL-3.0-or-later
// Static searches at the extremes of size, place, depth, turn and of the host's arithmetic. The
// reference is geometry by hand: a box that lies flat in a plate comes out straight up by as much
// as it is in.
#include <algorithm>
#include <array>
#include <cfenv>
#include <limits>
#include <numbers>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/text/number_text.hpp"
#include "tests/extremes/press.hpp"

namespace sonde {
namespace {

using test::brick;
using test::brick_and_plate;
using test::expect_answer;
using test::expect_depth;
using test::flat_in_plate;
using test::plate;
using test::scaled;

/// Both meshes so far from the origins of their frames.
Pair both_away(const Vec3& by) {
  return {test::body(scaled(test::box(brick), 1, by)), test::body(scaled(test::box(plate), 1, by))};
}

TEST(Extremes, sizes_from_1e_minus_9_to_1e9) {
  for (const double size : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
    expect_depth("size " + number_text(size), brick_and_plate(size), flat_in_plate(0.01, size),
                 0.01 * size);
  }
}

/// The brick with one corner down in the plate, `deep` below its face, all lengths times `size`;
/// and the least motion that lifts it out. Reference: with one contact at r from the centre of mass
/// and its normal n, the least |t|² + θᵀIθ (I per mass) with n·t + (r × n)·θ ≥ deep has the norm
/// deep / √(1 + (r × n)ᵀ I⁻¹ (r × n)), to the first order in deep.
struct CornerDown {
  Pose pose;
  double depth, turned;  ///< the depth, and |θ|
  CornerDown(double deep, double size) {
    pose.q = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 0.3, 0.2).normalized()));
    const Mat3 R = pose.q.toRotationMatrix();
    Vec3 lowest = Vec3::Zero();  // corner, in the brick's axes
    for (int i = 0; i < 3; ++i) lowest[i] = size * (R(2, i) > 0 ? -0.5 : 0.5) * brick[i];
    const double down = -(R * lowest).z();
    pose.p = Vec3(0.02, -0.01, 0.5) * size + (down - deep * size) * Vec3::UnitZ();
    const Vec3 squares = size * size * brick.cwiseAbs2();
    const Vec3 inertia = (Vec3::Constant(squares.sum()) - squares) / 12;
    const Vec3 moment = lowest.cross(R.transpose() * Vec3::UnitZ());
    const double by_turn = moment.cwiseAbs2().cwiseQuotient(inertia).sum();
    depth = deep * size / std::sqrt(1 + by_turn);
    turned = deep * size * moment.cwiseQuotient(inertia).norm() / (1 + by_turn);
  }
};

TEST(Extremes, a_corner_comes_out_by_a_turn_too) {
  for (const double deep : {1e-6, 1e-7})
    for (const double size : {1e-9, 1.0, 1e9}) {
      const CornerDown corner(deep, size);
      const Pair pair = brick_and_plate(size);
      const Separation s = separate_static(pair, corner.pose);
      // What the second order may be off by: the turn times the depth.
      const double second = 10 * corner.turned * corner.depth;
      expect_answer("corner down, size " + number_text(size), pair, s, corner.depth, corner.depth,
                    second);
      EXPECT_NEAR(s.separated.q.angularDistance(corner.pose.q), corner.turned,
                  0.02 * corner.turned);
      const double up = deep * size;
      expect_answer("corner down, PD_t", pair, test::translate(pair, corner.pose), up, up);
    }
}

// Coordinates are rounded by ε times the offset, in either mesh and in the pose: that much the
// reference itself is worth.
TEST(Extremes, offsets_up_to_1e8_sizes) {
  for (const double offset : {1e2, 1e4, 1e6, 1e8}) {
    const double away = 0.1 * offset;  // m
    const Pair pair = both_away(away * Vec3(1, -2, 0.5).normalized());
    expect_answer("offset " + number_text(offset), pair, separate_static(pair, flat_in_plate(0.01)),
                  0.01, 0.01, 8 * std::numeric_limits<double>::epsilon() * away);
  }
}

TEST(Extremes, ratios_of_sizes_up_to_1e5) {
  for (const double ratio : {1e2, 1e3, 1e5}) {
    const auto large = test::body(scaled(test::box({1, 1, 1}), 0.1 * ratio));
    const auto small = test::body(test::box(brick));
    const double top = 0.05 * ratio;
    expect_depth("fixed body larger by " + number_text(ratio), {small, large},
                 {Quat::Identity(), Vec3(0, 0, top + 0.03 - 0.01)}, 0.01);
    expect_depth("probe larger by " + number_text(ratio), {large, small},
                 {Quat::Identity(), Vec3(0, 0, -(top + 0.03 - 0.01))}, 0.01);
  }
}

TEST(Extremes, depths_of_1e_minus_12_and_of_10_sizes) {
  const Pair pair = brick_and_plate();
  for (const double depth : {1e-2, 1e-4, 1e-6})
    expect_depth("depth " + number_text(depth), pair, flat_in_plate(depth), depth);
  // Less than the clearance: contact, and no more than that.
  const Separation least = separate_static(pair, flat_in_plate(1e-12));
  EXPECT_EQ(least.status, Status::penetrating);
  EXPECT_LE(least.depth, 2e-9);
  std::printf("  depth 1e-12: %.2g m\n", least.depth);
  // A small probe 10 of its sizes under the face.
  const auto small = test::body(scaled(test::box(brick), 0.2));
  const double half = 0.2 * 0.03;
  expect_depth("ten sizes deep", {small, test::body(test::box(plate))},
               {Quat::Identity(), Vec3(0, 0, 0.5 - 0.2)}, 0.2 + half);
}

TEST(Extremes, exact_touch_is_contact_without_depth) {
  const auto cube = test::body(test::box({1, 1, 1}));
  double most = 0;
  for (const Vec3& at : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    const Separation s = separate_static({cube, cube}, {Quat::Identity(), at});
    EXPECT_EQ(s.status, Status::penetrating);
    EXPECT_LE(s.depth, 1e-8);
    EXPECT_EQ(s.lower_bound, 0);
    most = std::max(most, s.depth);
  }
  std::printf("  faces, edges and corners that touch: %.2g m\n", most);
}

// Reference: the same body, turned by itself: a brick turned by π about an axis of its own is the
// same brick.
TEST(Extremes, turns_next_to_pi) {
  const Pair pair = brick_and_plate();
  for (const double off : {0.0, 1e-16, 1e-12, 1e-9})
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      Pose pose = flat_in_plate(0.01);
      pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi - off, axis));
      // Its lowest corner is deeper than its face would be.
      double low = 0;
      for (const Vec3& x : pair.probe().soup.vertices) low = std::min(low, (pose.q * x).z());
      expect_depth("turn of pi less " + number_text(off), pair, pose, 0.5 - pose.p.z() - low);
    }
}

/// A search and a tick that follows the probe in, in another state of the processor, which is put
/// back before anything else is computed.
template <class Set, class Back>
std::pair<Separation, Separation> answers_with(const Pair& pair, const Set& set, const Back& back) {
  CoherentSolver solver(pair);
  set();
  const Separation searched = separate_static(pair, flat_in_plate(0.01));
  solver.reset(flat_in_plate(-0.01));
  const Separation followed = solver.tick(flat_in_plate(0.01));
  back();
  return {searched, followed};
}
void expect_answers(const std::string& host, const Pair& pair,
                    const std::pair<Separation, Separation>& answers) {
  expect_answer(host, pair, answers.first, 0.01, 0.01);
  expect_answer(host + ", a tick", pair, answers.second, 0.01, 0.01);
}

TEST(Extremes, a_host_program_s_rounding_and_flushing) {
  const Pair pair = brick_and_plate();
  struct Mode {
    const char* name;
    int mode;
  };
  for (const Mode& host : {Mode{"rounding up", FE_UPWARD}, Mode{"rounding down", FE_DOWNWARD},
                           Mode{"rounding to zero", FE_TOWARDZERO}}) {
    const auto answers = answers_with(
        pair, [&] { ASSERT_EQ(std::fesetround(host.mode), 0); },
        [] { std::fesetround(FE_TONEAREST); });
    expect_answers(host.name, pair, answers);
  }
#if defined(__SSE__)
  const unsigned before = _mm_getcsr();
  const auto flushed = answers_with(
      pair, [&] { _mm_setcsr(before | 0x8040); },  // denormals are zero, and flushed to it
      [&] { _mm_setcsr(before); });
  expect_answers("denormals flushed", pair, flushed);
#endif
}

// A brick with a corner at its origin, and denormal numbers where that has zeros. Reference: by
// hand, as with the zeros.
TEST(Extremes, denormal_numbers_in_meshes_and_poses) {
  for (const double tiny : {std::numeric_limits<double>::denorm_min(), 1e-310}) {
    PolygonSoup soup = scaled(test::box(brick), 1, brick / 2);
    for (Vec3& x : soup.points) x = x.cwiseMax(Vec3(tiny, tiny, tiny));
    const Pair pair(test::body(soup), test::body(test::box(plate)));
    EXPECT_TRUE(pair.probe().solid) << pair.probe().why;
    const Pose pose{Quat(1, tiny, -tiny, tiny), flat_in_plate(0.01).p - brick / 2};
    expect_depth("denormals, " + number_text(tiny), pair, pose, 0.01);
  }
  EXPECT_THROW(test::body(scaled(test::box(brick), 1e-310)), InputError) << "too small";
}

// The bound far away may be weak, but not nothing.
TEST(Extremes, the_bound_far_from_the_origin) {
  for (const double offset : {1e3, 1e5}) {
    const Separation s = separate_static(both_away(offset * Vec3(1, 1, 1)), flat_in_plate(0.01));
    ASSERT_TRUE(s.lower_bound);
    EXPECT_GT(*s.lower_bound, 0.001) << offset;
  }
}

}  // namespace
}  // namespace sonde
