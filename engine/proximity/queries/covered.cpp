// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/covered.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/wall_piece.hpp"

namespace sonde {
namespace {

/// A point at most `away` (m) from x, inside the triangle and on none of its edges.
Vec3 next_to(const Vec3& x, const Corners& t, double away) {
  const Vec3 way = wall_center(t) - x;
  const double length = way.norm();
  return length > 2 * away ? Vec3(x + away / length * way) : Vec3(x + 0.5 * way);
}

/// Best-first search over boxes, triangles and pieces of them, by their least distance from x.
class OutsideSearch {
 public:
  OutsideSearch(const Body& body, const Vec3& x)
      : body_(body), x_(x), frame_(body, x), tolerance_(beside_a_wall * extent(body)) {
    queue_.insert({0, Entry::Kind::box, 0});
  }

  /// No value if everything is covered, which only rounding can cause.
  std::optional<NearestPoint> run() {
    while (!queue_.empty()) {
      const Entry e = *queue_.begin();
      queue_.erase(queue_.begin());
      if (e.kind == Entry::Kind::box) {
        open(e.index);
        continue;
      }
      const WallPiece piece = std::move(pieces_[e.index]);
      const Vec3 within = piece.nearest_within(within_a_wall * extent(body_));
      if (!is_covered(body_, piece.triangle(), within))
        return NearestPoint{piece.distance(), piece.nearest(), piece.triangle()};
      cut(piece);
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    enum class Kind { box, piece };
    double bound;  // m: nothing of it is nearer
    Kind kind;
    std::size_t index;  // of a slot of the tree, or of a piece
    bool operator<(const Entry& other) const {
      return std::tuple(bound, kind, index) < std::tuple(other.bound, other.kind, other.index);
    }
  };

  void push(WallPiece piece) {
    queue_.insert({piece.distance(), Entry::Kind::piece, pieces_.size()});
    pieces_.push_back(std::move(piece));
  }

  void open(std::size_t slot) {
    const std::uint32_t child = body_.tree.child(static_cast<std::uint32_t>(slot));
    if (child & Tree::triangle_bit) {
      const std::uint32_t triangle = child & ~Tree::triangle_bit;
      return push(WallPiece(triangle, corners(surface(body_), triangle), x_));
    }
    const Tree::Node& node = body_.tree.nodes[child];
    Lanes bounds;
    box_kernels().point_distances(frame_.point, node, frame_.scale, bounds);
    for (std::uint32_t left = at_most(bounds, std::numeric_limits<float>::infinity(), node);
         left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      const double bound = (bounds.value[k] - frame_.guard) / frame_.per_unit;
      queue_.insert({bound, Entry::Kind::box, child * Tree::width + k});
    }
  }

  /// Cuts a covered piece along the line, nearest to x, in which another triangle meets it. If
  /// there is none, all of the piece is covered.
  void cut(const WallPiece& piece) {
    const WallCrossing* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const WallCrossing& crossing : crossings_of(piece.triangle())) {
      const double distance = piece.distance_to(crossing, tolerance_);
      if (distance < least) least = distance, nearest = &crossing;
    }
    if (!nearest) return;
    for (WallPiece& half : piece.halves(*nearest)) push(std::move(half));
  }

  /// Where the other triangles of the solid meet a triangle.
  const std::vector<WallCrossing>& crossings_of(std::uint32_t triangle) {
    const auto [known, is_new] = crossings_.try_emplace(triangle);
    if (!is_new) return known->second;
    const Corners wall = corners(surface(body_), triangle);
    const double radius = wall_radius(wall) + tolerance_;
    std::vector<std::uint32_t> slots{0};
    while (!slots.empty()) {
      const std::uint32_t slot = slots.back();
      slots.pop_back();
      const double reach = body_.tree.half_diagonal(slot) * (1 + 1e-6) + radius;
      if ((body_.tree.center(slot) - wall_center(wall)).norm() > reach) continue;
      const std::uint32_t child = body_.tree.child(slot);
      if (!(child & Tree::triangle_bit)) {
        for (std::uint32_t k = 0; k < Tree::width; ++k)
          if (body_.tree.nodes[child].child[k] != Tree::none)
            slots.push_back(child * static_cast<std::uint32_t>(Tree::width) + k);
        continue;
      }
      const std::uint32_t other = child & ~Tree::triangle_bit;
      if (other == triangle || is_loose(body_, other)) continue;
      add_crossings(wall, corners(surface(body_), other), tolerance_, known->second);
    }
    return known->second;
  }

  const Body& body_;
  Vec3 x_;
  PointFrame frame_;
  double tolerance_;       // m
  std::set<Entry> queue_;  // the nearest first; equal distances in a fixed order
  std::deque<WallPiece> pieces_;
  std::unordered_map<std::uint32_t, std::vector<WallCrossing>> crossings_;
};

}  // namespace

bool is_covered(const Body& body, std::uint32_t triangle, const Vec3& x) {
  if (!body.solid || is_loose(body, triangle)) return false;
  const Corners t = corners(surface(body), triangle);
  const Vec3 n = area_normal(t).stableNormalized();
  const Vec3 on_plane = x - n * n.dot(x - t[0]);
  const Vec3 beside = beside_a_wall * extent(body) * n;
  return winds_around(body, on_plane + beside) && winds_around(body, on_plane - beside);
}

NearestPoint nearest_outside(const Body& body, const Vec3& x) {
  NearestPoint nearest = nearest_point(body, x, 0);
  if (!body.solid || is_loose(body, nearest.triangle)) return nearest;
  const Vec3 within = next_to(nearest.point, corners(surface(body), nearest.triangle),
                              within_a_wall * extent(body));
  if (!is_covered(body, nearest.triangle, within)) return nearest;
  return OutsideSearch(body, x).run().value_or(nearest);
}

}  // namespace sonde
