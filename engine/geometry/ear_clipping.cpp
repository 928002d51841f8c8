// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/ear_clipping.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {
namespace {

using Vec2 = Eigen::Vector2d;

/// Angles whose sine is below this count as straight while ears are clipped. This affects only the
/// choice of ears, not which corners are kept.
constexpr double straight = 1e-12;
/// For a polygon that crosses itself: number of corners among which the next one is chosen.
constexpr std::size_t window = 64;
/// The reflex corners on a grid, so that an ear need not be compared with all of them.
class Blockers {
 public:
  void build(const std::vector<Vec2>& at, const std::vector<std::size_t>& corners) {
    constexpr std::size_t few = 64;
    side_ = corners.size() <= few ? 1 : static_cast<std::size_t>(std::sqrt(corners.size()));
    low_ = high_ = at[0];
    for (const Vec2& x : at) low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x);
    blocks_.assign(at.size(), 0);
    first_.assign(side_ * side_ + 1, 0);
    for (const std::size_t i : corners) ++first_[cell(at[i])], blocks_[i] = 1;
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    items_ = corners;
    for (const std::size_t i : corners) items_[--first_[cell(at[i])]] = i;  // ends become starts
  }

  bool has(std::size_t i) const { return blocks_[i] != 0; }
  void remove(std::size_t i) { blocks_[i] = 0; }

  /// Whether `test` holds for one of the corners in the box.
  template <class Test>
  bool any(const Vec2& low, const Vec2& high, const Test& test) const {
    const double slack = side_ > 1 ? 1e-9 : 0;  // tolerance for straight corners
    const std::size_t x0 = column(low, 0, -slack), x1 = column(high, 0, slack);
    const std::size_t y0 = column(low, 1, -slack), y1 = column(high, 1, slack);
    for (std::size_t y = y0; y <= y1; ++y)
      for (std::size_t x = x0; x <= x1; ++x)
        for (std::size_t k = first_[y * side_ + x]; k < first_[y * side_ + x + 1]; ++k)
          if (has(items_[k]) && test(items_[k])) return true;
    return false;
  }

 private:
  std::size_t column(const Vec2& x, int axis, double slack) const {
    const double size = high_[axis] - low_[axis];
    const double at = size > 0 ? (x[axis] + slack - low_[axis]) / size : 0;
    return static_cast<std::size_t>(
        std::clamp(at * static_cast<double>(side_), 0.0, static_cast<double>(side_ - 1)));
  }
  std::size_t cell(const Vec2& x) const { return column(x, 1, 0) * side_ + column(x, 0, 0); }

  std::size_t side_ = 1;
  Vec2 low_, high_;
  std::vector<std::size_t> first_, items_;
  std::vector<char> blocks_;
};

class EarClipper {
 public:
  EarClipper(const std::vector<std::size_t>& polygon, std::vector<Vec2> flat,
             std::vector<Triangle>& out)
      : polygon_(polygon),
        flat_(std::move(flat)),
        out_(out),
        may_be_ear_(polygon.size(), 1),
        left_(polygon.size()) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    std::vector<std::size_t> blockers;
    for (std::size_t i = 0; i < n; ++i)
      if (turn_at(i) <= 0) blockers.push_back(i);
    blockers_.build(flat_, blockers);
  }

  void clip() {
    std::size_t at = 0, tried = 0;
    while (left_ > 3) {
      if (tried > patience()) {
        crosses_ = true;
        cut(at = most_convex(at));
      } else if (may_be_ear_[at] != 0 && is_ear(at)) {
        cut(at);
      } else {
        may_be_ear_[at] = 0;  // until a neighbour is removed
        at = next_[at];
        ++tried;
        continue;
      }
      tried = 0;
      at = next_[next_[at]];
    }
    emit(at);
  }

 private:
  double turn_at(std::size_t i) const {
    return turn(flat_[previous_[i]], flat_[i], flat_[next_[i]]);
  }

  /// Number of consecutive corners without an ear after which none is expected.
  std::size_t patience() const { return crosses_ ? std::min(left_, window) : left_; }

  /// Convex, with no other corner inside or on it. Only reflex corners can be inside.
  bool is_ear(std::size_t i) const {
    if (turn_at(i) <= 0) return false;
    const Vec2 &a = flat_[previous_[i]], &b = flat_[i], &c = flat_[next_[i]];
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    return !blockers_.any(low, high, [&](std::size_t k) {
      const Vec2& x = flat_[k];
      if (x == a || x == b || x == c)
        return false;  // a corner, or a bridge to a hole that meets one
      return turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0;
    });
  }

  std::size_t most_convex(std::size_t start) const {
    std::size_t best = start, i = next_[start];
    for (std::size_t k = 1; k < window && i != start; ++k, i = next_[i])
      if (turn_at(i) > turn_at(best)) best = i;
    return best;
  }

  void emit(std::size_t i) {
    const auto vertex = [&](std::size_t k) { return static_cast<std::uint32_t>(polygon_[k]); };
    out_.push_back({vertex(previous_[i]), vertex(i), vertex(next_[i])});
  }

  void cut(std::size_t i) {
    emit(i);
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    --left_;
    blockers_.remove(i);
    // A corner only becomes more convex when a neighbour is removed, so blockers are only removed.
    for (const std::size_t k : {previous_[i], next_[i]}) {
      may_be_ear_[k] = 1;
      if (blockers_.has(k) && turn_at(k) > 0) blockers_.remove(k);
    }
  }

  const std::vector<std::size_t>& polygon_;
  std::vector<Vec2> flat_;
  std::vector<Triangle>& out_;
  std::vector<std::size_t> next_, previous_;
  Blockers blockers_;
  std::vector<char> may_be_ear_;
  std::size_t left_;
  bool crosses_ = false;
};

}  // namespace

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, bc = c - b;
  const double z = ab.x() * bc.y() - ab.y() * bc.x();
  return std::abs(z) <= straight * ab.norm() * bc.norm() ? 0 : z;
}

void clip_ears(const std::vector<std::size_t>& polygon, std::vector<Vec2> flat,
               std::vector<Triangle>& out) {
  EarClipper(polygon, std::move(flat), out).clip();
}

}  // namespace sonde
