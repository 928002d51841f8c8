// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps against dense sampling of their paths, on hard motions of hard soups.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "tests/support/adversarial.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/hard_motions.hpp"

namespace sonde {
namespace {

using test::BodyPair;
using test::HardMotion;
using test::Placed;

struct FuzzTally {
  std::size_t motions = 0, hits = 0, contacts = 0, samples = 0, no_start = 0;
  /// Stops from a start with room; those of them before their time.
  std::size_t judged = 0, early = 0, much_too_early = 0;
};

/// One motion with what the checks of it share.
struct Run {
  const BodyPair& pair;
  const HardMotion& motion;
  Motion path;
  Sweep swept;
  Placed fixed;
  double rounding;
  std::string what;

  bool apart_at(double s, double distance) const {
    return test::apart_by(Placed(*pair.a, path.at(s)), fixed, distance);
  }
  bool meets_at(double s) const { return test::any_meet(Placed(*pair.a, path.at(s)), fixed); }
};

/// Where the path is looked at: evenly, ever nearer to its free end, and where a contact is known.
std::vector<double> sampled(const Run& run, int samples) {
  const double end = run.swept.free_until;
  std::vector<double> out = {0, end};
  for (int k = 1; k <= samples; ++k) {
    const double x = static_cast<double>(k) / samples;
    out.push_back(end * (k % 2 ? x : 1 - std::pow(10.0, -12 * x)));
  }
  const double s = run.motion.picked;
  if (s >= 0 && s <= end) out.push_back(s);
  return out;
}

// References: the engine's own exact triangles_meet (itself tested against all pairs) at each
// sample; all pairs by exact predicates at every sample of a small soup, at a few of a large one.
void check_free(const Run& run, int samples, bool all_pairs, FuzzTally& tally) {
  int i = 0;
  for (const double s : sampled(run, samples)) {
    ASSERT_FALSE(triangles_meet(*run.pair.a, *run.pair.b, run.path.at(s), Doubt::exact))
        << run.what << ": contact at " << s << " of " << run.swept.free_until;
    if (all_pairs || i < 3) {
      ASSERT_FALSE(run.meets_at(s)) << run.what << ": contact at " << s;
    }
    ++i, ++tally.samples;
  }
}

// Reference: exact distances at samples. Promised is the clearance, or half of what there was at
// the start along the axis found then, which has nearly all of the distance.
void check_clearance(const Run& run, bool with_room) {
  double kept = run.motion.clearance;
  if (!with_room) {
    const Placed start(*run.pair.a, run.path.at(0));
    kept = std::min(kept, 0.99 * 0.5 * test::least_exact_distance(start, run.fixed));
  }
  for (const double part : {1.0, 0.999, 0.6}) {
    const double s = part * run.swept.free_until;
    ASSERT_TRUE(run.apart_at(s, kept * (1 - 1e-9) - run.rounding))
        << run.what << " at " << s << ", not " << kept << " m but "
        << test::least_exact_distance(Placed(*run.pair.a, run.path.at(s)), run.fixed)
        << " (rounding " << run.rounding << ")";
  }
}

/// How near a stop must be. A sweep ends where a pair has its clearance and at most a tenth more;
/// before its time it may end where a path grazes, and the bound of the acceleration lets it on in
/// ever smaller steps only: one stop in fifty at most, with more than a tenth of the probe's radius
/// left one in ten thousand.
constexpr double in_time = 1.1;
constexpr double much_room = 0.1;

// Reference: the exact distance of the pair that stopped it.
void check_not_early(const Run& run, bool with_room, FuzzTally& tally) {
  if (!run.swept.hit) return;
  ++tally.hits;
  if (!with_room) return;
  ++tally.judged;
  const Corners a =
      place(run.path.at(run.swept.free_until), corners(surface(*run.pair.a), run.swept.triangle_a));
  const double gap = test::exact_distance(a, corners(surface(*run.pair.b), run.swept.triangle_b));
  const double enough = in_time * run.motion.clearance + 4 * run.rounding;
  tally.early += gap > enough;
  tally.much_too_early += gap > enough + much_room * run.pair.a->mass.radius;
}

void check_motion(const BodyPair& pair, const HardMotion& motion, const std::string& what,
                  int samples, bool all_pairs, FuzzTally& tally) {
  const Motion path = motion.motion();
  Run run{pair, motion, path, sweep(*pair.a, *pair.b, path, motion.clearance), Placed(*pair.b, {}),
          0,    what};
  const Vec3 farthest = path.at(0).p.cwiseAbs().cwiseMax(path.at(1).p.cwiseAbs());
  run.rounding = 64 * std::numeric_limits<double>::epsilon() *
                 (extent(*pair.a) + extent(*pair.b) + farthest.maxCoeff());
  ++tally.motions;
  ASSERT_GE(run.swept.free_until, 0) << what;
  ASSERT_LE(run.swept.free_until, 1) << what;
  ASSERT_TRUE(run.swept.hit || run.swept.free_until == 1) << what;
  check_free(run, samples, all_pairs, tally);
  const bool with_room = run.apart_at(0, 2.5 * motion.clearance);
  check_clearance(run, with_room);
  check_not_early(run, with_room, tally);
  const double s = motion.picked;
  tally.contacts += s >= 0 && s <= 1 && run.meets_at(s);
}

struct Plan {
  int pairs, triangles, motions, samples;
  bool all_pairs;
};

void check_family(const Plan& plan, test::Family family, std::mt19937_64& random,
                  FuzzTally& tally) {
  for (int place = 0; place < static_cast<int>(test::Place::count); ++place)
    for (int p = 0; p < plan.pairs; ++p) {
      const BodyPair pair =
          test::adversarial_pair(family, static_cast<test::Place>(place), plan.triangles, random);
      for (int i = 0; i < plan.motions; ++i) {
        const auto kind = static_cast<HardMotion::Kind>(i % HardMotion::kinds);
        const auto motion = test::hard_motion(kind, pair, random);
        if (!motion) {
          ++tally.no_start;
          continue;
        }
        const std::string what = pair.name + ", " + test::name(kind) + " " + std::to_string(i);
        check_motion(pair, *motion, what, plan.samples, plan.all_pairs, tally);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
}

void check_sweeps(std::uint64_t seed, const Plan& plan) {
  std::mt19937_64 random(seed);
  FuzzTally tally;
  for (int f = 0; f < test::families; ++f)
    check_family(plan, static_cast<test::Family>(f), random, tally);
  EXPECT_GT(tally.contacts, tally.motions / 5) << "paths that run through a known contact";
  EXPECT_GT(tally.hits, tally.motions / 5);
  EXPECT_LT(tally.hits, tally.motions * 9 / 10);
  EXPECT_LE(tally.early, tally.judged / 50);
  EXPECT_LE(tally.much_too_early, tally.judged / 10000);
  std::cout << tally.motions << " motions of 2 x " << plan.triangles << " triangles ("
            << tally.no_start << " had no free start), " << tally.contacts
            << " through a known contact, " << tally.samples << " samples; " << tally.hits
            << " stops, " << tally.judged << " from a start with room, " << tally.early
            << " of them early, " << tally.much_too_early << " much\n";
}

/// Two small triangles, one radius above and below the middle.
PolygonSoup two_ends(double radius) {
  PolygonSoup out;
  for (const double z : {radius, -radius}) {
    for (const Vec3& x : {Vec3(-0.01, -0.01, z), Vec3(0.01, -0.01, z), Vec3(0, 0.02, z)})
      out.points.push_back(x);
    out.polygons.push_back({out.points.size() - 3, out.points.size() - 2, out.points.size() - 1});
  }
  return out;
}

// An end that swings over a sheet between it and the middle: at first it moves along the sheet, and
// all of its way down is acceleration. A bound of that which is too small is not forgiven here.
TEST(SweepFuzz, what_swings_inwards_is_seen_to_fall) {
  std::mt19937_64 random(7);
  FuzzTally tally;
  for (int i = 0; i < 500; ++i) {
    const double gap = std::pow(10.0, test::uniform(random, -6, -1));
    const double z = 1 - gap;
    const BodyPair pair{
        "two ends over a sheet", test::body(two_ends(1)),
        test::body({{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, {{0, 1, 2, 3}}})};
    const Chart chart(pair.a->mass, {});
    const Vec3 axis = Vec3(test::uniform(random, -1, 1), test::uniform(random, -1, 1), 0);
    const Quat q(Eigen::AngleAxisd(test::uniform(random, 0.5, 2), axis.normalized()));
    const Vec3 com = pair.a->mass.com;
    const Vec6 to = chart.coordinates({q, com - q * com});
    const double clearance = gap * std::pow(10.0, test::uniform(random, -6, -1));
    check_motion(pair, {chart, Vec6::Zero(), to, clearance}, pair.name, 32, true, tally);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
  EXPECT_EQ(tally.hits, 500u);
  EXPECT_LE(tally.early, 10u);
}

TEST(SweepFuzz, few_triangles) { check_sweeps(1, {6, 3, 64, 32, true}); }
TEST(SweepFuzz, dozens_of_triangles) { check_sweeps(2, {1, 30, 64, 32, false}); }
TEST(SweepFuzz, hundreds_of_triangles) { check_sweeps(3, {1, 150, 8, 32, false}); }
TEST(SweepFuzz, Fuzz_a_million_motions) {
  check_sweeps(4, {2800, 3, 8, 64, true});
  check_sweeps(5, {20, 30, 64, 64, false});
  check_sweeps(6, {1, 400, 16, 64, false});
}

}  // namespace
}  // namespace sonde
