// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"

namespace sonde {
namespace {

/// The vertices of a soup, grouped by the cells of a grid.
class Cells {
 public:
  Cells(const Soup& soup, double width, const Progress& progress)
      : soup_(soup), per_width_(1 / width), of_(soup.vertices.size()) {
    Eigen::AlignedBox3d box;
    for (const Vec3& x : soup.vertices) box.extend(x);
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for_each_index(of_.size(), progress, [&](std::size_t i) {
      const auto next = static_cast<std::uint32_t>(numbers.size());
      of_[i] = numbers.try_emplace(key(soup.vertices[i] - box.min()), next).first->second;
    });
    choose_points(numbers.size());
  }
  std::uint32_t of(std::uint32_t vertex) const { return of_[vertex]; }
  std::vector<Vec3> points() { return std::move(points_); }

 private:
  /// 21 bits for each coordinate; if there are more cells along an axis, the last cell holds the
  /// rest.
  std::uint64_t key(const Vec3& x) const {
    constexpr double most = (1 << 21) - 1;
    std::uint64_t out = 0;
    for (int i = 0; i < 3; ++i)
      out = out << 21 | static_cast<std::uint64_t>(std::min(most, x[i] * per_width_));
    return out;
  }
  void choose_points(std::size_t count) {
    std::vector<Vec3> mean(count, Vec3::Zero());
    std::vector<double> members(count, 0), nearest(count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < of_.size(); ++i)
      mean[of_[i]] += soup_.vertices[i], members[of_[i]] += 1;
    points_.resize(count);
    for (std::size_t i = 0; i < of_.size(); ++i) {
      const std::uint32_t cell = of_[i];
      const double off = (soup_.vertices[i] - mean[cell] / members[cell]).squaredNorm();
      if (off < nearest[cell]) nearest[cell] = off, points_[cell] = soup_.vertices[i];
    }
  }

  const Soup& soup_;
  double per_width_;
  std::vector<std::uint32_t> of_;  // the cell of each vertex
  std::vector<Vec3> points_;
};

Soup clustered(const Soup& soup, double width, const Progress& progress) {
  Cells cells(soup, width, part_of(progress, 0, 0.5));
  Soup out;
  std::set<Triangle> seen;
  for_each_index(soup.triangles.size(), part_of(progress, 0.5, 1), [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    const Triangle c{cells.of(t[0]), cells.of(t[1]), cells.of(t[2])};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
    Triangle sorted = c;
    ordering::sort(sorted);
    if (seen.insert(sorted).second) out.triangles.push_back(c);
  });
  out.vertices = cells.points();
  std::erase_if(out.triangles, [&](const Triangle& t) {
    return is_degenerate(out.vertices[t[0]], out.vertices[t[1]], out.vertices[t[2]]);
  });
  return out;
}

double area(const Soup& soup) {
  double twice = 0;
  for (const Triangle& t : soup.triangles) {
    const Vec3& a = soup.vertices[t[0]];
    twice += (soup.vertices[t[1]] - a).cross(soup.vertices[t[2]] - a).norm();
  }
  return twice / 2;
}

}  // namespace

Soup outline(const Soup& soup, std::size_t triangles, const Progress& progress) {
  // A smooth surface gives two triangles for each cell that it crosses; a crumpled one gives more.
  double width = std::sqrt(2 * area(soup) / static_cast<double>(triangles));
  constexpr int attempts = 6;
  for (int attempt = 0; attempt < attempts && width > 0; ++attempt) {
    Soup out =
        clustered(soup, width,
                  part_of(progress, attempt / double{attempts}, (attempt + 1) / double{attempts}));
    const std::size_t count = out.triangles.size();
    if (count <= 2 * triangles && count >= triangles / 4) return out;
    width *= count > triangles ? 1.6 : 0.6;
  }
  return {};
}

}  // namespace sonde
