// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/point_windings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/progress.hpp"
#include "engine/mending/lines.hpp"

namespace sonde {
namespace {

/// Share of the total size: a point nearer to a triangle counts as on it.
constexpr double on_it = 1e-10;
constexpr double points_a_cell = 2;

/// Points in the cells of a raster across the lines.
class Raster {
 public:
  Raster(std::vector<Eigen::Vector2d> points) : points_(std::move(points)) {
    for (const Eigen::Vector2d& p : points_) box_.extend(p);
    const double want = static_cast<double>(points_.size()) / points_a_cell;
    side_ = std::max(1, static_cast<int>(std::sqrt(want)));
    size_ = std::max(box_.sizes().maxCoeff(), 1e-300) * (1 + 1e-9);
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      cells_[index(cell(points_[i].x(), 0), cell(points_[i].y(), 1))].push_back(i);
  }

  template <class Use>
  void each_in(const Eigen::Vector2d& low, const Eigen::Vector2d& high, Use use) const {
    if ((high.array() < box_.min().array()).any() || (low.array() > box_.max().array()).any())
      return;
    const int x0 = cell(low.x(), 0), x1 = cell(high.x(), 0), y0 = cell(low.y(), 1),
              y1 = cell(high.y(), 1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        for (const std::uint32_t i : cells_[index(x, y)]) use(i);
  }

 private:
  int cell(double v, Eigen::Index axis) const {
    const double at = (v - box_.min()[axis]) / size_ * side_;
    return static_cast<int>(std::clamp(at, 0.0, side_ - 1.0));
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * side_ + x); }

  std::vector<Eigen::Vector2d> points_;
  Eigen::AlignedBox2d box_;
  int side_ = 1;
  double size_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<PartWindings> part_windings(const Sealed& sealed, const std::vector<PartPoint>& points,
                                        const Progress& progress) {
  const Eigen::Matrix3d frame = line_frame(0);
  std::vector<Vec3> seen(sealed.soup.vertices.size());
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i] = frame * sealed.soup.vertices[i];
    box.extend(seen[i]);
  }
  const double near = on_it * box.sizes().norm();
  std::vector<Vec3> at(points.size());
  std::vector<Eigen::Vector2d> flat(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    at[i] = frame * points[i].x;
    flat[i] = at[i].head<2>();
  }
  const Raster raster(flat);
  struct Count {
    int winding = 0;
    bool on = false;
  };
  std::vector<std::map<std::uint32_t, Count>> counts(points.size());
  for_each_index(sealed.soup.triangles.size(), progress, [&](std::size_t i) {
    const Triangle& t = sealed.soup.triangles[i];
    const Vec3 &a = seen[t[0]], &b = seen[t[1]], &c = seen[t[2]];
    const Eigen::Vector2d a2 = a.head<2>(), b2 = b.head<2>(), c2 = c.head<2>();
    const double all = cross(b2 - a2, c2 - a2);
    if (all == 0) return;
    raster.each_in(a2.cwiseMin(b2).cwiseMin(c2), a2.cwiseMax(b2).cwiseMax(c2),
                   [&](std::uint32_t k) {
                     const Eigen::Vector2d& p = flat[k];
                     const double u = cross(b2 - p, c2 - p) / all, v = cross(c2 - p, a2 - p) / all,
                                  w = 1 - u - v;
                     if (u < 0 || v < 0 || w < 0) return;
                     const double height = u * a.z() + v * b.z() + w * c.z() - at[k].z();
                     Count& count = counts[k][sealed.part[i]];
                     count.on |= std::abs(height) <= near;
                     if (height > 0) count.winding += all > 0 ? 1 : -1;
                   });
  });
  std::vector<PartWindings> out(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const auto& [part, count] : counts[k])
      if (count.winding != 0 && !count.on) out[k].emplace_back(part, count.winding);
  return out;
}

}  // namespace sonde
