// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/coverage.hpp"

#include <algorithm>

#include "engine/proximity/queries/placement.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde::test {
namespace {

Vec3 nearest(const Vec3& x, const Corners& t) { return closest_points({x, x, x}, t).b; }

Corners shifted(const Corners& t, const Vec3& by) { return {t[0] + by, t[1] + by, t[2] + by}; }

/// The closest points on A are those of triangle A that lie in triangle B, shifted by the gap along
/// the normal. Looks for the one nearest to x by projecting on either in turn (R. L. Dykstra 1983:
/// it converges to the nearest point of two convex sets in common). Each step ends at a point of A
/// that is tried.
bool some_closest_point_within(const ReachedPair& pair, const Vec3& x, const Density& density) {
  const Corners over_b = shifted(pair.b, pair.row.gap * pair.row.normal);
  const double far_enough = pair.row.gap + density.rounding + 1e-9 * density.spacing;
  Vec3 at = x, from_a = Vec3::Zero(), from_b = Vec3::Zero();
  for (int i = 0; i < 200; ++i) {
    const Vec3 in_b = nearest(at + from_b, over_b);
    from_b += at - in_b;
    const Vec3 on_a = nearest(in_b + from_a, pair.a);
    from_a += in_b - on_a;
    if ((on_a - x).norm() <= density.spacing && (on_a - nearest(on_a, pair.b)).norm() <= far_enough)
      return true;
    if (i > 3 && (on_a - at).norm() <= 1e-6 * density.spacing &&
        (on_a - in_b).norm() <= 1e-6 * density.spacing &&
        (on_a - x).norm() > 1.01 * density.spacing)
      return false;  // arrived, and too far
    at = on_a;
  }
  return false;
}

}  // namespace

std::vector<ReachedPair> pairs_in_reach(const Body& a, const Body& b, const Transform& X_BA,
                                        double reach) {
  const auto of_a = placed_triangles(a, X_BA), of_b = placed_triangles(b, {});
  const double rounding = 1e-14 * (extent(a) + extent(b) + X_BA.p.cwiseAbs().maxCoeff());
  std::vector<ReachedPair> out;
  for (std::uint32_t i = 0; i < of_a.size(); ++i)
    for (std::uint32_t j = 0; j < of_b.size(); ++j) {
      const ClosestPoints c = closest_points(of_a[i], of_b[j]);
      if (c.distance <= rounding || c.distance > reach) continue;
      if (c.gap <= rounding) continue;
      out.push_back({{c.a, c.b, c.normal, c.gap, i, j}, of_a[i], of_b[j]});
    }
  return out;
}

bool stands_for(const NearPair& row, const ReachedPair& pair, const Density& density) {
  if (row.gap > pair.row.gap + density.rounding) return false;
  if (row.normal.dot(pair.row.normal) < density.cos_angle - 1e-9) return false;
  const double within = density.spacing + density.rounding;
  if ((row.on_a - pair.row.on_a).norm() <= within) return true;
  if ((row.on_a - nearest(row.on_a, pair.a)).norm() > within) return false;
  return some_closest_point_within(pair, row.on_a, density);
}

testing::AssertionResult covers(std::span<const NearPair> rows, std::span<const ReachedPair> pairs,
                                double reach, const Density& density) {
  std::size_t bare = 0;
  const ReachedPair* example = nullptr;
  for (const ReachedPair& pair : pairs) {
    if (pair.row.gap >= reach - density.rounding) continue;
    if (std::ranges::any_of(rows, [&](const NearPair& r) { return stands_for(r, pair, density); }))
      continue;
    ++bare;
    if (example == nullptr || pair.row.gap < example->row.gap) example = &pair;
  }
  if (bare == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << bare << " of " << pairs.size() << " pairs have no row among " << rows.size()
         << "; the nearest: triangles " << example->row.triangle_a << " and "
         << example->row.triangle_b << ", gap " << example->row.gap << " m";
}

}  // namespace sonde::test
