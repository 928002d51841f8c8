// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/flat_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/body/region.hpp"

namespace sonde {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

/// For each side of each triangle, the triangle on its other side; none where there is not just
/// one.
std::vector<std::array<std::uint32_t, 3>> neighbours_of(const Fans& fans) {
  struct Side {
    std::uint32_t low, high, triangle, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * fans.of.size());
  for (std::uint32_t t = 0; t < fans.of.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = fans.of[t][k], b = fans.of[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  ordering::sort(sides, {}, [](const Side& s) {
    return std::array{s.low, s.high, s.triangle, s.corner};
  });
  std::vector<std::array<std::uint32_t, 3>> neighbours(fans.of.size(), {none, none, none});
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high)
      ++end;
    if (end - begin != 2) continue;
    const Side &a = sides[begin], &b = sides[begin + 1];
    neighbours[a.triangle][a.corner] = b.triangle;
    neighbours[b.triangle][b.corner] = a.triangle;
  }
  return neighbours;
}

double area(const std::vector<std::array<double, 2>>& x, std::uint32_t a, std::uint32_t b) {
  return (x[a][0] * x[b][1] - x[a][1] * x[b][0]) / 2;
}

}  // namespace

FlatRegions::FlatRegions(const Fans& fans, const std::vector<Vec3>& normals,
                         const std::vector<char>& has_say, const std::vector<double>& tilts)
    : neighbours_(neighbours_of(fans)), of_(fans.of.size(), none) {
  std::uint32_t count = 0;
  const auto flood = [&](std::uint32_t seed) {
    first_.push_back(std::uint32_t(triangles_.size()));
    of_[seed] = count;
    triangles_.push_back(seed);
    for (std::size_t i = first_.back(); i < triangles_.size(); ++i) {
      const std::uint32_t t = triangles_[i];
      if (!has_say[t]) continue;
      for (const std::uint32_t next : neighbours_[t]) {
        if (next == none || of_[next] != none) continue;
        if (has_say[next] &&
            (normals[next] - normals[seed]).squaredNorm() > tilts[next] * tilts[next])
          continue;
        of_[next] = count;
        triangles_.push_back(next);
      }
    }
    ++count;
  };
  std::vector<std::uint32_t> seeds(of_.size());
  std::iota(seeds.begin(), seeds.end(), 0U);
  // Those first that tell their planes best.
  std::ranges::stable_sort(seeds, {}, [&](std::uint32_t t) {
    return has_say[t] ? tilts[t] : std::numeric_limits<double>::infinity();
  });
  for (const std::uint32_t t : seeds)
    if (of_[t] == none) flood(t);
  first_.push_back(std::uint32_t(triangles_.size()));
}

std::optional<std::uint32_t> FlatRegions::across(std::uint32_t triangle, std::size_t side) const {
  const std::uint32_t other = neighbours_[triangle][side];
  return other == none ? std::nullopt : std::optional(other);
}

std::vector<FanSide> outline_of(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<FanSide, int> uses;  // of a side low-high: upwards less downwards
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a != b) uses[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  std::vector<FanSide> outline;
  for (const auto& [side, n] : uses)
    for (int i = 0; i < std::abs(n); ++i)
      outline.push_back(n > 0 ? side : FanSide{side[1], side[0]});
  return outline;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> filled(const std::vector<FanSide>& outline,
                                                                const std::vector<Vec3>& places,
                                                                const Vec3& normal) {
  constexpr double rounding = 1e-9;
  if (outline.empty()) return std::vector<std::array<std::uint32_t, 3>>{};
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x), origin = places[outline[0][0]];
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> fan;
  PlanarRegion region;
  const auto index = [&](std::uint32_t corner) {
    const auto [at, is_new] = number.emplace(corner, std::uint32_t(fan.size()));
    if (is_new) {
      const Vec3 from = places[corner] - origin;
      fan.push_back(corner);
      region.points.push_back({from.dot(x), from.dot(y)});
    }
    return at->second;
  };
  double within = 0;
  for (const auto& [a, b] : outline) {
    const std::uint32_t from = index(a), to = index(b);
    region.outline.emplace_back(from, to);
    within += area(region.points, from, to);
  }
  if (!(within > 0)) return std::nullopt;
  auto triangles = triangulate(region);
  if (!triangles) return std::nullopt;
  double covered = 0;
  for (auto& t : *triangles) {
    for (std::size_t k = 0; k < 3; ++k) covered += area(region.points, t[k], t[(k + 1) % 3]);
    for (std::uint32_t& corner : t) corner = fan[corner];
  }
  if (std::abs(covered - within) > rounding * within) return std::nullopt;
  return triangles;
}

}  // namespace sonde
