// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Factor on the reach while too many triangles are within it.
constexpr double nearer = 0.7;
constexpr int work_of_exact = 40;

/// A side of a triangle of a local surface, by its vertices.
struct Side {
  std::uint32_t low, high;
  std::uint32_t of;  ///< 3 × triangle + side
};

void connect(LocalSurface& surface) {
  std::vector<Side> sides;
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(surface.vertices[i][k], surface.vertices[i][(k + 1) % 3]);
      sides.push_back({low, high, 3 * i + k});
    }
  ordering::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  surface.neighbour.assign(surface.size(),
                           {LocalSurface::none, LocalSurface::none, LocalSurface::none});
  const auto same = [&](std::size_t i, std::size_t j) {
    return sides[i].low == sides[j].low && sides[i].high == sides[j].high;
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && same(i, end);) ++end;
    if (end != i + 2) continue;
    const std::uint32_t a = sides[i].of, b = sides[i + 1].of;
    surface.neighbour[a / 3][a % 3] = b / 3;
    surface.neighbour[b / 3][b % 3] = a / 3;
  }
}

Vec3 unit_normal(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

std::size_t side_towards(const LocalSurface& surface, std::uint32_t from, std::uint32_t to) {
  std::size_t k = 0;
  while (k < 2 && surface.neighbour[from][k] != to) ++k;
  return k;
}

/// Triangles of surface(body) within the reach of x, or within as much of it as holds no more than
/// `most`.
std::vector<std::uint32_t> near_by_tree(const Body& body, const Vec3& x, double reach,
                                        std::size_t most) {
  std::vector<std::uint32_t> out(most + 1);
  std::size_t count = 0;
  while ((count = triangles_within(body, x, reach, out)) > most) reach *= nearer;
  out.resize(count);
  return out;
}

/// The `most` triangles whose boxes are nearest to x, of those within the reach.
std::vector<std::uint32_t> near_by_scan(const Soup& mesh, const Vec3& x, double reach,
                                        std::size_t most) {
  struct Near {
    double squared;
    std::uint32_t triangle;
    bool operator<(const Near& o) const {
      return squared != o.squared ? squared < o.squared : triangle < o.triangle;
    }
  };
  std::vector<Near> all;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = corners(mesh, i);
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    const double squared = (x - x.cwiseMax(low).cwiseMin(high)).squaredNorm();
    if (squared <= reach * reach) all.push_back({squared, i});
  }
  if (all.size() > most) {
    ordering::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most), all.end());
    all.resize(most);
  }
  std::vector<std::uint32_t> out;
  out.reserve(all.size());
  for (const Near& n : all) out.push_back(n.triangle);
  return out;
}

/// Follows a plane's cut over the neighbours of a triangle.
class Walk {
 public:
  Walk(const LocalSurface& surface, const Vec3& x, const Vec3& normal)
      : surface_(surface), x_(x), normal_(normal) {}

  bool is_cut(std::uint32_t triangle, std::size_t side) const {
    return above(triangle, side) != above(triangle, (side + 1) % 3);
  }
  Vec3 point_on(std::uint32_t triangle, std::size_t side) const {
    // From the lower vertex, so that both triangles of a side give the same bits.
    std::size_t a = side, b = (side + 1) % 3;
    if (surface_.vertices[triangle][a] > surface_.vertices[triangle][b]) std::swap(a, b);
    const double ha = height(triangle, a), hb = height(triangle, b);
    return surface_.at[triangle][a] +
           ha / (ha - hb) * (surface_.at[triangle][b] - surface_.at[triangle][a]);
  }
  /// The points after that on `side` of triangle `seed`, outwards. Returns whether the walk came
  /// back to the seed.
  bool from(std::uint32_t seed, std::size_t side, std::size_t most, std::vector<Vec3>& out) const {
    std::uint32_t here = seed;
    while (out.size() < most) {
      const std::uint32_t next = surface_.neighbour[here][side];
      if (next == LocalSurface::none) return false;
      if (next == seed) return true;
      const std::size_t in = side_towards(surface_, next, here);
      const std::size_t first = (in + 1) % 3, second = (in + 2) % 3;
      side = is_cut(next, first) ? first : second;
      out.push_back(point_on(next, side));
      here = next;
    }
    return false;
  }

 private:
  double height(std::uint32_t triangle, std::size_t corner) const {
    return normal_.dot(surface_.at[triangle][corner] - x_);
  }
  bool above(std::uint32_t triangle, std::size_t corner) const {
    return height(triangle, corner) > 0;
  }
  const LocalSurface& surface_;
  Vec3 x_, normal_;
};

}  // namespace

std::uint32_t LocalSurface::nearest(const Vec3& x, const Vec3& normal, double slack) const {
  std::vector<double> away;
  away.reserve(size());
  for (const Corners& t : at) away.push_back(closest_points({x, x, x}, t).distance);
  std::uint32_t out = none;
  double best = -1;
  const double least = away.empty() ? 0 : *std::min_element(away.begin(), away.end());
  for (std::uint32_t i = 0; i < size(); ++i) {
    const double along = std::abs(unit_normal(at[i]).dot(normal));
    if (away[i] <= least + slack && along > best) best = along, out = i;
  }
  return out;
}

LocalSurface local_surface(const Body& body, const Transform& X_FB, const Vec3& x, double reach,
                           std::size_t most, std::int64_t& work) {
  const Vec3 x_B = X_FB.R.transpose() * (x - X_FB.p);
  const Soup& mesh = body.joined.triangles.empty() ? body.soup : body.joined;
  const std::vector<std::uint32_t> near = &mesh == &surface(body)
                                              ? near_by_tree(body, x_B, reach, most)
                                              : near_by_scan(mesh, x_B, reach, most);
  work += static_cast<std::int64_t>(&mesh == &surface(body) ? near.size() : mesh.triangles.size());
  LocalSurface out;
  std::vector<Triangle> sorted;
  for (const std::uint32_t i : near) {
    Triangle t = mesh.triangles[i];
    ordering::sort(t);
    sorted.push_back(t);
  }
  std::vector<std::uint32_t> order(near.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  ordering::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && sorted[order[i]] == sorted[order[i - 1]]) continue;
    const std::uint32_t triangle = near[order[i]];
    out.at.push_back(place(X_FB, corners(mesh, triangle)));
    out.vertices.push_back(mesh.triangles[triangle]);
  }
  connect(out);
  return out;
}

void TriangleSet::add(const Corners& t) {
  at_.push_back(t);
  center_.push_back((t[0] + t[1] + t[2]) / 3);
  normal_.push_back(unit_normal(t));
  double squared = 0;
  for (const Vec3& v : t) squared = std::max(squared, (v - center_.back()).squaredNorm());
  radius_.push_back(std::sqrt(squared) * (1 + 1e-12));
}

double TriangleSet::distance(const Corners& from, std::int64_t& work) const {
  work += static_cast<std::int64_t>(at_.size());
  const Vec3 middle = (from[0] + from[1] + from[2]) / 3;
  double radius = 0, least = infinity;
  for (const Vec3& v : from) radius = std::max(radius, (v - middle).norm() * (1 + 1e-12));
  for (const Vec3& c : center_) least = std::min(least, (c - middle).squaredNorm());
  least = std::sqrt(least) * (1 + 1e-12);
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const double most = least + radius + radius_[i];
    if ((center_[i] - middle).squaredNorm() > most * most) continue;
    work += work_of_exact;
    least = std::min(least, closest_points(from, at_[i]).distance);
  }
  return least;
}

std::optional<int> TriangleSet::pierced(const Vec3& from, const Vec3& to, double guard,
                                        std::int64_t& work) const {
  work += static_cast<std::int64_t>(at_.size());
  const Vec3 middle = (from + to) / 2;
  const double half = (to - from).norm() / 2 * (1 + 1e-12) + guard;
  const Corners segment{from, to, to};
  int count = 0;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const double most = half + radius_[i];
    if ((center_[i] - middle).squaredNorm() > most * most) continue;
    const double a = normal_[i].dot(from - center_[i]), b = normal_[i].dot(to - center_[i]);
    if (std::min(a, b) > guard || std::max(a, b) < -guard) continue;  // on one side of its plane
    work += work_of_exact;
    if (closest_points(segment, at_[i]).distance > guard) continue;
    if (classify(segment, at_[i]) != Meeting::meeting) return std::nullopt;
    ++count;
  }
  return count;
}

SurfacePatch patch_about(const LocalSurface& surface, std::uint32_t seed, double least_cosine) {
  std::vector<char> in(surface.size(), 0);
  std::vector<std::uint32_t> all{seed};
  std::vector<Vec3> normal{unit_normal(surface.at[seed])};
  in[seed] = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t here = all[i];
    // Whichever way round the corners of either triangle are, the normals are on one side.
    const bool kept = unit_normal(surface.at[here]).dot(normal[i]) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = surface.neighbour[here][k];
      if (next == LocalSurface::none || in[next]) continue;
      const std::size_t back = side_towards(surface, next, here);
      const bool same_way = surface.vertices[next][back] != surface.vertices[here][k];
      Vec3 n = unit_normal(surface.at[next]);
      if (same_way != kept) n = -n;
      if (!(n.dot(normal[0]) > least_cosine)) continue;
      in[next] = 1;
      all.push_back(next);
      normal.push_back(n);
    }
  }
  SurfacePatch out;
  for (const std::uint32_t i : all) {
    const Corners& t = surface.at[i];
    out.triangles.add(t);
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.neighbour[i][k] == LocalSurface::none || !in[surface.neighbour[i][k]])
        out.border.add({t[k], t[(k + 1) % 3], t[(k + 1) % 3]});
  }
  return out;
}

std::optional<PlaneCut> plane_cut(const LocalSurface& surface, std::uint32_t seed, const Vec3& x,
                                  const Vec3& normal, std::size_t most) {
  const Walk walk(surface, x, normal);
  std::vector<std::size_t> sides;
  for (std::size_t k = 0; k < 3; ++k)
    if (walk.is_cut(seed, k)) sides.push_back(k);
  if (sides.size() != 2) return std::nullopt;
  PlaneCut out{{x, walk.point_on(seed, sides[0])}, {x, walk.point_on(seed, sides[1])}};
  if (!walk.from(seed, sides[0], most, out.ahead)) {
    walk.from(seed, sides[1], most, out.behind);
    return out;
  }
  // It came back to the side behind x: half of it belongs to the other way.
  const auto half = out.ahead.begin() + static_cast<std::ptrdiff_t>(1 + out.ahead.size() / 2);
  out.behind.assign(out.ahead.rbegin(), std::make_reverse_iterator(half - 1));
  out.behind.insert(out.behind.begin(), x);
  out.ahead.erase(half, out.ahead.end());
  return out;
}

}  // namespace sonde
