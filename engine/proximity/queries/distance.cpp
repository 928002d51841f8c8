// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/distance.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/far_distance.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {

namespace {

class Search {
 public:
  Search(const Body& a, const Body& b, const Transform& X_BA)
      : a_(a), b_(b), at_(a, b, X_BA), batch_(a, b, at_.X) {
    best_.distance = std::numeric_limits<double>::infinity();
  }

  void start_from(const DistanceHint& hint) {
    if (hint.triangle_a >= surface(a_).triangles.size() ||
        hint.triangle_b >= surface(b_).triangles.size())
      return;
    batch_.add(hint.triangle_a, hint.triangle_b);
    look();
  }

  /// Descends through the nearest boxes, a few at a time: the triangles at the end are mostly
  /// close.
  void dive() {
    std::array<SlotPair, abreast> level{at_.roots()};
    for (std::size_t count = 1; count > 0;) {
      const std::span<SlotPair> nearest = open_abreast({level.data(), count});
      count = 0;
      for (const SlotPair& p : nearest) {
        if (!at_.is_leaf(p))
          level[count++] = p;
        else if (!batch_.full())
          batch_.add(at_.triangle_a(p), at_.triangle_b(p));
      }
    }
    look();
  }

  Distance run() {
    SlotPairs found;
    stack_.push(at_.roots());
    while (best_.distance > 0) {
      if (stack_.empty()) {
        if (batch_.empty()) break;
        look();
        continue;
      }
      const SlotPair p = stack_.pop();
      const float limit = at_.to_unit_rounded_up(best_.distance);
      if (p.bound > limit) continue;
      if (at_.is_leaf(p)) {
        batch_.add(at_.triangle_a(p), at_.triangle_b(p));
        if (batch_.full()) look();
        continue;
      }
      at_.open_near(p, limit, found);
      ordering::sort(found.begin(), found.end(),
                     [](const SlotPair& x, const SlotPair& y) { return nearer_first(y, x); });
      for (const SlotPair& child : found) stack_.push(child);
    }
    return best_;
  }

 private:
  static constexpr std::size_t abreast = 4;  // the best of 1, 2, 4 and 8, measured
  static bool nearer_first(const SlotPair& x, const SlotPair& y) { return x.bound < y.bound; }

  /// Opens some pairs and returns the nearest of their children.
  std::span<SlotPair> open_abreast(std::span<const SlotPair> pairs) {
    SlotPairs found;
    std::size_t count = 0;
    for (const SlotPair& p : pairs) {
      at_.open_larger_box(p, found);
      for (const SlotPair& q : found) next_[count++] = q;
    }
    const std::span<SlotPair> all(next_.data(), count);
    const std::size_t kept = std::min(count, abreast);
    ordering::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(),
                           nearer_first);
    return all.first(kept);
  }

  void look() {
    batch_.flush(best_.distance,
                 [&](const TriangleBatch::Pair& pair, int lane, const ClosestPoints8& points) {
                   const double d = points.distance[lane];
                   if (d < best_.distance)
                     best_ = {d, on_a(points, lane), on_b(points, lane), pair.i, pair.j, d <= 0};
                 });
    at_.try_direction(best_.on_a - best_.on_b);
  }

  const Body& a_;
  const Body& b_;
  Placement at_;
  TriangleBatch batch_;
  PairStack<SlotPair> stack_;
  std::array<SlotPair, abreast * Tree::width> next_;
  Distance best_;
};

}  // namespace

Distance triangle_distance(const Body& a, const Body& b, const Transform& X_BA,
                           std::optional<DistanceHint> hint) {
  if (const auto found = far_distance(a, b, X_BA)) return *found;
  Search search(a, b, X_BA);
  if (hint)
    search.start_from(*hint);
  else
    search.dive();
  return search.run();
}

Distance distance(const Body& a, const Body& b, const Transform& X_BA,
                  std::optional<DistanceHint> hint) {
  Distance d = triangle_distance(a, b, X_BA, hint);
  if (!d.overlapping && component_inside(a, b, X_BA)) d.overlapping = true, d.distance = 0;
  return d;
}

}  // namespace sonde
