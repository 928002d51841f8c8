// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/geometry/by_corners.hpp"
#include "engine/mending/edge_uses.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Factor on the reach while too many triangles are within it.
constexpr double nearer = 0.7;
constexpr int most_shorter = 60;  // then it is 5e-10 of the first
constexpr int work_of_exact = 40;

void connect(LocalSurface& surface) {
  surface.neighbour.assign(surface.size(),
                           {LocalSurface::none, LocalSurface::none, LocalSurface::none});
  for_each_edge(edge_uses(surface.soup), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const std::uint32_t a = uses[0].side, b = uses[1].side;
    surface.neighbour[a / 3][a % 3] = b / 3;
    surface.neighbour[b / 3][b % 3] = a / 3;
  });
}

/// These triangles of a mesh, placed by X, without duplicates.
Soup extract(const Soup& mesh, const std::vector<std::uint32_t>& some, const Transform& X) {
  std::vector<std::uint32_t> used;
  for (const std::uint32_t i : some)
    used.insert(used.end(), mesh.triangles[i].begin(), mesh.triangles[i].end());
  ordering::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Soup out;
  for (const std::uint32_t i : used) out.vertices.push_back(X * mesh.vertices[i]);
  for (const std::uint32_t i : some) {
    Triangle& t = out.triangles.emplace_back(mesh.triangles[i]);
    for (std::uint32_t& corner : t)
      corner = static_cast<std::uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
  }
  std::vector<Triangle> kept;
  for_each_alike(triangles_by_corners(out), [&](std::span<const CornerTriangle> alike) {
    kept.push_back(out.triangles[alike.front().triangle]);
  });
  out.triangles = std::move(kept);
  return out;
}

Vec3 unit_normal(const Corners& t) { return area_normal(t).normalized(); }

std::size_t side_towards(const LocalSurface& surface, std::uint32_t from, std::uint32_t to) {
  std::size_t k = 0;
  while (k < 2 && surface.neighbour[from][k] != to) ++k;
  return k;
}

/// Triangles of surface(body) within the reach of x, or within a smaller reach that holds at most
/// `most`.
std::vector<std::uint32_t> near_by_tree(const Body& body, const Vec3& x, double reach,
                                        std::size_t most) {
  std::vector<std::uint32_t> out(most + 1);
  std::size_t count = 0;
  const auto count_within = [&](double radius) {
    return count = triangles_within(body, x, radius, out);
  };
  // More of them may meet at x itself.
  for (int i = 0; i < most_shorter && count_within(reach) > most; ++i) reach *= nearer;
  out.resize(std::min(count, most));
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
    if (surface_.soup.triangles[triangle][a] > surface_.soup.triangles[triangle][b])
      std::swap(a, b);
    const double ha = height(triangle, a), hb = height(triangle, b);
    const Corners t = surface_.at(triangle);
    return t[a] + ha / (ha - hb) * (t[b] - t[a]);
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
    return normal_.dot(surface_.at(triangle)[corner] - x_);
  }
  bool above(std::uint32_t triangle, std::size_t corner) const {
    return height(triangle, corner) > 0;
  }
  const LocalSurface& surface_;
  Vec3 x_, normal_;
};

}  // namespace

std::uint32_t LocalSurface::about(const Vec3& x, const Vec3& normal, double slack) const {
  std::uint32_t out = none;
  double best = -1;
  for (std::uint32_t i = 0; i < size(); ++i) {
    const double along = std::abs(unit_normal(at(i)).dot(normal));
    if (along > best && closest_points({x, x, x}, at(i), slack).distance <= slack)
      best = along, out = i;
  }
  return out;
}

bool scans_mesh(const Body& body) { return &surface(body) != &body.soup; }

LocalSurface local_surface(const Body& body, const Transform& X_FB, const Vec3& x, double reach,
                           std::size_t most, std::int64_t& work) {
  const Vec3 x_B = X_FB.R.transpose() * (x - X_FB.p);
  const std::vector<std::uint32_t> near = scans_mesh(body)
                                              ? near_by_scan(body.soup, x_B, reach, most)
                                              : near_by_tree(body, x_B, reach, most);
  work += static_cast<std::int64_t>(scans_mesh(body) ? body.soup.triangles.size() : near.size());
  LocalSurface out{extract(body.soup, near, X_FB), {}};
  connect(out);
  return out;
}

void TriangleSet::add(const Corners& t) {
  at_.push_back(t);
  center_.push_back((t[0] + t[1] + t[2]) / 3);
  double squared = 0;
  for (const Vec3& v : t) squared = std::max(squared, (v - center_.back()).squaredNorm());
  radius_.push_back(std::sqrt(squared) * (1 + 1e-12));
  // Each side is at most twice the radius long, and its product with another rounds by some
  // epsilons of their lengths. Of a needle that turns the normal far.
  const double area = area_normal(t).norm(), side = 2 * radius_.back();
  normal_.push_back(unit_normal(t));
  uneven_.push_back(area > 0 ? 1e-14 * side * side / area * side : infinity);
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
    const double slack = guard + uneven_[i] + 1e-14 * half;
    if (std::min(a, b) > slack || std::max(a, b) < -slack) continue;  // on one side of its plane
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
  std::vector<Vec3> normal{unit_normal(surface.at(seed))};
  in[seed] = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t here = all[i];
    // The order of the corners of either triangle does not matter: the normals point to the same
    // side.
    const bool kept = unit_normal(surface.at(here)).dot(normal[i]) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = surface.neighbour[here][k];
      if (next == LocalSurface::none || in[next]) continue;
      const std::size_t back = side_towards(surface, next, here);
      const bool same_way = surface.soup.triangles[next][back] != surface.soup.triangles[here][k];
      Vec3 n = unit_normal(surface.at(next));
      if (same_way != kept) n = -n;
      if (!(n.dot(normal[0]) > least_cosine)) continue;
      in[next] = 1;
      all.push_back(next);
      normal.push_back(n);
    }
  }
  SurfacePatch out;
  for (const std::uint32_t i : all) {
    const Corners t = surface.at(i);
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
