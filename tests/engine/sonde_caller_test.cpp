// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller of the public face may set and stop: signed distances, the norm, progress, copies,
// the rounding of its own numbers.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/sonde.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/contact_path.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

Pose at(double x, double y, double z) { return {Quat::Identity(), Vec3(x, y, z)}; }

// Reference: a brick above a block, or in it: its height less half of both.
TEST(SignedDistance, is_the_height_of_a_brick_over_a_block_above_and_below_its_top) {
  const Pair pair(test::body(test::box({0.02, 0.03, 0.05})),
                  test::body(test::box({0.3, 0.3, 0.1})));
  for (int i = -20; i <= 40; ++i) {
    const double height = 2.5e-4 * i;
    const SignedDistance found = signed_distance(pair, at(0.01, 0.02, 0.075 + height));
    EXPECT_NEAR(found.distance, height, 1e-3 * std::abs(height) + 1e-10) << i;
    if (i > 0) {
      EXPECT_EQ(found.separation.status, Status::separated);
      EXPECT_EQ(found.distance, found.clearance.distance);
    }
    if (i < 0) {
      EXPECT_EQ(found.distance, -found.separation.depth);
    }
  }
  EXPECT_THROW(signed_distance(pair, at(std::numeric_limits<double>::quiet_NaN(), 0, 0)),
               InputError);
}

TEST(Separation, says_the_clearance_of_a_free_pose_where_that_is_asked_for) {
  const Pair pair(test::body(test::box({0.02, 0.03, 0.05})),
                  test::body(test::box({0.3, 0.3, 0.1})));
  const Pose above = at(0.01, 0.02, 0.075 + 0.004), in = at(0.01, 0.02, 0.07);
  EXPECT_FALSE(separate(pair, above).clearance);
  const Separation free = separate(pair, above, {.want_clearance = true});
  ASSERT_TRUE(free.clearance);
  EXPECT_NEAR(free.clearance->distance, 0.004, 1e-15);
  EXPECT_FALSE(separate(pair, in, {.want_clearance = true}).clearance);
}

// Reference: where a turn is dear beside any displacement, the least way out turns nothing; where
// all moments are scaled by a factor, the part of σ from the turn is, at one pose.
TEST(WithMass, moments_weigh_turns_against_displacements) {
  const auto brick = test::body(test::box({0.02, 0.03, 0.05}));
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  const Pose askew{Quat(Eigen::AngleAxisd(0.6, Vec3(1, 2, 0.5).normalized())),
                   Vec3(0.01, 0.02, 0.06)};
  MassProperties mass = facts(*brick).mass;
  const Separation own = separate(Pair(brick, block), askew);
  mass.inertia *= 1e8;
  const auto stiff = with_mass(*brick, mass);
  EXPECT_EQ(facts(*stiff).mass.inertia, mass.inertia);
  EXPECT_EQ(facts(*stiff).triangles, facts(*brick).triangles);
  const Separation translated = separate(Pair(brick, block), askew, {.method = Method::pdt});
  const Separation turned_no_more = separate(Pair(stiff, block), askew);
  EXPECT_NEAR(turned_no_more.depth, translated.depth, 1e-4 * translated.depth);
  EXPECT_LT(own.depth, 0.9 * translated.depth) << "or a turn was of no use";
  // By four times: not dearer than the same motion at four times the price of its turn.
  mass.inertia *= 4e-8;
  const Separation dearer = separate(Pair(with_mass(*brick, mass), block), askew);
  EXPECT_GE(dearer.depth, own.depth * (1 - 1e-6));
  EXPECT_LE(dearer.depth, std::hypot(own.translation, 2 * own.rotation) * (1 + 1e-6));
  // Of another density, it is as deep.
  MassProperties heavy = facts(*brick).mass;
  heavy.measure *= 7800;
  EXPECT_EQ(separate(Pair(with_mass(*brick, heavy), block), askew).depth, own.depth);
}

TEST(WithMass, properties_of_no_body_are_refused_with_the_reason) {
  const auto brick = test::body(test::box({0.02, 0.03, 0.05}));
  const MassProperties own = facts(*brick).mass;
  const auto refused = [&](const auto& change) {
    MassProperties mass = own;
    change(mass);
    EXPECT_THROW(with_mass(*brick, mass), InputError);
  };
  refused([](MassProperties& m) { m.measure = 0; });
  refused([](MassProperties& m) { m.measure = -1; });
  refused([](MassProperties& m) { m.inertia[1] = -1e-9; });
  refused([](MassProperties& m) { m.inertia.setZero(); });
  refused([](MassProperties& m) { m.com[0] = std::numeric_limits<double>::infinity(); });
  refused([](MassProperties& m) { m.com[0] = 1e30; });
  refused([](MassProperties& m) { m.R_MP(0, 0) += 1e-3; });
  refused([](MassProperties& m) { m.R_MP.col(2) = -m.R_MP.col(2); });
}

TEST(Cancelling, ends_what_takes_long_and_telling_progress_changes_no_bit) {
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 120, 10));
  const auto soup = test::box({0.1, 0.1, 0.1});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Triangle& t : triangulate(soup).soup.triangles) triangles.push_back(t);
  const Progress never = [](double) { return false; };
  EXPECT_THROW(make_body(soup.points, triangles, Model::automatic, "box", Repair::automatic, never),
               Cancelled);
  EXPECT_THROW(Pair(knot, knot, never), Cancelled);
  const Pair pair(knot, knot);
  const Pose X = at(0.02, 0.01, 0.01);
  EXPECT_THROW(separate(pair, X, {}, never), Cancelled);
  EXPECT_THROW(separate(pair, X, {.method = Method::pdt}, never), Cancelled);
  EXPECT_THROW(signed_distance(pair, X, {}, never), Cancelled);
  Follower follower(pair);
  EXPECT_THROW(follower.start(X, {}, never), Cancelled);
  EXPECT_EQ(follower.last().status, Status::failed) << "it has not started";
  int asked = 0;
  double last = 0;
  const Separation told = separate(pair, X, {}, [&](double fraction) {
    EXPECT_GE(fraction, last) << "it never falls";
    EXPECT_LE(fraction, 1);
    last = fraction;
    return ++asked > 0;
  });
  const Separation quiet = separate(pair, X);
  EXPECT_EQ(told.depth, quiet.depth);
  EXPECT_EQ(told.separated.p, quiet.separated.p);
  EXPECT_EQ(told.iterations, quiet.iterations);
  EXPECT_GT(asked, 5);
  // Stopped in the middle as well.
  int left = asked / 2;
  EXPECT_THROW(separate(pair, X, {}, [&](double) { return --left > 0; }), Cancelled);
}

// Reference: the follower that was copied goes the same way, to the bit; and so it does again.
TEST(FollowerCopy, goes_on_from_the_same_state_and_allocates_nothing) {
  for (const test::ContactPair& bodies : test::contact_pairs()) {
    const Pair pair(bodies.probe, bodies.fixed);
    Follower follower(pair);
    follower.start(test::contact_path(bodies, 0.3));
    const auto way = [&](int i) { return test::contact_path(bodies, 0.3 + 0.002 * i); };
    for (int i = 0; i < 100; ++i) follower.follow(way(i));
    Follower kept(follower);
    std::vector<Separation> first;
    for (int i = 100; i < 250; ++i) first.push_back(follower.follow(way(i)));
    Follower again(pair);
    again = kept;  // rolls back
    EXPECT_EQ(again.last().depth, kept.last().depth);
    int in_contact = 0;
    for (int i = 100; i < 250; ++i) {
      test::AllocationCounter counter;
      const Separation& now = again.follow(way(i));
      counter.stop();
      EXPECT_EQ(counter.allocations() + counter.frees(), 0u) << bodies.name;
      const Separation& then = first[static_cast<std::size_t>(i - 100)];
      EXPECT_EQ(now.depth, then.depth) << bodies.name << " " << i;
      EXPECT_EQ(now.separated.q.coeffs(), then.separated.q.coeffs());
      EXPECT_EQ(now.iterations, then.iterations);
      in_contact += now.status == Status::penetrating;
    }
    EXPECT_GT(in_contact, 20) << bodies.name;
  }
}

/// A number or more of every function of the face that computes.
std::vector<double> all_answers(const PolygonSoup& knot, const Body& block_body, const Pose& in,
                                const Pose& out, const std::filesystem::path& file) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Triangle& t : triangulate(knot).soup.triangles) triangles.push_back(t);
  const auto block = with_mass(block_body, facts(block_body).mass);
  const auto body = make_body(knot.points, triangles);
  const auto smaller = offset_body(*block, -0.001);
  const Pair pair(body, block);
  write_pair(file, pair);
  const Pair again = read_pair(file, body, block);
  const Separation found = separate(pair, in, {.budget = {.steps = 30}});
  Follower follower(again);
  follower.start(out);
  const Separation followed = follower.follow(in);
  const SweptPath path = sweep(pair, out, in);
  const WrenchDerivative change = wrench_derivative(pair, followed, Neighbours::all);
  const SurfacePoint near = nearest_point(*body, Vec3(0.4, 0.1, 0.3));
  const auto hit = ray(*body, Vec3(0.5, 0.45, 0.3), Vec3(-1, 0.1, 0));
  Eigen::Matrix4d M;
  M << 0.6, -0.8, 0, 0.1, 0.8, 0.6, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1;
  const auto number = [](bool x) { return x ? 1.0 : 0.0; };
  return {facts(*body).mass.measure,
          facts(*smaller).mass.radius,
          found.depth,
          found.lower_bound.value_or(-1),
          found.separated.q.x(),
          followed.depth,
          followed.separated.p.z(),
          number(touch(pair, in)),
          distance(pair, out).distance,
          path.free,
          path.X_FM.q.y(),
          signed_distance(pair, out).distance,
          separate_along(pair, in, std::vector<Vec3>{Vec3::UnitZ()}).depth,
          separate_about(pair, in, Vec3(1, 0, 0), Vec3::UnitY()).depth,
          separate_in_plane(pair, in, {Vec3::UnitX()}, {.starts = 2}).depth,
          separate(pair, out, Knob{}).separation.depth,
          wrench(pair, found, {}).torque.x(),
          wrench(pair, found, followed, 1e-3, {}).force.z(),
          change.d_wrench(3, 3),
          principal_stiffnesses(change, 500).rotation[1].value,
          near.distance,
          hit ? hit->distance : -1.0,
          number(inside(*block, Vec3(0.1, 0.1, 0.04))),
          static_cast<double>(seed_of_pose(3, in) >> 12),
          pose_of(M).q.z()};
}

/// What the functions are asked about, made before a mode is set.
struct Asked {
  PolygonSoup knot = test::torus_knot(2, 3, 0.1, 0.04, 0.03, 40, 8);
  std::shared_ptr<const Body> block = test::body(test::box({0.3, 0.3, 0.1}));
  Pose in{Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())), Vec3(0.02, 0.01, 0.06)};
  Pose out{in.q, Vec3(0.02, 0.01, 0.3)};
  test::TempFolder folder;
  std::vector<double> answers() const {
    return all_answers(knot, *block, in, out, folder / "pair");
  }
};

// Reference: the same calls with numbers rounded to the nearest, as programs begin.
TEST(Rounding, a_caller_that_rounds_otherwise_gets_the_same_bits_and_keeps_its_mode) {
  const Asked asked;
  const std::vector<double> expected = asked.answers();
  EXPECT_GT(expected[2], 0.01);
  EXPECT_GT(expected[8], 0.01);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::vector<double> found = asked.answers();
    const int kept = std::fegetround();
    const bool still = !RoundToNearest::is_set();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(kept, mode);
    EXPECT_TRUE(still);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(found[i], expected[i]) << i;
  }
}

#ifdef __GLIBC__
// Reference: the same calls without traps.
TEST(Rounding, a_caller_that_is_to_end_at_an_invalid_operation_does_not_end_in_the_library) {
  const Asked asked;
  const std::vector<double> expected = asked.answers();
  constexpr int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  std::feclearexcept(FE_ALL_EXCEPT);
  ASSERT_NE(feenableexcept(traps), -1);
  const std::vector<double> found = asked.answers();
  const int kept = fedisableexcept(traps);
  EXPECT_EQ(kept, traps);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(found[i], expected[i]) << i;
}
#endif

}  // namespace
}  // namespace sonde
