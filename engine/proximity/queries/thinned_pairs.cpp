// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/thinned_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {
namespace {

/// Finds rows by their point on A: each is listed in the eight cells, as wide as the spacing, whose
/// middles are around it, so that one look finds all rows within half the spacing, and most of
/// those within all of it. What is not found stands for nothing: there are more rows than need be,
/// never fewer.
class RowTable {
 public:
  explicit RowTable(double spacing) : per_cell_(spacing > 0 ? 1 / spacing : 0) { clear(); }
  void clear() {
    first_.fill(none);
    entries_ = 0;
  }
  void add(const Vec3& x, std::size_t row) {
    if (!(per_cell_ > 0)) return;
    const std::uint32_t low = key(x - Vec3::Constant(0.5 / per_cell_));
    for (std::uint32_t corner = 0; corner < 8 && entries_ < list_.size(); ++corner) {
      const std::uint32_t x_side = corner & 1, y_side = corner >> 1 & 1, z_side = corner >> 2;
      std::uint16_t& first =
          first_[bucket(low + x_side * spread[0] + y_side * spread[1] + z_side * spread[2])];
      list_[entries_] = {static_cast<std::uint32_t>(row), first};
      first = static_cast<std::uint16_t>(entries_++);
    }
  }
  template <class Test>
  bool any(const Vec3& x, const Test& test) const {
    if (!(per_cell_ > 0)) return false;
    for (std::uint16_t e = first_[bucket(key(x))]; e != none; e = list_[e].next)
      if (test(list_[e].row)) return true;
    return false;
  }

 private:
  static constexpr std::uint16_t none = 0xffff;
  struct Entry {
    std::uint32_t row;
    std::uint16_t next;
  };
  /// Of the cell that x lies in: keys of neighbours differ by `spread`. Far from the origin, for
  /// the spacing, all is one cell.
  std::uint32_t key(const Vec3& x) const {
    constexpr double most = 0x1p40;
    std::uint32_t key = 0;
    for (int i = 0; i < 3; ++i) {
      const double at = x[i] * per_cell_;
      if (!(std::abs(at) < most)) return 0;
      key += static_cast<std::uint32_t>(static_cast<std::int64_t>(at + most)) *
             spread[static_cast<std::size_t>(i)];
    }
    return key;
  }
  static std::size_t bucket(std::uint32_t key) { return key * 0x9e3779b1u >> 20; }

  static constexpr std::array<std::uint32_t, 3> spread{0x8da6b343u, 0xd8163841u, 0xcb1ab31fu};
  static constexpr int buckets = 4096;
  double per_cell_;
  std::size_t entries_ = 0;
  std::array<std::uint16_t, buckets> first_;
  std::array<Entry, 32768> list_;
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
      std::sort(children.begin(), children.end(),
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
    batch_.flush(reach_, [&](const TriangleBatch::Pair& of, int k, const ClosestPoints8& p) {
      if (!(p.distance[k] > 0) || p.distance[k] > reach_) return;
      const NearPair pair = near_pair(of, k, p);
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
  RowTable rows_;
};

}  // namespace

NearPairs thinned_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                        const Thinning& thinning, std::span<NearPair> out) {
  return Thinner(a, b, X_BA, reach, thinning, out).run();
}

}  // namespace sonde
