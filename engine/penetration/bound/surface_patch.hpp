// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// The triangles of a body's mesh near a point, with their neighbours.
struct LocalSurface {
  static constexpr std::uint32_t none = 0xffffffffu;
  Soup soup;  ///< in a common frame F, m; no two triangles have the same corners
  /// Across the edge from corner k to the next: the only other triangle here with that edge, or
  /// none.
  std::vector<std::array<std::uint32_t, 3>> neighbour;
  std::size_t size() const { return soup.triangles.size(); }
  Corners at(std::uint32_t triangle) const { return corners(soup, triangle); }
  /// Of the triangles within `slack` (m) of x, the one whose plane is most nearly perpendicular to
  /// `normal`; `none` if there is no such triangle.
  std::uint32_t about(const Vec3& x, const Vec3& normal, double slack) const;
};

/// The triangles within `reach` (m) of x (in F), without duplicates. At most `most`: if there are
/// more, the reach is reduced, and if more than that meet at x itself, some of these are returned.
/// The triangles are those of the mesh as given, in which neighbours share their corners. (In
/// surface(body), a merged flat part may pass over corners of the part beside it.) Adds the work of
/// the search to `work`.
LocalSurface local_surface(const Body& body, const Transform& X_FB, const Vec3& x, double reach,
                           std::size_t most, std::int64_t& work);
/// Whether local_surface compares x with every triangle of the body's mesh.
bool scans_mesh(const Body& body);

/// Triangles (or segments, as triangles with two equal corners) to measure distances from.
class TriangleSet {
 public:
  void add(const Corners& t);
  std::size_t size() const { return at_.size(); }
  /// m, infinite if the set is empty. Accurate as closest_points is. Adds to the counted work: 1
  /// for a triangle compared by its ball, 40 for one compared exactly.
  double distance(const Corners& from, std::int64_t& work) const;
  /// The number of triangles that the segment pierces. No value if that is uncertain for some
  /// triangle, because rounding errors (`guard`, m) could change it.
  std::optional<int> pierced(const Vec3& from, const Vec3& to, double guard,
                             std::int64_t& work) const;

 private:
  std::vector<Corners> at_;
  std::vector<Vec3> center_;
  std::vector<Vec3> normal_;    // unit; 0 of a segment
  std::vector<double> uneven_;  // m: error of a height over the plane, due to the normal's rounding
  std::vector<double> radius_;
};

/// A connected part of a surface that faces roughly one way, and its border.
struct SurfacePatch {
  TriangleSet triangles, border;
};
/// Grows from triangle `seed` over triangles whose normals are at an angle to the seed's with a
/// cosine above `least_cosine`. Normals are carried over from neighbour to neighbour, so the order
/// of the corners does not matter.
SurfacePatch patch_about(const LocalSurface& surface, std::uint32_t seed, double least_cosine);

/// The curve in which a plane cuts a surface through a point x of a triangle, from x both ways. If
/// the curve is closed, both parts end at the same point.
struct PlaneCut {
  std::vector<Vec3> ahead, behind;  ///< in F, m; x is the first of both
};
/// `normal`: of the plane. No value if the plane does not cut triangle `seed`. Follows the curve
/// over at most `most` triangles each way.
std::optional<PlaneCut> plane_cut(const LocalSurface& surface, std::uint32_t seed, const Vec3& x,
                                  const Vec3& normal, std::size_t most);

}  // namespace sonde
