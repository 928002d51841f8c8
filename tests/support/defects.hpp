// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde::test {

/// Meshes with the defects that files have, made from sound ones.

PolygonSoup joined(PolygonSoup a, const PolygonSoup& b, const Vec3& by = Vec3::Zero());
PolygonSoup turned_over(PolygonSoup soup);
/// The mesh with the polygons of these numbers again, turned over or not.
PolygonSoup repeated(PolygonSoup soup, const std::vector<std::size_t>& which, bool turned);
PolygonSoup placed(PolygonSoup soup, const Vec3& by);
PolygonSoup moved(PolygonSoup soup, const std::function<Vec3(const Vec3&)>& move);
/// Triangles alone.
PolygonSoup triangulated(const PolygonSoup& soup);
/// Each triangle with corners of its own, each up to `by` m off in every coordinate.
PolygonSoup cracked(const PolygonSoup& soup, double by, std::uint64_t seed);
/// Every triangle whose middle lies on one side of a plane, cut in four by the middles of its
/// sides, each up to `by` m off: along the cut, the corners of the ones lie on the sides of the
/// others.
PolygonSoup cut_beyond(const PolygonSoup& soup, const Vec3& normal, double at, double by = 0);
/// Some of the triangles (one in `one_in`), each cut in two at one of its sides or in three at two
/// of them, by corners up to `by` m off: they lie on the sides of the neighbours.
PolygonSoup cut_here_and_there(const PolygonSoup& soup, int one_in, double by, std::uint64_t seed);
/// Without the triangles that the predicate holds for, by their middles.
PolygonSoup without(const PolygonSoup& soup, const std::function<bool(const Vec3&)>& left_out);
/// A profile of (radius, height), counter-clockwise about its inside, turned about the z axis in
/// `n` steps. A radius of 0 is a corner on the axis.
PolygonSoup lathed(const std::vector<Eigen::Vector2d>& profile, int n);
/// m³: the volume of that, a sum of frusta over regular polygons.
double lathed_volume(const std::vector<Eigen::Vector2d>& profile, int n);
/// An icosphere: 20 · 4ⁿ triangles.
PolygonSoup icosphere(double radius, int times);
/// A prism over a polygon in the xy plane (counter-clockwise), from z = 0 to `height`.
PolygonSoup prism(const std::vector<Eigen::Vector2d>& outline, double height);

}  // namespace sonde::test
