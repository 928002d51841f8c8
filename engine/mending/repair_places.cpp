// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/repair_places.hpp"

#include <algorithm>
#include <tuple>

#include "engine/base/ordering.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

/// Share of the area: if the sum of normals is shorter than this, no side is the outer one.
constexpr double faces_all_ways = 0.1;

/// The quantities that a place accumulates.
struct Spread {
  Eigen::AlignedBox3d box;
  Vec3 normals = Vec3::Zero();  // weighted by twice their area
  double area = 0;              // twice the area

  void add(const std::vector<Vec3>& x, const Triangle& t) {
    const Vec3 normal = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
    normals += normal;
    area += normal.norm();
  }
  RepairPlace place(RepairKind kind) const {
    const bool one_side = normals.norm() > faces_all_ways * area;
    return {kind, box.center(), box.sizes().norm() / 2,
            one_side ? Vec3(normals.normalized()) : Vec3(Vec3::Zero())};
  }
};

/// Triangles that share a corner which counts form one place, whose extent is given by these
/// corners.
template <class Counts>
void add_grouped(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& x,
                 const std::vector<Triangle>& triangles, Counts counts) {
  // The corners that count, ascending: there may be few in a large mesh.
  std::vector<std::uint32_t> corners;
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      if (counts(v)) corners.push_back(v);
  ordering::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(corners, v) - corners.begin());
  };
  TurnedSets sets(corners.size());
  std::vector<std::uint32_t> first(triangles.size(), 0);
  std::vector<bool> any(triangles.size(), false);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t v : triangles[i]) {
      if (!counts(v)) continue;
      const std::uint32_t n = number(v);
      if (any[i]) sets.join(first[i], n);
      if (!any[i]) first[i] = n;
      any[i] = true;
    }
  std::vector<Spread> of_set(corners.size());
  for (std::uint32_t n = 0; n < corners.size(); ++n)
    of_set[sets.set_of(n)].box.extend(x[corners[n]]);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (any[i]) of_set[sets.set_of(first[i])].add(x, triangles[i]);
  for (const Spread& spread : of_set)
    if (!spread.box.isEmpty()) to.places.push_back(spread.place(kind));
}

}  // namespace

void add_place(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
               const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return;
  Spread spread;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) spread.box.extend(vertices[v]);
    spread.add(vertices, t);
  }
  to.places.push_back(spread.place(kind));
}

void add_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                const std::vector<Triangle>& triangles) {
  add_grouped(to, kind, vertices, triangles, [](std::uint32_t) { return true; });
}

void add_corner_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                       const std::vector<Triangle>& triangles, const std::vector<bool>& marked) {
  add_grouped(to, kind, vertices, triangles, [&](std::uint32_t v) { return bool(marked[v]); });
}

void sort_and_cap(RepairPlaces& places) {
  const auto key = [](const RepairPlace& p) {
    return std::tuple(p.kind, -p.size, p.at.x(), p.at.y(), p.at.z());
  };
  std::vector<RepairPlace>& all = places.places;
  ordering::sort(all.begin(), all.end(),
                 [&](const RepairPlace& a, const RepairPlace& b) { return key(a) < key(b); });
  places.all = all.size();
  if (all.size() > RepairPlaces::most) all.resize(RepairPlaces::most);
  all.shrink_to_fit();
}

}  // namespace sonde
