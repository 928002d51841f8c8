// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sonde::test {
namespace {

/// Left of a to b. One answer for an edge, whichever of its triangles asks.
bool is_left(const Vec3& a, const Vec3& b, double x, double y) {
  const bool swapped = std::pair(a.x(), a.y()) > std::pair(b.x(), b.y());
  const Vec3 &p = swapped ? b : a, &q = swapped ? a : b;
  const bool left = (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x()) > 0;
  return left != swapped;
}

}  // namespace

std::vector<std::array<Vec3, 3>> boundary(const Body& solid) {
  std::vector<std::array<Vec3, 3>> out;
  for (std::uint32_t i = 0; i < surface(solid).triangles.size(); ++i) {
    if (is_loose(solid, i)) continue;
    const Triangle& t = surface(solid).triangles[i];
    out.push_back({surface(solid).vertices[t[0]], surface(solid).vertices[t[1]],
                   surface(solid).vertices[t[2]]});
  }
  return out;
}

Moments moments_by_columns(const Body& solid, int count) {
  // Turned: modelled sides lie along the axes, and columns beside them all err the same way.
  const Mat3 turn = Quat(0.8, 0.2, 0.4, 0.3).normalized().toRotationMatrix();
  auto triangles = boundary(solid);
  Eigen::AlignedBox3d box;
  for (auto& t : triangles)
    for (Vec3& x : t) box.extend(x = turn * x);
  const double dx = box.sizes().x() / count, dy = box.sizes().y() / count;
  // Off the middles, where modelled corners tend to be.
  const auto column_x = [&](int i) { return box.min().x() + (i + 0.5137) * dx; };
  const auto column_y = [&](int j) { return box.min().y() + (j + 0.4871) * dy; };
  const auto first = [](double v) { return std::max(0, static_cast<int>(std::floor(v)) - 1); };
  std::map<std::pair<int, int>, std::vector<std::pair<double, int>>> hits;
  for (const auto& t : triangles) {
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    if (n.z() == 0) continue;
    for (int i = first((low.x() - box.min().x()) / dx); i < count && column_x(i) <= high.x(); ++i)
      for (int j = first((low.y() - box.min().y()) / dy); j < count && column_y(j) <= high.y();
           ++j) {
        const double x = column_x(i), y = column_y(j);
        const bool a = is_left(t[0], t[1], x, y);
        if (is_left(t[1], t[2], x, y) != a || is_left(t[2], t[0], x, y) != a) continue;
        const double z = t[0].z() - (n.x() * (x - t[0].x()) + n.y() * (y - t[0].y())) / n.z();
        hits[{i, j}].emplace_back(z, a ? 1 : -1);
      }
  }
  Moments out;
  Vec3 moment = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const Vec3 base = box.center();
  for (auto& [column, at] : hits) {
    std::sort(at.begin(), at.end());
    int w = 0;
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      w -= at[k].second;
      if (w == 0) continue;
      const double length = at[k + 1].first - at[k].first, piece = length * dx * dy;
      const Vec3 middle =
          Vec3(column_x(column.first), column_y(column.second), at[k].first + length / 2) - base;
      out.measure += piece;
      moment += piece * middle;
      second += piece * middle * middle.transpose();
      second(2, 2) += piece * length * length / 12;
    }
  }
  const Vec3 mean = moment / out.measure;
  out.com = turn.transpose() * (base + mean);
  out.covariance = turn.transpose() * (second / out.measure - mean * mean.transpose()) * turn;
  return out;
}

}  // namespace sonde::test
