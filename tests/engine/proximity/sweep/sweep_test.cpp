// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/pair_sweep.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

/// One motion from a free pose, in the pair's own size.
struct SweepCase {
  Chart chart;
  Vec6 from, to;
  double clearance;
  Motion motion() const { return {chart, from, to}; }
};

SweepCase random_case(std::mt19937_64& random, const test::BodyPair& pair) {
  const double size = pair.a->mass.radius;
  for (;;) {
    const Chart chart(pair.a->mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
    const auto y = [&](double turn, double shift) {
      Vec6 out;
      out.head<3>() =
          2 * pair.a->mass.inertia.cwiseSqrt().cwiseProduct(test::random_in_ball(random, turn));
      out.tail<3>() = test::random_in_ball(random, shift * (size + pair.b->mass.radius));
      return out;
    };
    const Vec6 from = y(0.8, 1.5), far = y(0.8, 1.0);
    if (test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(from)))) continue;
    // Long ways, and short ones.
    const double part = random() % 2 ? 1 : std::pow(10.0, test::uniform(random, -4, 0));
    const double clearance = size * std::pow(10.0, test::uniform(random, -7, -2));
    return {chart, from, from + part * (far - from), clearance};
  }
}

/// Counts over many motions; the checks are within.
struct SweepTally {
  int hits = 0, free = 0, lazy = 0;
};

// Reference: exact predicates on all pairs of triangles at samples of the path, more of them near
// its end; distances of all pairs there for the clearance and for not stopping too early.
void check_sweeps(const test::BodyPair& pair, std::mt19937_64& random, int motions, int samples,
                  SweepTally& tally) {
  for (int i = 0; i < motions; ++i) {
    const SweepCase c = random_case(random, pair);
    const Motion motion = c.motion();
    const Sweep swept = sweep(*pair.a, *pair.b, motion, c.clearance);
    ASSERT_GE(swept.free_until, 0);
    ASSERT_LE(swept.free_until, 1);
    const double size = extent(*pair.a) + extent(*pair.b) + motion.at(0).p.cwiseAbs().maxCoeff();
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * size;
    const double at_start = test::least_distance_of_pairs(*pair.a, *pair.b, motion.at(0));
    const double kept = std::min(c.clearance, 0.5 * at_start);
    for (int k = 0; k <= samples; ++k) {
      const double x = static_cast<double>(k) / samples;
      const double s = swept.free_until * (k % 2 ? x : 1 - std::pow(10.0, -8 * x));
      const Transform X = motion.at(s);
      EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, X)) << pair.name << i << " at " << s;
    }
    const double gap = test::least_distance_of_pairs(*pair.a, *pair.b, motion.at(swept.free_until));
    EXPECT_GE(gap, kept * (1 - 1e-9) - rounding) << pair.name << i;
    if (!swept.hit) {
      EXPECT_EQ(swept.free_until, 1) << pair.name;
      ++tally.free;
      continue;
    }
    ++tally.hits;
    // Not lazy: what stopped it is near, nearer than twice the clearance; or the start was near.
    const Corners ta =
        place(motion.at(swept.free_until), corners(surface(*pair.a), swept.triangle_a));
    const double stopper = closest_points(ta, corners(surface(*pair.b), swept.triangle_b)).distance;
    tally.lazy += stopper > 2 * c.clearance + 2 * rounding;
    EXPECT_LT(stopper, 2 * c.clearance + 1e-3 * pair.a->mass.radius) << pair.name << i;
  }
}

void check_all_pairs(std::uint64_t seed, int motions, int samples) {
  std::mt19937_64 random(seed);
  for (const auto& pair : test::body_pairs(seed)) {
    SweepTally tally;
    check_sweeps(pair, random, motions, samples, tally);
    EXPECT_GT(tally.hits, motions / 10) << pair.name;
    EXPECT_GT(tally.free, motions / 10) << pair.name;
    // A path that only grazes may be stopped in front of it, by the bound of the acceleration.
    EXPECT_LE(tally.lazy, tally.hits / 50) << pair.name << ", of " << tally.hits;
  }
}

TEST(Sweep, what_it_calls_free_is_free_and_it_stops_at_contact) { check_all_pairs(41, 60, 24); }
TEST(Sweep, Full_on_thousands_of_motions) { check_all_pairs(42, 600, 60); }

SweepCase straight(const Body& body, const Vec3& start, const Vec3& step, double clearance) {
  Vec6 to = Vec6::Zero();
  to.tail<3>() = step;
  return {Chart(body.mass, {Quat::Identity(), start}), Vec6::Zero(), to, clearance};
}

// By hand: a cube of side 1 moves on to another; the corner regions, the faces, a miss.
TEST(Sweep, translations_by_hand) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const auto stop = [&](const Vec3& start, const Vec3& step) {
    const SweepCase c = straight(*cube, start, step, 1e-9);
    return sweep(*cube, *cube, c.motion(), c.clearance);
  };
  EXPECT_NEAR(stop({3, 0.1, 0.2}, {-4, 0, 0}).free_until, 0.5, 1e-8);
  EXPECT_NEAR(stop({2, 3, 0}, {-4, -4, 0}).free_until, 0.5, 1e-8);
  EXPECT_FALSE(stop({3, 1.001, 0}, {-6, 0, 0}).hit);
  EXPECT_TRUE(stop({3, 0.999, 0}, {-6, 0, 0}).hit);
  EXPECT_FALSE(stop({3, 0, 0}, {-1.999, 0, 0}).hit);
  EXPECT_FALSE(stop({3, 0, 0}, {0, 0, 0}).hit);
}

// A plate a hundredth as thick as the probe is not stepped over, however far the motion goes.
TEST(Sweep, no_step_jumps_over_a_thin_plate) {
  const auto probe = test::body(test::box({0.1, 0.1, 0.1}));
  const auto plate = test::body(test::box({1, 1, 0.001}));
  const auto sheet = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for (const auto& wall : {plate, sheet})
    for (const double length : {0.2, 1.0, 100.0, 1e6}) {
      const SweepCase c = straight(*probe, {0.01, 0.02, 0.1}, {0, 0, -length}, 1e-8);
      const Sweep swept = sweep(*probe, *wall, c.motion(), c.clearance);
      EXPECT_TRUE(swept.hit);
      EXPECT_NEAR(swept.free_until * length, wall == plate ? 0.0495 : 0.05, 1e-7) << length;
    }
}

TEST(Sweep, a_start_that_touches_goes_nowhere) {
  const auto cube = test::body(test::box({1, 1, 1}));
  for (const Vec3& start : {Vec3(1, 0.25, 0.5), Vec3(0.5, 0.25, 0.5)})
    for (const Vec3& step : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0.01, 0)}) {
      const SweepCase c = straight(*cube, start, step, 1e-6);
      const Sweep swept = sweep(*cube, *cube, c.motion(), c.clearance);
      EXPECT_TRUE(swept.hit);
      EXPECT_EQ(swept.free_until, 0);
    }
}

// Nearer than the clearance asked for from the start: it may still slide along, and leave.
// (Sliding far under pairs that were further off is not in the promise, and ends.)
TEST(Sweep, a_start_nearer_than_the_clearance_can_slide_and_leave) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const double gap = 1e-6;
  const auto go = [&](const Vec3& step, double clearance = 1e-3) {
    const SweepCase c = straight(*cube, {1 + gap, 0.25, 0.5}, step, clearance);
    return sweep(*cube, *cube, c.motion(), c.clearance);
  };
  EXPECT_FALSE(go({1, 0, 0}).hit);
  EXPECT_FALSE(go({1, 0.3, 0}).hit);
  EXPECT_GT(go({0, 0.1, -0.3}).free_until, 0);
  EXPECT_FALSE(go({0, 0.1, -0.3}, 0.4 * gap).hit);
  const Sweep into = go({-1, 0, 0});
  EXPECT_TRUE(into.hit);
  EXPECT_LT(into.free_until, 0.51 * gap);
  EXPECT_GT(into.free_until, 0.4 * gap);
}

// Spun about its centre, a bar meets the wall at an angle known by hand.
TEST(Sweep, a_turn_by_hand) {
  const auto bar = test::body(test::box({0.2, 0.02, 0.02}));
  const auto wall = test::body(test::box({1, 0.1, 1}));
  const Chart chart(bar->mass, {Quat::Identity(), Vec3(0, 0.11, 0)});
  const Quat end(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  const Vec6 to = chart.coordinates({end, Vec3(0, 0.11, 0)});
  const Motion motion(chart, Vec6::Zero(), to);
  const Sweep swept = sweep(*bar, *wall, motion, 1e-9);
  ASSERT_TRUE(swept.hit);
  // The corner (0.1, −0.01) turned by θ sinks to 0.1 sin θ + 0.01 cos θ = 0.06 under the centre.
  const double angle = std::asin(0.06 / std::hypot(0.1, 0.01)) - std::atan2(0.01, 0.1);
  const Mat3 R = motion.at(swept.free_until).R;
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), angle, 1e-6);
}

TEST(Sweep, safe_advance_is_the_first_root) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const double slack = std::pow(10.0, test::uniform(random, -12, 2));
    const double speed =
        test::uniform(random, -1, 1) * std::pow(10.0, test::uniform(random, -6, 3));
    const double a = i % 10 ? std::pow(10.0, test::uniform(random, -9, 3)) : 0;
    const double x = safe_advance(slack, speed, a);
    if (a <= 0 && speed >= 0) {
      EXPECT_TRUE(std::isinf(x));
      continue;
    }
    const double terms = slack + std::abs(speed) * x + 0.5 * a * x * x;
    EXPECT_NEAR(slack + speed * x - 0.5 * a * x * x, 0, 1e-14 * terms);
    EXPECT_GT(x, 0);
  }
  EXPECT_EQ(safe_advance(0, 1, 1), 0);
  EXPECT_EQ(safe_advance(-1, 1, 1), 0);
}

TEST(Sweep, does_not_allocate) {
  std::mt19937_64 random(6);
  const auto pairs = test::body_pairs(43);
  std::vector<SweepCase> cases;
  for (const auto& pair : pairs)
    for (int i = 0; i < 10; ++i) cases.push_back(random_case(random, pair));
  int hits = 0;
  test::AllocationCounter counter;
  for (std::size_t i = 0; i < cases.size(); ++i)
    hits += sweep(*pairs[i / 10].a, *pairs[i / 10].b, cases[i].motion(), cases[i].clearance).hit;
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_GT(hits, 5);
}

// Reference: the sweep with all the effort it wants, and exact predicates on all pairs of
// triangles.
TEST(Sweep, gives_up_with_what_is_known_when_the_effort_runs_out) {
  std::mt19937_64 random(19);
  int given_up = 0, finished = 0;
  for (const auto& pair : test::body_pairs(55))
    for (int i = 0; i < 20; ++i) {
      const SweepCase c = random_case(random, pair);
      const Motion motion = c.motion();
      const Sweep whole = sweep(*pair.a, *pair.b, motion, c.clearance);
      double before = 0;
      for (const std::int64_t work : {1, 30, 100, 300, 1000, 10000000}) {
        Effort effort(work, 0);
        const Sweep part = sweep(*pair.a, *pair.b, motion, c.clearance, effort);
        EXPECT_GE(part.free_until, before) << pair.name;
        EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, motion.at(part.free_until)));
        EXPECT_LE(part.free_until, whole.free_until) << pair.name;
        if (part.given_up) {
          EXPECT_TRUE(part.hit && effort.is_spent());
        } else {
          EXPECT_EQ(part.free_until, whole.free_until) << pair.name;
          EXPECT_EQ(part.hit, whole.hit);
        }
        before = part.free_until;
        ++(part.given_up ? given_up : finished);
      }
    }
  EXPECT_GT(given_up, 100);
  EXPECT_GT(finished, 100);
}

// Reference: distances of all pairs of triangles at samples of the path.
TEST(Sweep, within_room_keeps_all_of_the_clearance_from_the_start_on) {
  std::mt19937_64 random(11);
  int hits = 0, free = 0, at_start = 0, lazy = 0;
  for (const test::BodyPair& pair : test::body_pairs(12))
    for (int i = 0; i < 14; ++i) {
      const SweepCase c = random_case(random, pair);
      const Motion motion = c.motion();
      const auto apart = [&](double s) {
        return test::least_distance_of_pairs(*pair.a, *pair.b, motion.at(s));
      };
      const double clearance = test::uniform(random, 0.3, 1.1) * apart(0);
      Effort effort;
      const Sweep swept = sweep_within_room(*pair.a, *pair.b, motion, clearance, effort);
      ASSERT_FALSE(swept.given_up);
      const double rounding = rounding_guard(extent(*pair.a) + pair.a->mass.com.norm(),
                                             extent(*pair.b), motion.at(0).p) +
                              rounding_guard(0, 0, motion.at(1).p);
      if (apart(0) < clearance - rounding) {
        ++at_start;
        EXPECT_TRUE(swept.hit);
        EXPECT_EQ(swept.free_until, 0);
        continue;
      }
      for (int k = 0; k <= 10; ++k)
        ASSERT_GE(apart(swept.free_until * k / 10), clearance - rounding) << i << " " << k;
      ++(swept.hit ? hits : free);
      if (!swept.hit) {
        EXPECT_EQ(swept.free_until, 1);
      } else if (apart(swept.free_until) > clearance * (1 + 1.1e-4) + 3 * rounding) {
        ++lazy;
      }
    }
  EXPECT_LE(lazy, (hits + free) / 50);
  EXPECT_GT(hits, 10);
  EXPECT_GT(free, 10);
  EXPECT_GT(at_start, 3);
}

}  // namespace
}  // namespace sonde
