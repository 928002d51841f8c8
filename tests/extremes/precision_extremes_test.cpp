// SPDX-License-Identifier: GPL-3.0-or-later
// Where single precision is used: the boxes of trees are kept and compared in it, of queries and of
// sweeps. They only decide which triangles are looked at, and are rounded outwards. The reference
// is double precision without any box: every pair of triangles (tests/support/brute_force.hpp).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "engine/geometry/chart.hpp"
#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/text/number_text.hpp"
#include "tests/extremes/press.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// How far answers through boxes are from those of every pair.
struct Difference {
  int touches = 0, differ = 0, free = 0, swept = 0;
  double distance = 0;  ///< largest, relative
  double stop = 0;      ///< of the clearance: what is left at a stop beyond it, largest
};

/// The bodies with all lengths times `scale`, the probe's mesh `aside` of its sizes from its
/// origin; `thin` flattens both to needles and caps along z.
Pair made(double scale, double aside, double thin) {
  const auto body = [&](PolygonSoup soup, double offset) {
    for (Vec3& x : soup.points)
      x = scale * (Vec3(x.x(), x.y(), thin * x.z()) + offset * Vec3(0.6, -0.8, 0));
    return test::body(soup, Model::surface);
  };
  std::mt19937_64 random(7);
  return {body(test::torus(0.1, 0.04, 12, 8), aside), body(test::random_soup(random, 150, 0.3), 0)};
}

/// The motion from a free pose straight through the fixed body.
void sweep_through(const Pair& pair, const Pose& from, double rounding, Difference& out) {
  Pose to = from;
  to.p += 2 * (pair.fixed().mass.com - from * pair.probe().mass.com);
  const Chart chart(pair.probe().mass, to);
  const Vec6 y = chart.coordinates(from);
  const double start = test::least_distance_of_pairs(pair.probe(), pair.fixed(), Transform(from));
  const double clearance = 1e-4 * pair.probe().mass.radius + 64 * rounding;
  if (start < 4 * clearance) return;
  const Motion motion(chart, y, Vec6::Zero());
  const Sweep swept = sweep(pair.probe(), pair.fixed(), motion, clearance);
  const double left =
      test::least_distance_of_pairs(pair.probe(), pair.fixed(), motion.at(swept.free_until));
  EXPECT_GT(left, 0) << "what is called free is free";
  if (swept.hit) out.stop = std::max(out.stop, left / clearance - 1);
  ++out.swept;
}

Difference compare(const Pair& pair, int poses, std::uint64_t seed) {
  Difference out;
  std::mt19937_64 random(seed);
  const Body &probe = pair.probe(), &fixed = pair.fixed();
  for (int i = 0; i < poses; ++i) {
    const Pose pose = test::random_pose(random, probe, fixed, 2);
    const Transform X(pose);
    // Corners that are placed far from their origin are rounded by so much, in either precision.
    const double rounding = 1e-16 * (pose.p.norm() + probe.mass.com.norm());
    const bool meet = test::any_pair_meets(probe, fixed, X);
    out.differ += meet != triangles_meet(probe, fixed, X, Doubt::exact);
    ++out.touches;
    if (meet) continue;
    const double by_pairs = test::least_distance_of_pairs(probe, fixed, X);
    const double by_boxes = triangle_distance(probe, fixed, X).distance;
    out.distance = std::max(out.distance, std::abs(by_boxes - by_pairs) / by_pairs);
    ++out.free;
    sweep_through(pair, pose, rounding, out);
  }
  return out;
}

TEST(Precision, boxes_in_single_precision_change_no_answer) {
  struct Scene {
    const char* what;
    double scale, aside, thin;
  };
  std::printf("  %-28s %8s %8s %12s %8s %10s\n", "", "touches", "differ", "distance by", "sweeps",
              "stop off by");
  for (const Scene& scene :
       {Scene{"size 1", 1, 0, 1}, Scene{"size 1e-9", 1e-9, 0, 1}, Scene{"size 1e9", 1e9, 0, 1},
        Scene{"1e4 sizes aside", 1, 1e4, 1}, Scene{"1e8 sizes aside", 1, 1e8, 1},
        Scene{"needles of aspect 1e6", 1, 0, 1e-6}, Scene{"needles of aspect 1e10", 1, 0, 1e-10}}) {
    SCOPED_TRACE(scene.what);
    const Difference d = compare(made(scene.scale, scene.aside, scene.thin), 24, 11);
    std::printf("  %-28s %8d %8d %12.2g %8d %10.2g\n", scene.what, d.touches, d.differ, d.distance,
                d.swept, d.stop);
    EXPECT_EQ(d.differ, 0);
    EXPECT_EQ(d.distance, 0) << "the same pair, by the same arithmetic";
    EXPECT_GE(d.free, 5);
    EXPECT_GE(d.swept, 5);
    EXPECT_LT(d.stop, 1) << "a stop leaves less than twice the clearance";
  }
}

}  // namespace
}  // namespace sonde
