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
/// Up to here from the origin, all of a raster and what is by it, 64 bits hold twice an area.
constexpr std::int64_t near_enough = std::int64_t{1} << 30;

template <class Area>
Area turn(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  return Area{b[0] - a[0]} * (y - a[1]) - Area{b[1] - a[1]} * (x - a[0]);
}

/// On which side of an edge the lines of a row of pixels are, one after another.
template <class Area>
class Side {
 public:
  Side(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y)
      : begin_(turn<Area>(a, b, x, y)),
        right_(-(Area{b[1] - a[1]} << bits)),
        up_(Area{b[0] - a[0]} << bits) {
    // A line on the edge is within where the edge is this triangle's and not its neighbour's.
    if (b[1] < a[1] || (b[1] == a[1] && b[0] > a[0])) begin_ += 1;
    now_ = begin_;
  }
  bool left() const { return now_ > 0; }
  void next_pixel() { now_ += right_; }
  void next_row() { now_ = begin_ += up_; }

 private:
  Area begin_, right_, up_, now_;
};

/// First and last pixel whose line may lie between two coordinates.
std::pair<std::int64_t, std::int64_t> pixels(std::int64_t low, std::int64_t high, int count) {
  const auto floor_pixel = [](std::int64_t v) { return (v - offset) >> bits; };
  return {std::max<std::int64_t>(0, floor_pixel(low + one - 1)),
          std::min<std::int64_t>(count - 1, floor_pixel(high))};
}

/// A hit, and the line it is of.
struct Found {
  std::uint32_t line;
  LineHit hit;
};

/// In the order of the triangles. Area: of the numbers that hold products of coordinates.
template <class Area>
std::vector<Found> hits_of(const Soup& soup, const std::vector<Corner>& across,
                           const std::vector<double>& along, int count) {
  std::vector<Found> found;
  found.reserve(2 * static_cast<std::size_t>(count) * static_cast<std::size_t>(count));
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Corner &a = across[t[0]], &b = across[t[1]], &c = across[t[2]];
    const auto [x0, x1] = pixels(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), count);
    const auto [y0, y1] = pixels(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), count);
    if (x0 > x1 || y0 > y1) continue;
    const Area twice_area = turn<Area>(a, b, c[0], c[1]);
    if (twice_area == 0) continue;
    const int sign = twice_area > 0 ? 1 : -1;
    const double all = static_cast<double>(twice_area);
    const Corner &second = sign > 0 ? b : c, &third = sign > 0 ? c : b;
    const std::int64_t left = (x0 << bits) + offset, low = (y0 << bits) + offset;
    Side<Area> sides[3] = {
        {a, second, left, low}, {second, third, left, low}, {third, a, left, low}};
    for (std::int64_t j = y0; j <= y1; ++j) {
      for (std::int64_t k = x0; k <= x1; ++k) {
        if (sides[0].left() && sides[1].left() && sides[2].left()) {
          const std::int64_t x = (k << bits) + offset, y = (j << bits) + offset;
          const double by_b = static_cast<double>(turn<Area>(c, a, x, y)) / all;
          const double by_c = static_cast<double>(turn<Area>(a, b, x, y)) / all;
          const double at =
              along[t[0]] + by_b * (along[t[1]] - along[t[0]]) + by_c * (along[t[2]] - along[t[0]]);
          found.push_back({static_cast<std::uint32_t>(j * count + k), {at, i, sign}});
        }
        for (Side<Area>& side : sides) side.next_pixel();
      }
      for (Side<Area>& side : sides) side.next_row();
    }
  }
  return found;
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
  bool near = true;
  for (std::size_t i = 0; i < across.size(); ++i) {
    const Vec3 x = across_to_ * soup.vertices[i];
    for (Eigen::Index k = 0; k < 2; ++k) {
      std::int64_t& corner = across[i][static_cast<std::size_t>(k)];
      corner = std::llround(
          std::clamp((x[k] - low_[k]) / pixel_ * static_cast<double>(one), -farthest, farthest));
      near = near && std::abs(corner) < near_enough;
    }
    along[i] = x[2];
  }
  const std::vector<Found> found = near ? hits_of<std::int64_t>(soup, across, along, count_)
                                        : hits_of<Wide>(soup, across, along, count_);
  start_.assign(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_) + 1, 0);
  for (const Found& hit : found) ++start_[hit.line + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  hits_.resize(found.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (const Found& hit : found) hits_[next[hit.line]++] = hit.hit;
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
