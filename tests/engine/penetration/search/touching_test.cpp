// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that only touch. References: by hand (the depth is 0, the normal that of the face or of
// both edges); exact predicates on all pairs for what is free.
#include "engine/penetration/search/touching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/engine/penetration/search/touches.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

namespace touches = test::touches;
using test::all_touches;
using test::PlacedTouch;
using test::Touch;

/// The gap of two convex bodies along a direction, m.
double gap_of_all(const Vec3& n, const Body& probe, const Body& fixed, const Pose& X) {
  double low = 1e300, high = -1e300;
  for (const Vec3& p : probe.soup.vertices) low = std::min(low, n.dot(X * p));
  for (const Vec3& p : fixed.soup.vertices) high = std::max(high, n.dot(p));
  return low - high;
}

void expect_touching(const Touch& touch, const PlacedTouch& at, const Separation& s,
                     const std::string& what) {
  test::check_separation(*at.probe, *at.fixed, s, what);
  EXPECT_TRUE(s.converged) << what;
  EXPECT_LE(s.residual, 1e-9) << what;
  // A few times the gap that is kept, where two directions are far from each other.
  EXPECT_LE(s.depth, 12 * at.rounding) << what;
  EXPECT_GT(s.depth, 0) << what;
  ASSERT_GT(s.clusters.size, 0) << what;
  for (const ContactCluster& c : s.clusters) {
    EXPECT_NEAR(c.contact.normal.norm(), 1, 1e-12) << what;
    if (touch.convex) {
      EXPECT_GE(gap_of_all(c.contact.normal, *at.probe, *at.fixed, s.device), -2 * at.rounding)
          << what;
    }
  }
  if (touch.unique)
    for (const Contact& c : s.contacts) {
      double best = -1;
      for (const Vec3& n : at.normals) best = std::max(best, n.dot(c.normal));
      EXPECT_NEAR(best, 1, 1e-9) << what;
    }
}

StaticOptions by(Method method) {
  StaticOptions out;
  out.method = method;
  return out;
}

constexpr double scales[] = {1, 1e-3, 37.5, 1e3};

// Reference: by hand.
TEST(Touching, is_contact_without_depth_at_any_place_and_scale) {
  std::mt19937_64 random(1);
  for (const Touch& touch : all_touches())
    for (const double scale : scales) {
      const PlacedTouch at(touch, scale, random);
      const Pair pair(at.probe, at.fixed);
      for (const Method method : {Method::pdg, Method::pdt}) {
        const std::string what = touch.name + " " + name_of(method) + " x " + std::to_string(scale);
        // Without a search: it would take a thousand times as long.
        const auto direct = touching_separation(*at.probe, *at.fixed, at.contact(), method);
        ASSERT_TRUE(direct) << what;
        const Separation s = separate_static(pair, at.contact(), by(method));
        EXPECT_NEAR(s.depth, direct->depth, at.rounding) << what;
        expect_touching(touch, at, s, what);
        EXPECT_EQ(s.lower_bound.value_or(-1), 0) << what;
        ASSERT_TRUE(s.pdt) << what;
        EXPECT_LE(*s.pdt, 12 * at.rounding) << what;
      }
    }
}

// Reference: by hand. Coordinates that are exact: nothing is rounded but the answer.
TEST(Touching, holds_for_exact_coordinates_too) {
  for (const Touch& touch : touches::faces_on_faces()) {
    const auto probe = test::body(touch.probe), fixed = test::body(touch.fixed);
    for (const Method method : {Method::pdg, Method::pdt}) {
      const auto s = touching_separation(*probe, *fixed, {}, method);
      ASSERT_TRUE(s) << touch.name;
      test::check_separation(*probe, *fixed, *s, touch.name);
      EXPECT_LE(s->depth, 2 * rounding_guard(extent(*probe), extent(*fixed), Vec3::Zero()));
      EXPECT_EQ(s->clusters.size, 1) << touch.name;
      EXPECT_NEAR(s->clusters[0].contact.normal.z(), 1, 1e-12) << touch.name;
    }
  }
}

// Reference: what is apart by more than rounding is free as it is; what overlaps by a thousandth
// comes out by that along the way in, which no translation undercuts where there is one normal.
TEST(Touching, its_neighbours_are_separated_and_as_deep_as_they_were_moved_in) {
  std::mt19937_64 random(2);
  int k = 0;
  for (const Touch& touch : all_touches()) {
    const PlacedTouch at(touch, scales[k++ % 4], random);
    const double R = at.probe->mass.radius;
    const Pair pair(at.probe, at.fixed);
    const Separation apart = separate_static(pair, at.off(1e-9 * R + 4 * at.rounding));
    EXPECT_EQ(apart.status, Status::separated) << touch.name;
    EXPECT_EQ(apart.depth, 0) << touch.name;
    const double way = 1e-3 * R;
    const Separation deep = separate_static(pair, at.off(-way), by(Method::pdt));
    ASSERT_EQ(deep.status, Status::penetrating) << touch.name;
    EXPECT_LE(deep.depth, way * (1 + 1e-3)) << touch.name;
    EXPECT_GT(deep.depth, 0.1 * way) << touch.name;
    if (touch.convex && touch.unique) {
      EXPECT_GE(deep.depth, way * (1 - 1e-6)) << touch.name;
    }
    const Separation turned = separate_static(pair, at.off(-way));
    EXPECT_LE(turned.depth, deep.depth * (1 + 1e-3)) << touch.name;
    EXPECT_TRUE(turned.contacts.size > 0 && deep.contacts.size > 0) << touch.name;
  }
}

// Reference: by hand. What starts in touch, as assembled parts do, follows a device that presses,
// one that slides while it presses, and one that leaves: never deeper than it is pressed in, and
// free where it is out.
TEST(Touching, a_probe_that_starts_there_follows_the_device) {
  std::mt19937_64 random(3);
  int k = 0;
  for (const Touch& touch : all_touches())
    for (const Method method : {Method::pdg, Method::pdt})
      for (const double start : {-0.25, 0.0, 0.5}) {
        const PlacedTouch at(touch, scales[k++ % 4], random);
        const double R = at.probe->mass.radius, way = 1e-3 * R;
        const std::string what =
            touch.name + " " + name_of(method) + " from " + std::to_string(start);
        CoherentSolver solver({at.probe, at.fixed}, method);
        ASSERT_LE(solver.reset(at.off(start * at.rounding)).depth, 12 * at.rounding) << what;
        const auto depth_at = [&](const Pose& device) {
          for (int tick = 0; tick < 3; ++tick) solver.tick(device);
          EXPECT_TRUE(solver.last().converged) << what;
          return solver.last().depth;
        };
        EXPECT_LE(depth_at(at.off(-way)), way * (1 + 1e-3)) << what;
        EXPECT_GT(solver.last().depth, (method == Method::pdt ? 0.1 : 0.05) * way) << what;
        if (touch.unique && at.normals.size() == 1) {
          Pose aside = at.off(-way);
          aside.p += 5 * way * at.out.unitOrthogonal();
          EXPECT_LE(depth_at(aside), way * (1 + 1e-3)) << what;
        }
        EXPECT_EQ(depth_at(at.off(way)), 0) << what;
      }
}

// Reference: by hand. An overlap far below the clearance is told to rounding all the same.
TEST(Touching, an_overlap_below_the_clearance_is_as_deep_as_it_is) {
  const auto cube = test::body(test::box({2, 2, 2}));
  const double R = cube->mass.radius, rounding = rounding_guard(1, 1, Vec3(2, 0, 0));
  for (const double depth : {1e-13, 1e-12, 1e-10, 0.9e-9 * R})
    for (const Method method : {Method::pdg, Method::pdt}) {
      const Pose X{Quat::Identity(), Vec3(2 - depth, 0, 0)};
      const auto s = touching_separation(*cube, *cube, X, method);
      ASSERT_TRUE(s) << depth;
      EXPECT_NEAR(s->depth, depth, 1.5 * rounding) << depth;
      test::check_separation(*cube, *cube, *s, "shallow");
    }
}

// Reference: what two bodies do that overlap by more, or have no room, is the search's.
TEST(Touching, is_not_where_bodies_overlap_or_fit_exactly) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const auto none = [](const auto& probe, const auto& fixed, const Pose& X) {
    return !touching_separation(*probe, *fixed, X, Method::pdg) &&
           !touching_separation(*probe, *fixed, X, Method::pdt);
  };
  EXPECT_TRUE(none(cube, cube, {}));  // at the very pose of itself
  EXPECT_TRUE(none(cube, cube, {Quat::Identity(), Vec3(1 - 1e-8, 0, 0)}));
  EXPECT_TRUE(none(cube, cube, {Quat::Identity(), Vec3(0.5, 0, 0)}));  // four faces in one plane
  EXPECT_TRUE(none(cube, test::body(test::box({3, 3, 3})), {}));       // inside, touching nothing
  const auto inner = test::body(test::box({0.5, 0.5, 0.5}));
  EXPECT_TRUE(none(inner, cube, {Quat::Identity(), Vec3(0.25, 0, 0)}));  // inside, at a face
  const PolygonSoup slot =
      touches::both(touches::both(touches::block({-1, -1, -1}, {1, 1, -0.5}),
                                  touches::block({-1, -1, -0.5}, {-0.5, 1, 1})),
                    touches::block({0.5, -1, -0.5}, {1, 1, 1}));
  EXPECT_TRUE(none(cube, test::body(slot), {}));  // as wide as its slot
  // From both sides of a sheet there is no way but off it.
  const auto sheet = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}}, {{0, 1, 2}}});
  EXPECT_TRUE(touching_separation(*cube, *sheet, {Quat::Identity(), Vec3(0, 0, 0.5)}, Method::pdg));
  EXPECT_TRUE(touching_separation(*sheet, *sheet, {}, Method::pdg));  // in one plane
}

}  // namespace
}  // namespace sonde
