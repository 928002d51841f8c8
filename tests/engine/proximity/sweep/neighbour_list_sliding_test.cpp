// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of pairs of faces that slide over each other with hardly any room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "tests/engine/proximity/small_motions.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::rounding_at;

/// A plate in `strips` strips along y, bent along x by `sag` (m) from a flat one, so that no two of
/// its strips are one facet.
PolygonSoup bent_plate(double half, int strips, double sag, double thickness) {
  PolygonSoup out;
  for (int i = 0; i <= strips; ++i) {
    const double x = half * (2.0 * i / strips - 1), z = -sag * (x / half) * (x / half);
    for (const Vec3& p : {Vec3(x, -half, z), Vec3(x, half, z), Vec3(x, half, z - thickness),
                          Vec3(x, -half, z - thickness)})
      out.points.push_back(p);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(strips); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      out.polygons.push_back({4 * i + k, 4 * i + 4 + k, 4 * i + 4 + next, 4 * i + next});
    }
  const std::size_t last = 4 * static_cast<std::size_t>(strips);
  out.polygons.push_back({0, 1, 2, 3});
  out.polygons.push_back({last + 3, last + 2, last + 1, last});
  return out;
}

/// Two plates, one upside down on the other with a gap, that slide over each other.
struct Sliding {
  test::BodyPair pair;
  Pose start;
  double gap;
};
Sliding sliding_plates(std::mt19937_64& random) {
  const auto any = [&](double low, double high) { return test::uniform(random, low, high); };
  const auto plate = [&](double half) {
    const double sag = half * std::pow(10, any(-7, -4));
    return bent_plate(half, static_cast<int>(any(3, 9)), sag, 0.1 * half);
  };
  Sliding out;
  out.gap = std::pow(10, any(-7, -4));
  PolygonSoup upper = plate(any(0.02, 0.06));
  for (Vec3& x : upper.points) x = Vec3(x.x(), -x.y(), -x.z());
  out.pair = {"plates", test::body(upper), test::body(plate(0.05))};
  const Quat turn(Eigen::AngleAxisd(any(-3, 3), Vec3::UnitZ()));
  out.start = {turn, Vec3(any(-0.03, 0.03), any(-0.03, 0.03), out.gap)};
  return out;
}

/// Least distance of all pairs, by exact_distance, where the probe is.
double exact_distance_at(const test::BodyPair& pair, const Transform& X) {
  return test::least_exact_distance(test::Placed(*pair.a, X), test::Placed(*pair.b, {}));
}

// By hand: a triangle that stands beside another, a little higher than that. The direction upwards,
// by which the list knew it last, leaves hardly any gap; that does not let it come as near. The
// promise is the clearance, since at the start all is far apart.
TEST(NeighbourList, a_stale_direction_does_not_lower_the_clearance) {
  const auto triangle = [](double size) {
    return test::body({{{-size, -size, 0}, {size, -size, 0}, {0, size, 0}}, {{0, 1, 2}}});
  };
  const test::BodyPair pair{"beside", triangle(0.1), triangle(1)};
  Effort unlimited;
  for (const double height : {1e-2, 1e-3, 1e-5}) {
    NeighbourList list(*pair.a, *pair.b);
    const Chart chart(pair.a->mass, {});
    Vec6 above = Vec6::Zero(), beside = Vec6::Zero(), over = Vec6::Zero();
    above[5] = 1;
    beside[3] = 4;
    beside[5] = over[5] = height;
    ASSERT_TRUE(list.build(Transform(chart.pose(above)), 20, unlimited));
    const Motion away(chart, above, beside), back(chart, beside, over);
    EXPECT_FALSE(list.sweep_along(away, 0.1 * height, unlimited).hit);
    const double clearance = 10 * height;
    const Sweep swept = list.sweep_along(back, clearance, unlimited);
    EXPECT_TRUE(swept.hit);
    EXPECT_GE(exact_distance_at(pair, back.at(swept.free_until)), clearance * (1 - 1e-9));
  }
}

// Reference: the same sweep with the trees, and a count of work. A plate turns off a tip below its
// one half, and slides so that the tip passes from one of its triangles to the other. No direction
// that stands still separates them, since the other half goes down beside the tip; the normal of
// the plate does, which turns with it. No pair needs to be looked at on its way, however little
// room it has (some 50 units each time; one look at each end).
TEST(NeighbourList, a_face_that_turns_off_a_corner_takes_no_look_on_its_way) {
  const auto plate = test::body(test::box({0.1, 0.08, 0.01}));
  const Vec3 top(0.03, 0.0238, 0);  // the diagonal of the plate passes at y = 0.024
  const auto tip = test::body({{top, top + Vec3(-2e-3, 0, -0.02), top + Vec3(2e-3, 2e-3, -0.02),
                                top + Vec3(2e-3, -2e-3, -0.02)},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}});
  for (const double room : {1e-5, 1e-7, 1e-9}) {
    const Chart chart(plate->mass, {});
    Vec6 from = Vec6::Zero();
    from[5] = 0.005 + room;
    const Pose start = chart.pose(from);
    const Quat turn(Eigen::AngleAxisd(-0.02, Vec3::UnitY()));
    const Vec6 to = chart.coordinates({(turn * start.q).normalized(), start.p - Vec3(0, 1e-3, 0)});
    const Motion motion(chart, from, to);
    NeighbourList list(*plate, *tip);
    Effort unlimited;
    ASSERT_TRUE(list.build(Transform(start), plate->mass.com, {1e-3, 0.1}, unlimited));
    EXPECT_FALSE(sweep(*plate, *tip, motion, 0.5 * room, unlimited).hit);
    const std::int64_t before = unlimited.left();
    EXPECT_FALSE(list.sweep_along(motion, 0.5 * room, unlimited).hit);
    const auto pairs = static_cast<std::int64_t>(list.size());
    EXPECT_GT(pairs, 0);
    EXPECT_LE(before - unlimited.left(), 10 + pairs * (5 + 5 + 20)) << room;
  }
}

/// A path that slides the probe along the plates, turns it a little, and lets it press on by a part
/// of its gap.
Pose slid(std::mt19937_64& random, const Sliding& plates, const Pose& X, double by) {
  const double turn = by / plates.pair.a->mass.radius;
  const double tip = plates.gap / plates.pair.a->mass.radius;
  const Vec3 about(test::uniform(random, -tip, tip), test::uniform(random, -tip, tip),
                   test::uniform(random, -turn, turn));
  const Quat q = (Quat(Eigen::AngleAxisd(about.norm(), about.normalized())) * X.q).normalized();
  const Vec3& com = plates.pair.a->mass.com;
  const Vec3 way(test::uniform(random, -by, by), test::uniform(random, -by, by),
                 plates.gap * test::uniform(random, -1, 0.5));
  return {q, X * com + way - q * com};
}

struct Slides {
  int sweeps = 0, hits = 0, free = 0;
};

/// Sweeps one list along path after path, so that its directions are of other places. References:
/// exact distances at samples of each path. Promised is the clearance, or half of the least
/// distance at the start where that is less.
void check_slides(std::uint64_t seed, int rounds, int samples, Slides& tally) {
  std::mt19937_64 random(seed);
  Effort unlimited;
  for (int round = 0; round < rounds; ++round) {
    const Sliding plates = sliding_plates(random);
    const test::BodyPair& pair = plates.pair;
    Pose at = plates.start;
    const double rounding = rounding_at(pair, at);
    double distance = exact_distance_at(pair, Transform(at));
    if (distance < 0.01 * plates.gap) continue;
    NeighbourList list(*pair.a, *pair.b);
    for (int step = 0; step < 12; ++step) {
      const double by = pair.a->mass.radius * std::pow(10, test::uniform(random, -4, -0.7));
      const Pose to = slid(random, plates, at, by);
      Chart chart(pair.a->mass, plates.start);
      const Motion motion(chart, chart.coordinates(at), chart.coordinates(to));
      const double clearance = distance * test::uniform(random, 0.1, 1.5);
      if (!list.covers(motion, clearance) &&
          !list.build(Transform(at), pair.a->mass.com, {10 * by, 0.5}, unlimited))
        break;
      if (!list.covers(motion, clearance)) break;
      const Sweep swept = list.sweep_along(motion, clearance, unlimited);
      const double promised = std::min(clearance, 0.5 * distance) * (1 - 1e-9) - rounding;
      for (int k = 0; k <= samples; ++k) {
        const double s = swept.free_until * k / samples;
        const double kept = exact_distance_at(pair, motion.at(s));
        ASSERT_GE(kept, promised) << "seed " << seed << ", round " << round << ", step " << step
                                  << ": at " << s << " of " << swept.free_until << ", from "
                                  << distance << " with a clearance of " << clearance;
      }
      ++tally.sweeps;
      (swept.hit ? tally.hits : tally.free)++;
      const Vec6 from = chart.coordinates(at);
      at = chart.pose(from + 0.999 * swept.free_until * (chart.coordinates(to) - from));
      distance = exact_distance_at(pair, Transform(at));
      if (distance < 1e-4 * plates.gap) break;
    }
  }
}

// What lies flush on the other body slides past edge after edge of it, with hardly any room.
TEST(NeighbourList, flush_faces_that_slide_keep_their_clearance) {
  Slides tally;
  check_slides(21, 40, 6, tally);
  EXPECT_GT(tally.sweeps, 200);
  EXPECT_GT(tally.hits, 40);
  EXPECT_GT(tally.free, 60);
}
TEST(NeighbourList, Full_flush_faces_that_slide_keep_their_clearance) {
  Slides tally;
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    check_slides(seed, 40, 24, tally);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_GT(tally.sweeps, 2000);
}

}  // namespace
}  // namespace sonde
