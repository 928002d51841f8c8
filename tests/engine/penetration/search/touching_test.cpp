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
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Two meshes that touch as they are, and the directions in which the probe comes free.
struct Touch {
  std::string name;
  PolygonSoup probe, fixed;
  std::vector<Vec3> normals;  ///< of its contacts, from the fixed body to the probe
  bool convex = true;         ///< both bodies
  bool unique = true;         ///< of one normal, and no other separates the bodies
};

PolygonSoup moved(const PolygonSoup& soup, const Vec3& by) {
  return test::scaled_and_moved(soup, 1, by);
}
PolygonSoup block(const Vec3& low, const Vec3& high, int n = 1) {
  return moved(test::cut_block(high - low, {.n = n}), 0.5 * (low + high));
}
PolygonSoup both(PolygonSoup a, const PolygonSoup& b) {
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (Polygon polygon : b.polygons) {
    for (std::size_t& i : polygon) i += n;
    a.polygons.push_back(polygon);
  }
  return a;
}
Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}
/// The lowest point at the origin.
PolygonSoup on_its_tip(PolygonSoup soup) {
  const auto tip = std::min_element(soup.points.begin(), soup.points.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  return moved(soup, -*tip);
}
PolygonSoup upside_down(const PolygonSoup& soup) {
  return test::turned(soup, about(Vec3::UnitX(), std::numbers::pi));
}
/// A pyramid of so many sides, tip at the origin, downwards.
PolygonSoup spike(int sides, double radius, double height) {
  PolygonSoup out;
  out.points.push_back(Vec3::Zero());
  Polygon lid;
  for (int i = 0; i < sides; ++i) {
    const double a = test::two_pi * (i + 0.3) / sides;
    out.points.emplace_back(radius * std::cos(a), radius * std::sin(a), height);
    const auto at = static_cast<std::size_t>(i);
    lid.push_back(at + 1);
    out.polygons.push_back({0, (at + 1) % static_cast<std::size_t>(sides) + 1, at + 1});
  }
  out.polygons.push_back(lid);
  return out;
}
/// A bar along x whose lower edge is the x axis, with flanks at that angle off the vertical.
PolygonSoup ridge(double length, double half_angle, double height) {
  const double half = height * std::tan(half_angle);
  PolygonSoup out;
  for (const double x : {-0.5 * length, 0.5 * length})
    for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x, half, height), Vec3(x, -half, height)})
      out.points.push_back(p);
  out.polygons = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return out;
}

std::vector<Touch> faces_on_faces() {
  const Vec3 up = Vec3::UnitZ();
  const PolygonSoup table = block({-0.5, -0.4, -0.1}, {0.6, 0.7, 0}, 3);
  return {
      {"block on block", block({-0.1, -0.1, 0}, {0.2, 0.15, 0.3}, 4), table, {up}},
      {"the same face", block({-1, -1, 0}, {1, 1, 2}), block({-1, -1, -2}, {1, 1, 0}), {up}},
      {"rod on block", moved(test::cut_rod(0.08, 0.2, 24, {.n = 2}), {0.1, 0.2, 0.1}), table, {up}},
      {"a slice over the rim",
       moved(test::cut_rod(0.3, 0.01, 48, {}), {0.5, 0.3, 0.005}),
       table,
       {up}},
      {"corners of faces overlap", block({0.5, 0.6, 0}, {0.9, 1.1, 0.1}, 5), table, {up}},
      {"a long face across", block({-3, 0.1, 0}, {3, 0.11, 0.2}, 2), table, {up}},
      {"a plate that covers all", block({-2, -2, 0}, {2, 3, 0.02}, 7), table, {up}}};
}

std::vector<Touch> edges_on_edges() {
  const Vec3 up = Vec3::UnitZ();
  std::vector<Touch> out;
  for (const double angle : {0.3, 0.9, 1.5})
    out.push_back({"crossing at " + std::to_string(angle),
                   test::turned(ridge(0.4, 0.5, 0.2), about(up, angle)),
                   moved(upside_down(ridge(1, 0.9, 0.3)), {0.05, 0, 0}),
                   {up}});
  out.push_back({"parallel",
                 moved(ridge(0.4, 0.6, 0.1), {0.1, 0, 0}),
                 upside_down(ridge(1, 0.7, 0.2)),
                 {up},
                 true,
                 false});
  out.push_back({"in one line, by a part",
                 moved(ridge(0.4, 0.2, 0.3), {0.5, 0, 0}),
                 upside_down(ridge(0.7, 0.3, 0.2)),
                 {up},
                 true,
                 false});
  out.push_back({"blocks along an edge",
                 block({0, -1, 0}, {1, 0.5, 1}, 2),
                 block({-1, -1, -1}, {0, 1, 0}, 3),
                 {},
                 true,
                 false});
  out.push_back({"edge on a face",
                 moved(ridge(0.3, 0.8, 0.1), {0.1, 0.05, 0}),
                 block({-1, -1, -0.3}, {1, 1, 0}, 4),
                 {up}});
  out.push_back({"edge over the rim",
                 moved(ridge(3, 0.4, 0.1), {0.1, 0.05, 0}),
                 block({-1, -1, -0.3}, {1, 1, 0}),
                 {up}});
  return out;
}

std::vector<Touch> corners() {
  const Vec3 up = Vec3::UnitZ();
  const PolygonSoup table = block({-0.5, -0.4, -0.1}, {0.6, 0.7, 0}, 3);
  const PolygonSoup cube = test::box({0.2, 0.3, 0.25});
  std::vector<Touch> out;
  for (const double a : {0.4, 0.7, 1.0})
    out.push_back(
        {"corner of a block at " + std::to_string(a) + " on a face",
         moved(on_its_tip(test::turned(cube, about(Vec3(1, a, 0.2), a))), {0.1, a / 3, 0}),
         table,
         {up}});
  out.push_back({"tetrahedron on a face",
                 on_its_tip(test::turned(test::tetrahedron(0.3), about(Vec3(1, 2, 0), 0.3))),
                 table,
                 {up}});
  out.push_back({"spike on a face", moved(spike(9, 0.05, 0.3), {-0.2, 0.6, 0}), table, {up}});
  out.push_back({"face on a corner",
                 block({-0.3, -0.2, 0}, {0.3, 0.5, 0.2}, 2),
                 upside_down(spike(5, 0.2, 0.4)),
                 {up}});
  for (const int sides : {3, 4, 7})
    out.push_back({"tip on tip, " + std::to_string(sides),
                   spike(sides, 0.2, 0.1),
                   upside_down(spike(sides + 1, 0.3, 0.4)),
                   {},
                   true,
                   false});
  out.push_back({"corner on corner",
                 block({0, 0, 0}, {1, 0.5, 0.7}, 2),
                 block({-1, -1, -1}, {0, 0, 0}, 2),
                 {},
                 true,
                 false});
  out.push_back({"corner of a block on the edge of another",
                 block({0, -0.2, 0}, {1, 0.5, 0.7}),
                 moved(upside_down(ridge(2, 0.6, 0.3)), {0.3, -0.2, 0}),
                 {},
                 true,
                 false});
  return out;
}

std::vector<Touch> flush() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const PolygonSoup floor = block({-1, -1, -1}, {1, 1, 0}, 2);
  const PolygonSoup wall = block({-1, -1, 0}, {0, 1, 1}, 3), far = block({0.8, -1, 0}, {1, 1, 1});
  return {
      {"floor and wall", block({0, -0.2, 0}, {0.4, 0.3, 0.5}, 2), both(floor, wall), {x, z}, false},
      {"a slot with room on one side",
       block({0, -0.2, 0}, {0.7, 0.3, 0.5}, 3),
       both(both(floor, wall), far),
       {x, z},
       false},
      {"a corner of three",
       block({0, -0.2, 0}, {0.4, 0.3, 0.5}, 2),
       both(both(floor, wall), block({0, -1, 0}, {1, -0.2, 0.6}, 2)),
       {x, y, z},
       false},
      {"a wedge in its notch",
       test::cut_wedge({.n = 2}),
       test::cut_notched_block({.n = 3}),
       {Vec3(std::cos(test::notch_half_angle), 0, std::sin(test::notch_half_angle)),
        Vec3(-std::cos(test::notch_half_angle), 0, std::sin(test::notch_half_angle))},
       false}};
}

std::vector<Touch> all() {
  std::vector<Touch> out = faces_on_faces();
  for (const auto& some : {edges_on_edges(), corners(), flush()})
    out.insert(out.end(), some.begin(), some.end());
  return out;
}

/// A touch somewhere in space: at any scale, the meshes in frames of their own, so that
/// coordinates are rounded.
class Placed {
 public:
  Placed(const Touch& touch, double scale, std::mt19937_64& random)
      : scale_(scale), turn_(test::random_rotation(random)) {
    const Vec3 place = scale * test::random_in_ball(random, 2);
    const Pose frame{test::random_rotation(random), scale * test::random_in_ball(random, 1)};
    fixed = made(touch.fixed, {turn_, place});
    probe = made(touch.probe, frame);
    touching = Pose{turn_, place} * inverse(frame);
    rounding = rounding_guard(extent(*probe), extent(*fixed), touching.p);
    for (const Vec3& n : touch.normals) {
      normals.push_back(turn_ * n);
      out += normals.back();
    }
    if (touch.normals.empty()) out = turn_ * Vec3(1, 1, 1);  // all of those are in x, y, z < 0
    if (touch.normals.empty() && touch.name.starts_with("tip")) out = turn_ * Vec3::UnitZ();
    out.normalize();
  }
  /// That much off along the way out, m; inwards below 0.
  Pose off(double way) const { return {touching.q.normalized(), touching.p + way * out}; }
  /// Surely in contact, whatever was rounded.
  Pose contact() const { return off(-0.25 * rounding); }

  std::shared_ptr<const Body> probe, fixed;
  std::vector<Vec3> normals;
  Vec3 out = Vec3::Zero();
  Pose touching;
  double rounding = 0;

 private:
  std::shared_ptr<const Body> made(PolygonSoup soup, const Pose& X) const {
    for (Vec3& p : soup.points) p = X * Vec3(scale_ * p);
    return test::body(soup);
  }
  double scale_;
  Quat turn_;
};

/// The gap of two convex bodies along a direction, m.
double gap_of_all(const Vec3& n, const Body& probe, const Body& fixed, const Pose& X) {
  double low = 1e300, high = -1e300;
  for (const Vec3& p : probe.soup.vertices) low = std::min(low, n.dot(X * p));
  for (const Vec3& p : fixed.soup.vertices) high = std::max(high, n.dot(p));
  return low - high;
}

void expect_touching(const Touch& touch, const Placed& at, const Separation& s,
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
  for (const Touch& touch : all())
    for (const double scale : scales) {
      const Placed at(touch, scale, random);
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
  for (const Touch& touch : faces_on_faces()) {
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
  for (const Touch& touch : all()) {
    const Placed at(touch, scales[k++ % 4], random);
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
  for (const Touch& touch : all())
    for (const Method method : {Method::pdg, Method::pdt})
      for (const double start : {-0.25, 0.0, 0.5}) {
        const Placed at(touch, scales[k++ % 4], random);
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
      both(both(block({-1, -1, -1}, {1, 1, -0.5}), block({-1, -1, -0.5}, {-0.5, 1, 1})),
           block({0.5, -1, -0.5}, {1, 1, 1}));
  EXPECT_TRUE(none(cube, test::body(slot), {}));  // as wide as its slot
  // From both sides of a sheet there is no way but off it.
  const auto sheet = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}}, {{0, 1, 2}}});
  EXPECT_TRUE(touching_separation(*cube, *sheet, {Quat::Identity(), Vec3(0, 0, 0.5)}, Method::pdg));
  EXPECT_TRUE(touching_separation(*sheet, *sheet, {}, Method::pdg));  // in one plane
}

}  // namespace
}  // namespace sonde
