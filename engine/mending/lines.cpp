// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

constexpr int bits = 20;  // of a pixel: resolution to which corners are rounded
constexpr std::int64_t one = std::int64_t{1} << bits;
/// Position of a line in its pixel: off the middle, where modelled corners and edges tend to be.
constexpr std::int64_t offset = one / 2 + one / 7 + 1237;

using Corner = std::array<std::int64_t, 2>;
/// Corners may lie far outside the raster: products of two coordinates need twice their bits.
__extension__ using Wide = __int128;
constexpr double farthest = 0x1p60;

Wide turn(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  return Wide{b[0] - a[0]} * (y - a[1]) - Wide{b[1] - a[1]} * (x - a[0]);
}

/// Left of the edge, or on it if this triangle, and not its neighbour, owns the edge.
bool within(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  const Wide side = turn(a, b, x, y);
  const bool owns = b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
  return owns ? side >= 0 : side > 0;
}

/// First and last pixel whose line may lie between two coordinates.
std::pair<std::int64_t, std::int64_t> pixels(std::int64_t low, std::int64_t high, int count) {
  const auto floor_pixel = [](std::int64_t v) { return (v - offset) >> bits; };
  return {std::max<std::int64_t>(0, floor_pixel(low + one - 1)),
          std::min<std::int64_t>(count - 1, floor_pixel(high))};
}

}  // namespace

Eigen::Matrix3d line_frame(int k) {
  const Eigen::Matrix3d turned =
      (rotation_about(Vec3::UnitX(), 0.3) * rotation_about(Vec3::UnitY(), 0.5) *
       rotation_about(Vec3::UnitZ(), 0.7))
          .toRotationMatrix();
  Eigen::Matrix3d rows;
  for (int i = 0; i < 3; ++i) rows.row(i) = turned.row((i + k) % 3);
  return rows;
}

Lines::Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count,
             const Eigen::Vector2d& low, double size)
    : across_to_(across_to), count_(count), low_(low), pixel_(size / count) {
  cast(soup);
}

Lines::Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count)
    : across_to_(across_to), count_(count) {
  Eigen::AlignedBox2d box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t)
      box.extend(Eigen::Vector2d((across_to * soup.vertices[v]).head<2>()));
  low_ = box.min();
  pixel_ = box.sizes().maxCoeff() / count;
  cast(soup);
}

void Lines::cast(const Soup& soup) {
  std::vector<Corner> across(soup.vertices.size());
  std::vector<double> along(soup.vertices.size());
  for (std::size_t i = 0; i < across.size(); ++i) {
    const Vec3 x = across_to_ * soup.vertices[i];
    for (Eigen::Index k = 0; k < 2; ++k)
      across[i][static_cast<std::size_t>(k)] = std::llround(
          std::clamp((x[k] - low_[k]) / pixel_ * static_cast<double>(one), -farthest, farthest));
    along[i] = x[2];
  }
  start_.assign(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_) + 1, 0);

  const auto each_hit = [&](const auto& found) {
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      const Triangle& t = soup.triangles[i];
      Corner a = across[t[0]], b = across[t[1]], c = across[t[2]];
      const auto [x0, x1] =
          pixels(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), count_);
      const auto [y0, y1] =
          pixels(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), count_);
      if (x0 > x1 || y0 > y1) continue;
      const Wide twice_area = turn(a, b, c[0], c[1]);
      if (twice_area == 0) continue;
      const int sign = twice_area > 0 ? 1 : -1;
      if (sign < 0) std::swap(b, c);
      for (std::int64_t j = y0; j <= y1; ++j)
        for (std::int64_t k = x0; k <= x1; ++k) {
          const std::int64_t x = (k << bits) + offset, y = (j << bits) + offset;
          if (within(a, b, x, y) && within(b, c, x, y) && within(c, a, x, y))
            found(static_cast<std::size_t>(j * count_ + k), i, sign, x, y);
        }
    }
  };
  each_hit(
      [&](std::size_t line, std::size_t, int, std::int64_t, std::int64_t) { ++start_[line + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  hits_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  each_hit([&](std::size_t line, std::size_t i, int sign, std::int64_t x, std::int64_t y) {
    const Triangle& t = soup.triangles[i];
    const Corner &a = across[t[0]], &b = across[t[1]], &c = across[t[2]];
    const double all = static_cast<double>(turn(a, b, c[0], c[1]));
    const double by_b = static_cast<double>(turn(c, a, x, y)) / all;
    const double by_c = static_cast<double>(turn(a, b, x, y)) / all;
    const double at =
        along[t[0]] + by_b * (along[t[1]] - along[t[0]]) + by_c * (along[t[2]] - along[t[0]]);
    hits_[next[line]++] = {at, static_cast<std::uint32_t>(i), sign};
  });
  for (std::size_t line = 0; line < size(); ++line)
    ordering::sort(hits_.begin() + static_cast<std::ptrdiff_t>(start_[line]),
                   hits_.begin() + static_cast<std::ptrdiff_t>(start_[line + 1]),
                   [](const LineHit& p, const LineHit& q) {
                     return p.along != q.along ? p.along < q.along : p.triangle < q.triangle;
                   });
}

Vec3 Lines::point(std::size_t i, double along) const {
  const auto n = static_cast<std::size_t>(count_);
  const double in_pixel = static_cast<double>(offset) / static_cast<double>(one);
  const std::size_t row = i / n, column = i % n;
  const Vec3 y(low_[0] + (static_cast<double>(column) + in_pixel) * pixel_,
               low_[1] + (static_cast<double>(row) + in_pixel) * pixel_, along);
  return across_to_.transpose() * y;
}

}  // namespace sonde
