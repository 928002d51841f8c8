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

/// Where the line through a point passes through a triangle.
struct PointHit {
  double height;  ///< m, above the point
  int sign;       ///< what it adds to the winding number of all below it
};

/// A sealed soup and points, seen along the lines through the points.
class PointLines {
 public:
  PointLines(const Sealed& sealed, const std::vector<PartPoint>& points)
      : sealed_(sealed), seen_(sealed.soup.vertices.size()), at_(points.size()) {
    const Eigen::Matrix3d frame = line_frame(0);
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      seen_[i] = frame * sealed.soup.vertices[i];
      box.extend(seen_[i]);
    }
    on_ = on_it * box.sizes().norm();
    for (std::size_t i = 0; i < points.size(); ++i) at_[i] = frame * points[i].x;
  }

  double on() const { return on_; }  ///< m: a hit at this height is at the point
  static Vec3 way() { return line_frame(0).row(2).transpose(); }

  /// Calls use(point, part, hit) for every hit.
  template <class Use>
  void each(const Progress& progress, Use use) const {
    std::vector<Eigen::Vector2d> flat(at_.size());
    for (std::size_t i = 0; i < at_.size(); ++i) flat[i] = at_[i].head<2>();
    const Raster raster(flat);
    for_each_index(sealed_.soup.triangles.size(), progress, [&](std::size_t i) {
      const Triangle& t = sealed_.soup.triangles[i];
      const Vec3 &a = seen_[t[0]], &b = seen_[t[1]], &c = seen_[t[2]];
      const Eigen::Vector2d a2 = a.head<2>(), b2 = b.head<2>(), c2 = c.head<2>();
      const double all = cross(b2 - a2, c2 - a2);
      if (all == 0) return;
      raster.each_in(a2.cwiseMin(b2).cwiseMin(c2), a2.cwiseMax(b2).cwiseMax(c2),
                     [&](std::uint32_t k) {
                       const Eigen::Vector2d& p = flat[k];
                       const double u = cross(b2 - p, c2 - p) / all,
                                    v = cross(c2 - p, a2 - p) / all, w = 1 - u - v;
                       if (u < 0 || v < 0 || w < 0) return;
                       const double height = u * a.z() + v * b.z() + w * c.z() - at_[k].z();
                       use(k, sealed_.part[i], PointHit{height, all > 0 ? 1 : -1});
                     });
    });
  }

 private:
  const Sealed& sealed_;
  std::vector<Vec3> seen_, at_;
  double on_ = 0;
};

/// The heights, from that of the surface at 0 on, of the next face above (`up` 1) or below (-1);
/// 0 where the line leaves the part there.
double next_face(const std::vector<PointHit>& hits, int up, double on) {
  int winding = 0;
  double next = 0;
  for (const PointHit& hit : hits) {
    const double height = up * hit.height;
    if (height <= on) continue;
    winding += hit.sign;
    if (next == 0 || height < next) next = height;
  }
  return winding == 0 ? 0 : up * next;
}

}  // namespace

std::vector<PartWindings> part_windings(const Sealed& sealed, const std::vector<PartPoint>& points,
                                        const Progress& progress) {
  const PointLines lines(sealed, points);
  struct Count {
    int winding = 0;
    bool on = false;
  };
  std::vector<std::map<std::uint32_t, Count>> counts(points.size());
  lines.each(progress, [&](std::uint32_t k, std::uint32_t part, const PointHit& hit) {
    Count& count = counts[k][part];
    count.on |= std::abs(hit.height) <= lines.on();
    if (hit.height > 0) count.winding += hit.sign;
  });
  std::vector<PartWindings> out(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const auto& [part, count] : counts[k])
      if (count.winding != 0 && !count.on) out[k].emplace_back(part, count.winding);
  return out;
}

std::vector<PartPoint> points_within(const Sealed& sealed, const std::vector<PartPoint>& points,
                                     double near, const Progress& progress) {
  const PointLines lines(sealed, points);
  std::vector<std::vector<PointHit>> own(points.size());
  lines.each(progress, [&](std::uint32_t k, std::uint32_t part, const PointHit& hit) {
    if (part == points[k].part) own[k].push_back(hit);
  });
  std::vector<PartPoint> out;
  for (std::size_t k = 0; k < points.size(); ++k) {
    int total = 0;
    for (const PointHit& hit : own[k]) total += hit.sign;
    if (total != 0) continue;  // a line along a side, to rounding
    for (const int up : {1, -1})
      if (const double next = next_face(own[k], up, lines.on()); next != 0)
        out.push_back({points[k].x + near * next * PointLines::way(), points[k].part});
  }
  return out;
}

}  // namespace sonde
