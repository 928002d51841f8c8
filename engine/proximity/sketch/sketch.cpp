// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sketch/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

constexpr std::size_t few_points = 160, more_points = 320;

/// m: within this range, squares of lengths are in the range of single precision.
constexpr double smallest_radius = 1e-12, largest_radius = 1e12;

struct Candidate {
  Vec3 x;
  double weight;  // factor on its distance from the points already taken
  double away = std::numeric_limits<double>::infinity();
};

/// Corners, and points on the edges and the faces of large triangles.
std::vector<Candidate> candidates(const Body& body, double spacing) {
  std::vector<Candidate> out;
  for (const Vec3& x : surface(body).vertices) out.push_back({x, 1.5});
  const auto pieces = [&](const Vec3& a, const Vec3& b) {
    return std::clamp(static_cast<int>((b - a).norm() / spacing), 1, 64);
  };
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i) {
    const Corners t = corners(surface(body), i);
    const int n = std::max({pieces(t[0], t[1]), pieces(t[1], t[2]), pieces(t[2], t[0])});
    for (int j = 0; j <= n; ++j)
      for (int k = 0; j + k <= n; ++k) {
        if (j == n || k == n || j + k == 0) continue;
        const bool edge = j == 0 || k == 0 || j + k == n;
        out.push_back({t[0] + (j * (t[1] - t[0]) + k * (t[2] - t[0])) / n, edge ? 1.2 : 1.0});
      }
  }
  return out;
}

constexpr std::size_t most_in_a_group = 6;

PointGroup group_of(std::span<const Vec3> points) {
  PointGroup out{};
  Eigen::AlignedBox3d box;
  for (const Vec3& x : points) box.extend(x);
  out.center = quad(box.center());
  for (const Vec3& x : points) {
    const double away = (x - box.center()).norm();
    out.points.push_back(quad(x, static_cast<float>(away)));
    out.radius = std::max(out.radius, away);
  }
  return out;
}

/// Splits at the median along the longest side until the groups are small.
void add_groups(std::span<Vec3> points, std::vector<PointGroup>& out) {
  if (points.size() <= most_in_a_group) return out.push_back(group_of(points));
  Eigen::AlignedBox3d box;
  for (const Vec3& x : points) box.extend(x);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto half = points.size() / 2;
  ordering::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half),
                        points.end(),
                        [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  add_groups(points.first(half), out);
  add_groups(points.subspan(half), out);
}

}  // namespace

std::vector<Vec3> spread_points(const Body& body, std::size_t count) {
  const double spacing = 0.1 * body.mass.radius;
  std::vector<Candidate> all = candidates(roughly(body), spacing);
  std::vector<Vec3> out;
  // Farthest-point sampling: each point is the furthest from those before, the first from the
  // centre of mass.
  Vec3 last = body.mass.com;
  while (out.size() < std::min(count, all.size())) {
    auto furthest = all.begin();
    for (auto c = all.begin(); c != all.end(); ++c) {
      c->away = std::min(c->away, c->weight * (c->x - last).norm());
      if (c->away > furthest->away) furthest = c;
    }
    last = furthest->x;
    out.push_back(nearest_point(body, last, 0).point);  // an outline lies slightly off the surface
    if (out.size() == 1)
      for (Candidate& c : all) c.away = std::numeric_limits<double>::infinity();
  }
  return out;
}

std::shared_ptr<const Sketch> make_sketch(const Body& body) {
  auto out =
      std::make_shared<Sketch>(Sketch{{}, {}, body.solid ? DistanceField(body) : DistanceField()});
  std::vector<Vec3> points = spread_points(body, more_points);
  for (Vec3& x : points) x = body.mass.R_MP.transpose() * (x - body.mass.com);
  std::vector<Vec3> few(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(
                                                             std::min(few_points, points.size())));
  add_groups(few, out->few);
  add_groups(points, out->more);
  return out;
}

Sketches make_sketches(const Body& probe, const Body& fixed, const Progress& progress) {
  Sketches out;
  const auto in_range = [](const Body& body) {
    return body.mass.radius > smallest_radius && body.mass.radius < largest_radius;
  };
  if (!(probe.solid || fixed.solid) || !in_range(probe) || !in_range(fixed)) return out;
  run_both(
      true, progress,
      [&](const Progress& part) {
        report(part, 0);
        out.probe = make_sketch(probe);
        report(part, 1);
      },
      [&](const Progress&) { out.fixed = make_sketch(fixed); });
  return out;
}

}  // namespace sonde
