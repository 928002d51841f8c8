// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/pair_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/proximity/queries/placement.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::shared_ptr<const Body> lone_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return test::body({{a, b, c}, {{0, 1, 2}}});
}
/// A corner at the origin, the rest of the triangle above it.
std::shared_ptr<const Body> tip() {
  return lone_triangle({0, 0, 0}, {0.1, 0.02, 0.3}, {-0.1, 0, 0.3});
}
/// In the plane z = 0, about the origin.
std::shared_ptr<const Body> ground() { return lone_triangle({-2, -1, 0}, {2, -1, 0}, {0, 2, 0}); }

Motion shift(const Body& body, const Vec3& from, const Vec3& to) {
  return {body.mass, Pose{Quat::Identity(), from}, Pose{Quat::Identity(), to}};
}

// Reference: the height of the corner, a closed form. It stops with a slack of at most a twentieth
// of the clearance, as the engine's advance() says where it ends.
TEST(PairSweep, stops_where_a_corner_meets_a_face) {
  const auto a = tip(), b = ground();
  for (const double clearance : {1e-2, 1e-5}) {
    const Motion motion = shift(*a, {0.1, 0.2, 0.5}, {-0.2, 0.1, -0.3});
    PairSweep pairs(*a, *b, motion, clearance);
    Vec3 normal = Vec3::Zero();
    EXPECT_GT(pairs.advance(0, 0, 0, normal), 0);
    const Sweep& found = pairs.result();
    EXPECT_TRUE(found.hit);
    EXPECT_FALSE(found.given_up);
    EXPECT_NEAR(normal.z(), 1, 1e-9);
    const double height = 0.5 - 0.8 * found.free_until;
    EXPECT_GE(height, clearance);
    EXPECT_LE(height, 1.05 * clearance + 4 * pairs.guard());
    EXPECT_EQ(pairs.free_until(), found.free_until);
  }
}

// Reference: the same closed form. A pair nearer than the clearance slides as far as it likes, and
// comes nearer to half of its gap.
TEST(PairSweep, a_pair_near_at_the_start_keeps_half_of_its_gap) {
  const auto a = tip(), b = ground();
  const double gap = 2e-3, clearance = 1e-2;
  const Motion along = shift(*a, {0, 0, gap}, {0.3, 0.2, gap});
  PairSweep slides(*a, *b, along, clearance);
  Vec3 normal = Vec3::Zero();
  slides.advance(0, 0, 0, normal);
  EXPECT_FALSE(slides.result().hit);
  EXPECT_EQ(slides.free_until(), 1);
  const Motion down = shift(*a, {0, 0, gap}, {0.3, 0.2, -gap});
  PairSweep sinks(*a, *b, down, clearance);
  normal.setZero();
  sinks.advance(0, 0, 0, normal);
  EXPECT_TRUE(sinks.result().hit);
  const double height = gap * (1 - 2 * sinks.free_until());
  EXPECT_GE(height, 0.5 * gap);
  EXPECT_LE(height, 1.05 * 0.5 * gap + 4 * sinks.guard());
}

TEST(PairSweep, a_direction_that_separates_all_of_the_path_costs_no_look) {
  const auto a = tip(), b = ground();
  const Motion motion = shift(*a, {0, 0, 0.5}, {0, 0, 0.4});
  PairSweep pairs(*a, *b, motion, 1e-3);
  Vec3 normal = Vec3::UnitZ();
  EXPECT_EQ(pairs.advance(0, 0, 0, normal), 0);
  EXPECT_FALSE(pairs.result().hit);
  EXPECT_EQ(normal, Vec3(Vec3::UnitZ()));
}

// Reference: of two planes, one 0.1 m below the other, the upper one stops the path.
TEST(PairSweep, keeps_the_earliest_stop) {
  const auto a = tip();
  const auto b =
      test::body({{{-2, -1, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, -0.1}, {2, -1, -0.1}, {0, 2, -0.1}},
                  {{0, 1, 2}, {3, 4, 5}}});
  const Motion motion = shift(*a, {0.1, 0.2, 0.5}, {-0.2, 0.1, -0.3});
  const std::uint32_t upper = corners(surface(*b), 0)[0].z() == 0 ? 0 : 1, lower = 1 - upper;
  Vec3 normal = Vec3::Zero();
  PairSweep below(*a, *b, motion, 1e-5);
  below.advance(0, lower, 0, normal);
  EXPECT_EQ(below.result().triangle_b, lower);
  EXPECT_NEAR(below.free_until(), 0.6 / 0.8, 1e-4);
  below.advance(0, upper, 0, normal);
  EXPECT_EQ(below.result().triangle_b, upper);
  EXPECT_NEAR(below.free_until(), 0.5 / 0.8, 1e-4);
  below.advance(0, lower, 0, normal);
  EXPECT_EQ(below.result().triangle_b, upper);
  const Sweep stopped = below.result();
  below.give_up(0.99);  // beyond the stop: nothing new
  EXPECT_EQ(below.free_until(), stopped.free_until);
  EXPECT_FALSE(below.result().given_up);
  below.give_up(0.25);
  EXPECT_EQ(below.free_until(), 0.25);
  EXPECT_TRUE(below.result().hit);
  EXPECT_TRUE(below.result().given_up);
}

// Reference: the height of the corner, as above.
TEST(PairSweep, a_direction_given_first_goes_no_further_than_the_stop) {
  const auto a = tip(), b = ground();
  const Motion motion = shift(*a, {0.1, 0.2, 0.5}, {-0.2, 0.1, -0.3});
  PairSweep pairs(*a, *b, motion, 1e-2);
  Vec3 normal = Vec3::UnitZ();
  pairs.advance(0, 0, 0, normal);
  EXPECT_TRUE(pairs.result().hit);
  EXPECT_NEAR(pairs.free_until(), (0.5 - 1e-2) / 0.8, 1e-6);
}

// Reference: by hand, heights over the plane divided by the speed of the corner.
TEST(PairSweep, a_step_of_a_translation_is_its_slack_over_its_speed) {
  const auto a = tip(), b = ground();
  const double clearance = 0.125;
  const Motion down = shift(*a, {0, 0, 0.5}, {0, 0, -0.25});
  const PairSweep pairs(*a, *b, down, clearance);
  const PairSweep::Step step = pairs.step_along(0, 0, Vec3::UnitZ(), pairs.start());
  EXPECT_NEAR(step.gap, 0.5, 1e-15);
  EXPECT_NEAR(step.length, (0.5 - clearance) / 0.75, 1e-12);
  EXPECT_TRUE(step.closing);
  const Motion up = shift(*a, {0, 0, 0.5}, {0, 0, 2});
  const PairSweep leaving(*a, *b, up, clearance);
  const PairSweep::Step away = leaving.step_along(0, 0, Vec3::UnitZ(), leaving.start());
  EXPECT_TRUE(std::isinf(away.length));
  EXPECT_FALSE(away.closing);
  const Motion low = shift(*a, {0, 0, 0.1}, {0, 0, -0.25});
  const PairSweep near(*a, *b, low, clearance);
  EXPECT_EQ(near.step_along(0, 0, Vec3::UnitZ(), near.start()).length, 0);
}

TEST(PairSweep, the_floor_is_the_clearance_or_half_of_what_the_start_proves) {
  const auto a = tip(), b = ground();
  const Motion motion = shift(*a, {0, 0, 0.5}, {0, 0, -0.25});
  PairSweep pairs(*a, *b, motion, 0.125);
  const double guard = pairs.guard();
  EXPECT_GT(guard, 0);
  EXPECT_EQ(pairs.floor_of(0.01), 0.125 + guard);  // no distance has been reported
  pairs.saw_at_start(0.04);
  EXPECT_EQ(pairs.floor_of(0.01), 0.02 + guard);
  EXPECT_EQ(pairs.floor_of(0.06), 0.03 + guard);
  EXPECT_EQ(pairs.floor_of(9), 0.125 + guard);
  pairs.saw_at_start(0.08);  // no nearer
  EXPECT_EQ(pairs.floor_of(0.01), 0.02 + guard);
}

// Reference: a closed form. Along a normal that does not turn, heights of a translation are
// straight: it is clear if both ends are.
TEST(PairSweep, a_translation_is_clear_along_a_normal_if_both_ends_are) {
  const auto a = tip(), b = ground();
  for (const double end : {0.4, 0.11, 0.09, -0.1}) {
    const Motion motion = shift(*a, {0, 0, 0.3}, {0.2, 0, end});
    PairSweep pairs(*a, *b, motion, 0.1);
    pairs.saw_at_start(0.3);
    EXPECT_EQ(pairs.is_clear_along(0, 0, Vec3::UnitZ()), end > 0.1) << end;
    EXPECT_EQ(pairs.is_clear_between(0, 0, 0, pairs.start(), Vec3::UnitZ(), Vec3::UnitZ()),
              end > 0.1)
        << end;
    if (end < 0) {  // only the part before the stop counts
      pairs.give_up(0.25);
      EXPECT_TRUE(pairs.is_clear_along(0, 0, Vec3::UnitZ()));
    }
  }
}

// Reference: a closed form. A corner that swings through its lowest point by an angle to each side
// is lower between the ends than there.
TEST(PairSweep, an_arc_that_dips_between_its_ends_is_not_clear) {
  const auto a = tip(), b = ground();
  const Vec3 com = a->mass.com;
  const double arm = com.norm(), angle = 0.3;
  const Vec3 axis = com.cross(Vec3::UnitY()).normalized();
  const Quat hanging = Quat::FromTwoVectors(com, Vec3::UnitZ());
  for (const double lowest : {0.5, 0.2, -0.2}) {  // of what the corner dips; the clearance is less
    const double dip = arm * (1 - std::cos(angle)), height = arm + lowest * dip;
    const auto turned = [&](double by) {
      const Quat q = (Quat(Eigen::AngleAxisd(by, axis)) * hanging).normalized();
      return Pose{q, Vec3(0, 0, height) - q * com};
    };
    const Motion motion(a->mass, turned(-angle), turned(angle));
    PairSweep pairs(*a, *b, motion, 0.01 * dip);
    pairs.saw_at_start(0.1);
    const bool clear = lowest > 0.01;
    EXPECT_NEAR((motion.at(0.5) * Vec3::Zero()).z(), lowest * dip, 1e-12);
    EXPECT_EQ(pairs.is_clear_along(0, 0, Vec3::UnitZ()), clear) << lowest;
    if (clear) continue;
    // Of the part before, the dip counts alone: 0.15 of the way leads from the end at 0.3 rad down
    // to 0.21 rad, still above.
    pairs.give_up(0.15);
    EXPECT_TRUE(pairs.is_clear_along(0, 0, Vec3::UnitZ()));
  }
}

// Reference: by hand. Only at the start may a pair be nearer than the clearance.
TEST(PairSweep, past_the_start_the_clearance_counts) {
  const auto a = tip(), b = ground();
  const Motion motion = shift(*a, {0, 0, 2e-3}, {0.3, 0.2, 2e-3});
  PairSweep pairs(*a, *b, motion, 1e-2);
  pairs.saw_at_start(2e-3);
  const Vec3 up = Vec3::UnitZ();
  EXPECT_TRUE(pairs.is_clear_between(0, 0, 0, pairs.start(), up, up));
  EXPECT_FALSE(pairs.is_clear_between(0, 0, 0.5, Moment(motion, 0.5), up, up));
}

/// Two random triangles, and a motion of one past the other from a free pose.
struct PassingPair {
  std::shared_ptr<const Body> a, b;
  Motion motion;
};
PassingPair passing_pair(std::mt19937_64& random) {
  const auto point = [&](double size) { return test::random_in_ball(random, size); };
  const double size = std::pow(10.0, test::uniform(random, -0.5, 0.5));
  const auto a = lone_triangle(point(1), point(1), point(1));
  const auto b = lone_triangle(point(size), point(size), point(size));
  for (;;) {
    const Chart chart(a->mass, {test::random_rotation(random), point(0.5)});
    const auto y = [&](double turn, double way) {
      Vec6 out;
      out << 2 * a->mass.inertia.cwiseSqrt().cwiseProduct(point(turn)), point(way);
      return out;
    };
    const Vec6 from = y(0.8, 1.5);
    const double part = std::pow(10.0, test::uniform(random, -1, 0));
    const Motion motion(chart, from, from + part * (y(0.8, 0.3) - from));
    const Corners at_start = place(motion.at(0), corners(surface(*a), 0));
    if (!test::meet_by_edges(at_start, corners(surface(*b), 0))) return {a, b, motion};
  }
}
double apart_at(const PassingPair& pair, double s) {
  return test::exact_distance(place(pair.motion.at(s), corners(surface(*pair.a), 0)),
                              corners(surface(*pair.b), 0));
}

// Reference: exact distances (CGAL) at samples of the path. Exact but for the rounding of poses.
TEST(PairSweep, a_path_keeps_its_clearance_up_to_the_stop_and_has_lost_it_there) {
  std::mt19937_64 random(1);
  int hits = 0, early = 0, free = 0;
  for (int i = 0; i < 800; ++i) {
    const PassingPair pair = passing_pair(random);
    const double clearance = std::pow(10.0, test::uniform(random, -6, -2));
    PairSweep pairs(*pair.a, *pair.b, pair.motion, clearance);
    Vec3 normal = Vec3::Zero();
    pairs.advance(0, 0, 0, normal);
    const double kept = std::min(clearance, 0.5 * apart_at(pair, 0));
    for (int k = 0; k <= 8; ++k)
      EXPECT_GE(apart_at(pair, pairs.free_until() * k / 8), kept) << i << " " << k;
    free += !pairs.result().hit;
    if (!pairs.result().hit) continue;
    ++hits;
    early += apart_at(pair, pairs.free_until()) > 1.06 * kept;
  }
  EXPECT_GT(hits, 40);
  EXPECT_GT(free, 60);
  EXPECT_LE(early, hits / 20);  // of 50 steps, some do not come so near
}

// Reference: exact gaps (CGAL) along the normal at samples of the step.
TEST(PairSweep, a_step_along_a_normal_keeps_the_gap_along_it) {
  std::mt19937_64 random(2);
  double furthest = 0;
  int steps = 0;
  for (int i = 0; i < 400; ++i) {
    const PassingPair pair = passing_pair(random);
    const double clearance = std::pow(10.0, test::uniform(random, -6, -2));
    const PairSweep pairs(*pair.a, *pair.b, pair.motion, clearance);
    const Corners local = corners(surface(*pair.a), 0), fixed = corners(surface(*pair.b), 0);
    const double from = test::uniform(random, 0, 0.5);
    const Moment now(pair.motion, from);
    const Vec3 n = closest_points(place(now.X, local), fixed).normal;
    if (n.squaredNorm() == 0) continue;
    const PairSweep::Step step = pairs.step_along(0, 0, n, now);
    const auto gap_at = [&](double s) {
      return test::exact_gap_along(n, place(pair.motion.at(s), local), fixed);
    };
    EXPECT_NEAR(step.gap, gap_at(from), pairs.guard());
    if (step.gap <= clearance) {
      EXPECT_EQ(step.length, 0);
      continue;
    }
    const double length = std::min(step.length, 1 - from);
    for (int k = 1; k <= 12; ++k) EXPECT_GE(gap_at(from + length * k / 12), clearance) << i;
    if (!(step.length < 1 - from)) continue;
    ++steps;
    furthest += (step.gap - gap_at(from + step.length)) / (step.gap - clearance);
  }
  EXPECT_GT(steps, 50);
  EXPECT_GT(furthest / steps, 0.2);  // the bound is of use
}

// Reference: the parabola of most curvature at samples, whose least value is a closed form where it
// lies between the ends.
TEST(PairSweep, a_height_stays_above_its_floor_if_its_parabola_does) {
  std::mt19937_64 random(6);
  int yes = 0, no = 0, low = 0;
  for (int i = 0; i < 2000; ++i) {
    const double from = std::pow(10.0, test::uniform(random, -4, 0)),
                 to = std::pow(10.0, test::uniform(random, -4, 0)),
                 sag = std::pow(10.0, test::uniform(random, -4, 0));
    double least = std::min(from, to);
    for (int k = 1; k < 1000; ++k) {
      const double s = k / 1000.0;
      least = std::min(least, (1 - s) * from + s * to - 4 * sag * s * (1 - s));
    }
    const bool stays = stays_above(from, to, sag);
    if (least < 0) {
      EXPECT_FALSE(stays) << from << " " << to << " " << sag;
    }
    // Samples a thousandth apart miss the least value by no more than this.
    if (least > 1e-6 * sag) {
      EXPECT_TRUE(stays) << from << " " << to << " " << sag;
    }
    yes += stays, no += !stays, low += stays && std::min(from, to) < sag;
  }
  EXPECT_GT(yes, 500);
  EXPECT_GT(no, 500);
  EXPECT_GT(low, 100);
  EXPECT_FALSE(stays_above(-1e-9, 1, 0));
  EXPECT_FALSE(stays_above(1, -1e-9, 0));
  EXPECT_TRUE(stays_above(0, 0, 0));
  EXPECT_TRUE(stays_above(0, 4, 1));
  EXPECT_FALSE(stays_above(0, 3.999, 1));
}

// Reference: exact distances (CGAL) at samples of the path.
TEST(PairSweep, what_is_clear_along_normals_keeps_its_floor) {
  std::mt19937_64 random(3);
  int along = 0, between = 0, only_between = 0, turned = 0, only_turned = 0;
  for (int i = 0; i < 1000; ++i) {
    const PassingPair pair = passing_pair(random);
    const double clearance = std::pow(10.0, test::uniform(random, -6, -1));
    PairSweep pairs(*pair.a, *pair.b, pair.motion, clearance);
    const double at_start = apart_at(pair, 0);
    pairs.saw_at_start(at_start);
    const Corners local = corners(surface(*pair.a), 0), fixed = corners(surface(*pair.b), 0);
    const Vec3 first = closest_points(place(pairs.start().X, local), fixed).normal;
    const Vec3 last = closest_points(place(pairs.end(), local), fixed).normal;
    const bool one = pairs.is_clear_along(0, 0, first);
    const bool two = pairs.is_clear_between(0, 0, 0, pairs.start(), first, last);
    // Directions that turn with A: those of its faces do.
    const Mat3 turn = pairs.end().R * pairs.start().X.R.transpose();
    const bool three =
        pairs.is_clear_between(0, 0, 0, pairs.start(), first, turn * first) ||
        pairs.is_clear_between(0, 0, 0, pairs.start(), turn.transpose() * last, last);
    along += one, between += two, only_between += two && !one;
    turned += three, only_turned += three && !one && !two;
    if (!one && !two && !three) continue;
    const double kept = std::min(clearance, 0.5 * at_start);
    for (int k = 0; k <= 12; ++k) EXPECT_GE(apart_at(pair, k / 12.0), kept) << i << " " << k;
  }
  EXPECT_GT(along, 100);
  EXPECT_GT(between, 100);
  EXPECT_GT(only_between, 10);
  EXPECT_GT(turned, 100);
  EXPECT_GT(only_turned, 2);
}

// Reference: the heights of a corner at samples of the path.
TEST(PairSweep, a_path_hangs_below_its_chord_by_no_more_than_is_said) {
  std::mt19937_64 random(4);
  double most = 0;  // of what is allowed
  for (int i = 0; i < 200; ++i) {
    const PassingPair pair = passing_pair(random);
    const PairSweep pairs(*pair.a, *pair.b, pair.motion, 1e-3);
    const Vec3 n = test::random_rotation(random) * Vec3::UnitZ();
    for (const Vec3& x : corners(surface(*pair.a), 0)) {
      const double bend = n.dot(pair.motion.bend() * (x - pair.motion.com()));
      const double allowed = std::max(0.0, pairs.hangs_by(bend)) + pairs.guard();
      const double from = n.dot(pair.motion.at(0) * x), to = n.dot(pair.motion.at(1) * x);
      for (int k = 1; k < 20; ++k) {
        const double s = k / 20.0;
        const double below = (1 - s) * from + s * to - n.dot(pair.motion.at(s) * x);
        EXPECT_LE(below, allowed) << i;
        most = std::max(most, below / allowed);
      }
    }
  }
  EXPECT_GT(most, 0.8);
}

TEST(PairSweep, does_not_allocate) {
  std::mt19937_64 random(5);
  std::vector<PassingPair> passing;
  for (int i = 0; i < 20; ++i) passing.push_back(passing_pair(random));
  double until = 0;
  test::AllocationCounter counter;
  for (const PassingPair& pair : passing) {
    PairSweep pairs(*pair.a, *pair.b, pair.motion, 1e-3);
    Vec3 normal = Vec3::Zero();
    pairs.advance(0, 0, 0, normal);
    until += pairs.free_until();
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << until;
}

}  // namespace
}  // namespace sonde
