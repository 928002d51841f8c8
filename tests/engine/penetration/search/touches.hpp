// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

// Pairs of bodies that only touch: faces, edges and corners, by hand.
namespace sonde::test {

/// Two meshes that touch as they are, and the directions in which the probe comes free.
struct Touch {
  std::string name;
  PolygonSoup probe, fixed;
  std::vector<Vec3> normals;  ///< of its contacts, from the fixed body to the probe
  bool convex = true;         ///< both bodies
  bool unique = true;         ///< of one normal, and no other separates the bodies
};

namespace touches {

inline PolygonSoup moved(const PolygonSoup& soup, const Vec3& by) {
  return scaled_and_moved(soup, 1, by);
}
inline PolygonSoup block(const Vec3& low, const Vec3& high, int n = 1) {
  return moved(cut_block(high - low, {.n = n}), 0.5 * (low + high));
}
inline PolygonSoup both(PolygonSoup a, const PolygonSoup& b) {
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (Polygon polygon : b.polygons) {
    for (std::size_t& i : polygon) i += n;
    a.polygons.push_back(polygon);
  }
  return a;
}
inline Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}
/// The lowest point at the origin.
inline PolygonSoup on_its_tip(PolygonSoup soup) {
  const auto tip = std::min_element(soup.points.begin(), soup.points.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  return moved(soup, -*tip);
}
inline PolygonSoup upside_down(const PolygonSoup& soup) {
  return turned(soup, about(Vec3::UnitX(), std::numbers::pi));
}
/// A pyramid of so many sides, tip at the origin, downwards.
inline PolygonSoup spike(int sides, double radius, double height) {
  PolygonSoup out;
  out.points.push_back(Vec3::Zero());
  Polygon lid;
  for (int i = 0; i < sides; ++i) {
    const double a = two_pi * (i + 0.3) / sides;
    out.points.emplace_back(radius * std::cos(a), radius * std::sin(a), height);
    const auto at = static_cast<std::size_t>(i);
    lid.push_back(at + 1);
    out.polygons.push_back({0, (at + 1) % static_cast<std::size_t>(sides) + 1, at + 1});
  }
  out.polygons.push_back(lid);
  return out;
}
/// A bar along x whose lower edge is the x axis, with flanks at that angle off the vertical.
inline PolygonSoup ridge(double length, double half_angle, double height) {
  const double half = height * std::tan(half_angle);
  PolygonSoup out;
  for (const double x : {-0.5 * length, 0.5 * length})
    for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x, half, height), Vec3(x, -half, height)})
      out.points.push_back(p);
  out.polygons = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return out;
}

inline std::vector<Touch> faces_on_faces() {
  const Vec3 up = Vec3::UnitZ();
  const PolygonSoup table = block({-0.5, -0.4, -0.1}, {0.6, 0.7, 0}, 3);
  return {
      {"block on block", block({-0.1, -0.1, 0}, {0.2, 0.15, 0.3}, 4), table, {up}},
      {"the same face", block({-1, -1, 0}, {1, 1, 2}), block({-1, -1, -2}, {1, 1, 0}), {up}},
      {"rod on block", moved(cut_rod(0.08, 0.2, 24, {.n = 2}), {0.1, 0.2, 0.1}), table, {up}},
      {"a slice over the rim", moved(cut_rod(0.3, 0.01, 48, {}), {0.5, 0.3, 0.005}), table, {up}},
      {"corners of faces overlap", block({0.5, 0.6, 0}, {0.9, 1.1, 0.1}, 5), table, {up}},
      {"a long face across", block({-3, 0.1, 0}, {3, 0.11, 0.2}, 2), table, {up}},
      {"a plate that covers all", block({-2, -2, 0}, {2, 3, 0.02}, 7), table, {up}}};
}

inline std::vector<Touch> edges_on_edges() {
  const Vec3 up = Vec3::UnitZ();
  std::vector<Touch> out;
  for (const double angle : {0.3, 0.9, 1.5})
    out.push_back({"crossing at " + std::to_string(angle),
                   turned(ridge(0.4, 0.5, 0.2), about(up, angle)),
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

inline std::vector<Touch> corners() {
  const Vec3 up = Vec3::UnitZ();
  const PolygonSoup table = block({-0.5, -0.4, -0.1}, {0.6, 0.7, 0}, 3);
  const PolygonSoup cube = box({0.2, 0.3, 0.25});
  std::vector<Touch> out;
  for (const double a : {0.4, 0.7, 1.0})
    out.push_back({"corner of a block at " + std::to_string(a) + " on a face",
                   moved(on_its_tip(turned(cube, about(Vec3(1, a, 0.2), a))), {0.1, a / 3, 0}),
                   table,
                   {up}});
  out.push_back({"tetrahedron on a face",
                 on_its_tip(turned(tetrahedron(0.3), about(Vec3(1, 2, 0), 0.3))),
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

inline std::vector<Touch> flush() {
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
       cut_wedge({.n = 2}),
       cut_notched_block({.n = 3}),
       {Vec3(std::cos(notch_half_angle), 0, std::sin(notch_half_angle)),
        Vec3(-std::cos(notch_half_angle), 0, std::sin(notch_half_angle))},
       false}};
}

}  // namespace touches

inline std::vector<Touch> all_touches() {
  std::vector<Touch> out = touches::faces_on_faces();
  for (const auto& some : {touches::edges_on_edges(), touches::corners(), touches::flush()})
    out.insert(out.end(), some.begin(), some.end());
  return out;
}

/// A touch somewhere in space: at any scale, the meshes in frames of their own, so that
/// coordinates are rounded.
class PlacedTouch {
 public:
  PlacedTouch(const Touch& touch, double scale, std::mt19937_64& random)
      : scale_(scale), turn_(random_rotation(random)) {
    const Vec3 place = scale * random_in_ball(random, 2);
    const Pose frame{random_rotation(random), scale * random_in_ball(random, 1)};
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
    return body(soup);
  }
  double scale_;
  Quat turn_;
};

}  // namespace sonde::test
