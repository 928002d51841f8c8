// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/thin_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/offset/corner_planes.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "engine/proximity/queries/self_intersections.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {
namespace {

/// Each looks at every triangle: enough to name a place by.
constexpr std::size_t most_places = 64;

Corners corners_of(const Soup& soup, std::uint32_t t) {
  const Triangle& triangle = soup.triangles[t];
  return {soup.vertices[triangle[0]], soup.vertices[triangle[1]], soup.vertices[triangle[2]]};
}
Vec3 middle(const Corners& c) { return (c[0] + c[1] + c[2]) / 3; }

/// The faces around a corner: unit normals, outwards.
struct CornerFaces {
  std::vector<Vec3> normals;
  bool concave = false;  ///< somewhere: what is next to one of them stands above it
};

/// The largest cosine between a unit direction and those from n to m, the short way round.
double nearest_between(const Vec3& n, const Vec3& m, const Vec3& direction) {
  const double at_n = n.dot(direction), at_m = m.dot(direction), c = n.dot(m);
  // Of the part of the direction in their plane, as a combination of the two.
  const double by_n = at_n - c * at_m, by_m = at_m - c * at_n, s2 = 1 - c * c;
  if (!(by_n > 0 && by_m > 0 && s2 > 0)) return std::max(at_n, at_m);
  return std::sqrt((by_n * at_n + by_m * at_m) / s2);
}

/// How much of a way leads inwards: along the normal there, or the one of those that a ball which
/// touches a concave corner from inside may have.
double inwards(const CornerFaces& corner, const Vec3& way) {
  const Vec3 back = -way.normalized();
  double most = -1;
  if (corner.concave) {
    for (const Vec3& n : corner.normals)
      for (const Vec3& m : corner.normals) most = std::max(most, nearest_between(n, m, back));
  } else {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& n : corner.normals) sum += n;
    most = sum.normalized().dot(back);
  }
  return most * way.norm();
}

/// Where a line crosses a triangle, from x along a unit direction.
std::optional<double> crossed(const Corners& c, const Vec3& x, const Vec3& direction) {
  const Vec3 n = area_normal(c);
  const double slope = n.dot(direction);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = c[k];
    const Vec3& b = c[(k + 1) % 3];
    if (std::copysign(1.0, slope) * (a - x).cross(b - x).dot(direction) < 0) return std::nullopt;
  }
  return n.dot(c[0] - x) / slope;
}

class ThinFinder {
 public:
  ThinFinder(const Body& nominal, const Soup& soup, const Fans& fans, const MovedFaces& moved)
      : body_(nominal),
        soup_(soup),
        moved_(moved),
        way_(-moved.offset.by),
        piece_(pieces_of(fans)) {
    hollow_.assign(piece_.empty() ? 0 : 1 + *std::ranges::max_element(piece_), 0);
    const Vec3 origin = nominal.mass.com;
    for (std::uint32_t t = 0; t < piece_.size(); ++t) {
      const Corners c = corners_of(soup_, t);
      hollow_[piece_[t]] += area_normal(c).dot(c[0] - origin);
    }
  }

  std::optional<ThinPlace> find(const Progress& progress) {
    for (const std::uint32_t t : moved_.turned_over) suspect(t);
    if (suspects_.empty() && !moved_.soup.triangles.empty()) {
      find_crossings(part_of(progress, 0, 0.8));
      find_broken_hollows(part_of(progress, 0.8, 0.9));
    }
    if (suspects_.empty() && !moved_.soup.triangles.empty()) return std::nullopt;
    if (suspects_.empty()) suspect(0);  // nothing is left
    return thinnest();
  }

 private:
  bool is_hollow(std::uint32_t t) const { return hollow_[piece_[t]] < 0; }
  void suspect(std::uint32_t t) {
    if (suspects_.size() < most_places) suspects_.push_back(t);
  }

  void find_crossings(const Progress& progress) {
    const double touching = file_rounding(soup_);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for_each_meeting(
        moved_.soup,
        [&](std::uint32_t a, std::uint32_t b) {
          a = moved_.from[a];
          b = moved_.from[b];
          if (piece_[a] != piece_[b] && !is_hollow(a) && !is_hollow(b)) return true;
          const double before = closest_points(corners_of(soup_, a), corners_of(soup_, b)).distance;
          if (before > touching) pairs.emplace_back(a, b);
          return pairs.size() < most_crossings;
        },
        part_of(progress, 0, 0.6));
    if (pairs.empty()) return;
    const std::vector<bool> crossed_before = near_crossings(part_of(progress, 0.6, 1));
    for (const auto& [a, b] : pairs)
      if (!crossed_before[a] && !crossed_before[b]) {
        suspect(a);
        suspect(b);
      }
  }

  /// What went through itself in the mesh goes on doing so, somewhere near: not a thin place. Nor
  /// is a fold.
  std::vector<bool> near_crossings(const Progress& progress) const {
    std::vector<bool> vertex(soup_.vertices.size(), false), near(soup_.triangles.size(), false);
    for (const std::uint32_t t : self_intersections(soup_, progress).triangles)
      for (const std::uint32_t corner : soup_.triangles[t]) vertex[corner] = true;
    for (const std::uint32_t t : moved_.folded)
      for (const std::uint32_t corner : soup_.triangles[t]) vertex[corner] = true;
    for (std::uint32_t t = 0; t < near.size(); ++t)
      near[t] =
          std::ranges::any_of(soup_.triangles[t], [&](auto corner) { return vertex[corner]; });
    return near;
  }

  /// A hollow that has grown through its wall altogether crosses nothing.
  void find_broken_hollows(const Progress& progress) {
    constexpr double rounding = 1e-6;
    if (std::ranges::none_of(hollow_, [](double v) { return v < 0; })) return;
    for_each_index(moved_.soup.triangles.size(), progress, [&](std::size_t i) {
      if (!is_hollow(moved_.from[i]) || suspects_.size() >= most_places) return;
      const Vec3 x = middle(corners_of(moved_.soup, std::uint32_t(i)));
      if (point_distance(body_, x, way_ / 2) < way_ * (1 - rounding) - 1e-15 * x.norm())
        suspect(moved_.from[i]);
    });
  }

  /// From the middles of the faces there straight through the material, and from their corners by
  /// the smallest ball that touches there and reaches something that looks the other way.
  ThinPlace thinnest() const {
    ThinPlace least{std::numeric_limits<double>::infinity(), body_.mass.com};
    std::map<std::uint32_t, CornerFaces> corners;
    for (const std::uint32_t t : suspects_)
      for (const std::uint32_t vertex : soup_.triangles[t]) corners[vertex] = {};
    std::vector<std::uint32_t> faces;
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      bool there = false;
      for (const std::uint32_t vertex : soup_.triangles[t])
        if (const auto found = corners.find(vertex); found != corners.end()) {
          found->second.normals.push_back(area_normal(corners_of(soup_, t)).normalized());
          there = true;
        }
      if (there && faces.size() < most_places) faces.push_back(t);
    }
    for (const std::uint32_t t : faces) look_through(t, least);
    const double rounding = file_rounding(soup_);
    for (const Triangle& t : soup_.triangles)
      for (const std::uint32_t vertex : t)
        if (const auto found = corners.find(vertex); found != corners.end())
          for (const Vec3& n : found->second.normals)
            for (const std::uint32_t other : t)
              found->second.concave =
                  found->second.concave ||
                  n.dot(soup_.vertices[other] - soup_.vertices[vertex]) > rounding;
    std::size_t tried = 0;
    for (const auto& [vertex, around] : corners)
      if (tried++ < most_places) look_across(soup_.vertices[vertex], around, least);
    return least;
  }

  void look_through(std::uint32_t face, ThinPlace& least) const {
    const Corners from = corners_of(soup_, face);
    const Vec3 x = middle(from), direction = -area_normal(from).normalized();
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      const Corners other = corners_of(soup_, t);
      if (!(area_normal(other).dot(direction) > 0)) continue;
      const std::optional<double> through = crossed(other, x, direction);
      if (through && *through > 0 && *through < least.thickness) least = {*through, x};
    }
  }

  void look_across(const Vec3& x, const CornerFaces& around, ThinPlace& least) const {
    const double here = file_rounding(soup_);
    Vec3 outwards = Vec3::Zero();
    for (const Vec3& n : around.normals) outwards += n;
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      const Corners other = corners_of(soup_, t);
      const Vec3 normal = area_normal(other);
      if (normal.dot(outwards) >= 0 || normal.dot(other[0] - x) <= 0) continue;
      const Vec3 way = closest_points({x, x, x}, other).b - x;
      if (way.norm() <= here) continue;
      const double in = inwards(around, way);
      if (!(in > 0)) continue;
      const double across = way.squaredNorm() / in;
      if (across < least.thickness) least = {across, x};
    }
  }

  static constexpr std::size_t most_crossings = 1000;
  const Body& body_;
  const Soup& soup_;
  const MovedFaces& moved_;
  double way_;
  std::vector<std::uint32_t> piece_;  // of each triangle
  std::vector<double> hollow_;        // six times the volume of each piece: below zero, a hollow
  std::vector<std::uint32_t> suspects_;
};

}  // namespace

std::optional<ThinPlace> find_thin_place(const Body& nominal, const Soup& soup, const Fans& fans,
                                         const MovedFaces& moved, const Progress& progress) {
  return ThinFinder(nominal, soup, fans, moved).find(progress);
}

}  // namespace sonde
