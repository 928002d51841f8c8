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

/// Rows are taken together as long as their hits are at most about this many, so that these stay in
/// the processor's cache.
constexpr std::int64_t hits_at_once = 1 << 15;

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
    : soup_(soup), across_to_(across_to), count_(count), low_(low), pixel_(size / count) {
  cast();
}

Lines::Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count)
    : soup_(soup), across_to_(across_to), count_(count) {
  Eigen::AlignedBox2d box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t)
      box.extend(Eigen::Vector2d((across_to * soup.vertices[v]).head<2>()));
  low_ = box.min();
  pixel_ = box.sizes().maxCoeff() / count;
  cast();
}

void Lines::cast() {
  across_.resize(soup_.vertices.size());
  along_.resize(soup_.vertices.size());
  for (std::size_t i = 0; i < across_.size(); ++i) {
    const Vec3 x = across_to_ * soup_.vertices[i];
    for (Eigen::Index k = 0; k < 2; ++k) {
      std::int64_t& corner = across_[i][static_cast<std::size_t>(k)];
      corner = std::llround(
          std::clamp((x[k] - low_[k]) / pixel_ * static_cast<double>(one), -farthest, farthest));
      near_ = near_ && std::abs(corner) < near_enough;
    }
    along_[i] = x[2];
  }
  std::vector<Seen> seen;
  std::vector<std::size_t> start(static_cast<std::size_t>(count_) + 1, 0);  // by first row
  for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i) {
    const Triangle& t = soup_.triangles[i];
    const Corner &a = across_[t[0]], &b = across_[t[1]], &c = across_[t[2]];
    const auto [x0, x1] =
        pixels(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), count_);
    const auto [y0, y1] =
        pixels(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), count_);
    if (x0 > x1 || y0 > y1) continue;
    seen.push_back({i, static_cast<std::int16_t>(x0), static_cast<std::int16_t>(x1),
                    static_cast<std::int16_t>(y0), static_cast<std::int16_t>(y1)});
    ++start[static_cast<std::size_t>(y0) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  seen_.resize(seen.size());
  for (const Seen& s : seen) seen_[start[static_cast<std::size_t>(s.y0)]++] = s;
}

template <class Area>
void Lines::add_hits(const Seen& seen, int from, int to, std::vector<Found>& found) const {
  const Triangle& t = soup_.triangles[seen.triangle];
  const Corner &a = across_[t[0]], &b = across_[t[1]], &c = across_[t[2]];
  const Area twice_area = turn<Area>(a, b, c[0], c[1]);
  if (twice_area == 0) return;
  const int sign = twice_area > 0 ? 1 : -1;
  const double all = static_cast<double>(twice_area);
  const Corner &second = sign > 0 ? b : c, &third = sign > 0 ? c : b;
  const std::int64_t x0 = seen.x0, x1 = seen.x1, y0 = std::max<std::int64_t>(seen.y0, from),
                     y1 = std::min<std::int64_t>(seen.y1, to - 1);
  const std::int64_t left = (x0 << bits) + offset, low = (y0 << bits) + offset;
  Side<Area> sides[3] = {{a, second, left, low}, {second, third, left, low}, {third, a, left, low}};
  for (std::int64_t j = y0; j <= y1; ++j) {
    for (std::int64_t k = x0; k <= x1; ++k) {
      if (sides[0].left() && sides[1].left() && sides[2].left()) {
        const std::int64_t x = (k << bits) + offset, y = (j << bits) + offset;
        const double by_b = static_cast<double>(turn<Area>(c, a, x, y)) / all;
        const double by_c = static_cast<double>(turn<Area>(a, b, x, y)) / all;
        const double at = along_[t[0]] + by_b * (along_[t[1]] - along_[t[0]]) +
                          by_c * (along_[t[2]] - along_[t[0]]);
        found.push_back({static_cast<std::uint32_t>(j * count_ + k), {at, seen.triangle, sign}});
      }
      for (Side<Area>& side : sides) side.next_pixel();
    }
    for (Side<Area>& side : sides) side.next_row();
  }
}

/// Goes through the rows from the first to the last, some at a time.
class Lines::Bands {
 public:
  explicit Bands(const Lines& lines) : lines_(lines) {
    const auto rows = static_cast<std::size_t>(lines.count_);
    std::vector<std::int64_t> change(rows + 1, 0);
    for (const Seen& s : lines.seen_) {
      const std::int64_t width = s.x1 - s.x0 + 1;
      change[static_cast<std::size_t>(s.y0)] += width;
      change[static_cast<std::size_t>(s.y1) + 1] -= width;
    }
    most_hits_.resize(rows);
    std::partial_sum(change.begin(), change.end() - 1, most_hits_.begin());
  }

  bool use_all(bool ordered, const Use& use, const Progress& progress) {
    for (int from = 0, to = 0; from < lines_.count_; from = to) {
      report(progress, static_cast<double>(from) / lines_.count_);
      std::int64_t hits = most_hits_[static_cast<std::size_t>(from)];
      for (to = from + 1; to < lines_.count_; ++to)
        if ((hits += most_hits_[static_cast<std::size_t>(to)]) > hits_at_once) break;
      find_hits(from, to);
      if (!use_lines(from, to, ordered, use)) return false;
    }
    return true;
  }

 private:
  /// The hits of some rows, by line.
  void find_hits(int from, int to) {
    std::erase_if(now_, [from](const Seen& s) { return s.y1 < from; });
    for (; next_ < lines_.seen_.size() && lines_.seen_[next_].y0 < to; ++next_)
      now_.push_back(lines_.seen_[next_]);
    found_.clear();
    for (const Seen& s : now_)
      if (lines_.near_)
        lines_.add_hits<std::int64_t>(s, from, to, found_);
      else
        lines_.add_hits<Wide>(s, from, to, found_);
    const std::size_t first = first_line(from);
    start_.assign(first_line(to) - first + 1, 0);
    for (const Found& f : found_) ++start_[f.line - first + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    hits_.resize(found_.size());
    next_place_.assign(start_.begin(), start_.end() - 1);
    for (const Found& f : found_) hits_[next_place_[f.line - first]++] = f.hit;
  }

  bool use_lines(int from, int to, bool ordered, const Use& use) {
    const std::size_t first = first_line(from);
    for (std::size_t line = first; line < first_line(to); ++line) {
      const std::span<LineHit> hits(hits_.data() + start_[line - first],
                                    start_[line - first + 1] - start_[line - first]);
      if (hits.empty()) continue;
      if (ordered)
        ordering::sort(hits.begin(), hits.end(), [](const LineHit& p, const LineHit& q) {
          return p.along != q.along ? p.along < q.along : p.triangle < q.triangle;
        });
      if (!use(line, hits)) return false;
    }
    return true;
  }

  std::size_t first_line(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(lines_.count_);
  }

  const Lines& lines_;
  std::vector<std::int64_t> most_hits_;  // of each row
  std::size_t next_ = 0;                 // in lines_.seen_
  std::vector<Seen> now_;
  std::vector<Found> found_;
  std::vector<LineHit> hits_;
  std::vector<std::size_t> start_, next_place_;  // in hits_, by line
};

bool Lines::each(const Use& use, const Progress& progress) const {
  return Bands(*this).use_all(true, use, progress);
}

bool Lines::each_unordered(const Use& use, const Progress& progress) const {
  return Bands(*this).use_all(false, use, progress);
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
