// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/thinned_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/proximity/placement.hpp"
#include "engine/proximity/triangle_batch.hpp"

namespace sonde {
namespace {

/// Finds rows by the place of their point on A: a hash table of the last few rows of each cell.
/// A row that it has forgotten stands for nothing more, and the rows are denser than they need be.
class RowsByPlace {
 public:
  /// Cells are so small that two points of one are nearer than the spacing.
  explicit RowsByPlace(double spacing) : per_cell_(spacing > 0 ? 1.7320508 / spacing : 0) {
    clear();
  }
  void clear() {
    for (Bucket& b : buckets_) b.fill(none);
  }
  void add(const Vec3& x, std::size_t row) {
    Bucket& b = bucket(x);
    std::copy_backward(b.begin(), b.end() - 1, b.end());
    b[0] = static_cast<std::uint32_t>(row);
  }
  template <class Test>
  bool any(const Vec3& x, const Test& test) const {
    for (const std::uint32_t row : buckets_[index(x)])
      if (row != none && test(row)) return true;
    return false;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  using Bucket = std::array<std::uint32_t, 8>;
  std::size_t index(const Vec3& x) const {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      const double cell = std::floor(x[i] * per_cell_);
      h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) * 0x9e3779b97f4a7c15u;
    }
    return static_cast<std::size_t>(h >> 32) % buckets_.size();
  }
  Bucket& bucket(const Vec3& x) { return buckets_[index(x)]; }

  double per_cell_;
  std::array<Bucket, 512> buckets_;
};

class Thinner {
 public:
  Thinner(const Body& a, const Body& b, const Transform& X_BA, double reach,
          const Thinning& thinning, std::span<NearPair> out)
      : at_(a, b, X_BA),
        a_(a),
        b_(b),
        batch_(a, b, at_.X),
        reach_(reach),
        thinning_(thinning),
        sin_angle_(std::sqrt(std::max(0.0, 1 - thinning.cos_angle * thinning.cos_angle))),
        out_(out),
        rows_(thinning.spacing) {}

  NearPairs run() {
    SlotPairs children;
    stack_.push(at_.roots());
    while (!stack_.empty()) {
      const SlotPair p = stack_.pop();
      const float limit = at_.above(reach_);
      if (p.bound > limit) continue;
      if (at_.is_leaf(p)) {
        batch_.add(at_.triangle_a(p), at_.triangle_b(p));
        if (batch_.full()) look();
        continue;
      }
      if (is_spoken_for(p)) continue;
      at_.open_near(p, limit, children);
      // The nearest first: what it finds stands for others.
      std::sort(children.pair.begin(), children.pair.begin() + children.count,
                [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
      for (const SlotPair& child : children) stack_.push(child);
    }
    look();
    return {found_, reach_};
  }

 private:
  bool stands_for(const NearPair& row, const Vec3& on_a, const Vec3& normal, double gap) const {
    return row.gap <= gap && row.normal.dot(normal) >= thinning_.cos_angle &&
           (row.on_a - on_a).squaredNorm() <= thinning_.spacing * thinning_.spacing;
  }

  void look() {
    batch_.flush(reach_, [&](std::uint32_t i, std::uint32_t j, int k, const ClosestPoints8& p) {
      if (!(p.distance[k] > 0) || p.distance[k] > reach_) return;
      const NearPair pair{on_a(p, k), on_b(p, k), normal(p, k), p.gap[k], i, j};
      const bool known = rows_.any(pair.on_a, [&](std::uint32_t row) {
        return stands_for(out_[row], pair.on_a, pair.normal, pair.gap);
      });
      if (known) return;
      if (found_ == out_.size()) make_room();
      rows_.add(pair.on_a, found_);
      out_[found_++] = pair;
    });
  }

  /// What stood for a pair nearer than the new reach is nearer still: it stays.
  void make_room() {
    found_ = keep_nearer_half(out_, reach_);
    rows_.clear();
    for (std::size_t row = 0; row < found_; ++row) rows_.add(out_[row].on_a, row);
  }

  /// Does one row stand for all that two small boxes hold? The points of A are within the spacing
  /// wherever they lie in the box; no pair is nearer than the boxes; and the way from a point of
  /// one to a point of the other leans from that of the centres by no more than their radii allow.
  bool is_spoken_for(const SlotPair& p) const {
    const double smallest = at_.below(p.bound);
    if (!(smallest > 0) || p.size_a > thinning_.spacing) return false;
    const double radius_a = a_.tree.half_diagonal(p.a), radius_b = b_.tree.half_diagonal(p.b);
    if (radius_a > thinning_.spacing) return false;
    const Vec3 center_a = at_.X * a_.tree.center(p.a), center_b = b_.tree.center(p.b);
    const Vec3 way = center_a - center_b;
    const double length = way.norm(), lean = (radius_a + radius_b + at_.guard) / length;
    if (!(lean < sin_angle_)) return false;
    const double room = thinning_.spacing - radius_a - at_.guard;
    return rows_.any(center_a, [&](std::uint32_t row) {
      const NearPair& r = out_[row];
      if (r.gap > smallest || (r.on_a - center_a).norm() > room) return false;
      // cos(angle of the ways + largest lean) ≥ cos of the angle asked for
      const double cosine = std::min(1.0, r.normal.dot(way) / length);
      const double sine = std::sqrt(1 - cosine * cosine);
      return cosine > 0 &&
             cosine * std::sqrt(1 - lean * lean) - sine * lean >= thinning_.cos_angle + 1e-9;
    });
  }

  Placement at_;
  const Body& a_;
  const Body& b_;
  TriangleBatch batch_;
  PairStack<SlotPair> stack_;
  double reach_;
  Thinning thinning_;
  double sin_angle_;
  std::span<NearPair> out_;
  std::size_t found_ = 0;
  RowsByPlace rows_;
};

}  // namespace

NearPairs thinned_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                        const Thinning& thinning, std::span<NearPair> out) {
  return Thinner(a, b, X_BA, reach, thinning, out).run();
}

}  // namespace sonde
