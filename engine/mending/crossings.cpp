// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/crossings.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/geometry/union_find.hpp"
#include "engine/mending/near_pairs.hpp"
#include "engine/mending/point_windings.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {
namespace {

using Box = Eigen::AlignedBox3d;
/// Share of a triangle by which an edge may pass beside it: where faces of both lie in one plane,
/// or on the diagonal of a face, rounding decides.
constexpr double beside = 1e-9;

/// Where the edge from x to y goes through a triangle.
std::optional<Vec3> piercing(const Vec3& x, const Vec3& y, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double above = normal.dot(x - t[0]), below = normal.dot(y - t[0]);
  if (!(above * below < 0)) return std::nullopt;
  const Vec3 at = x + above / (above - below) * (y - x);
  for (std::size_t k = 0; k < 3; ++k)
    if (normal.dot((t[(k + 1) % 3] - t[k]).cross(at - t[k])) < -beside * normal.squaredNorm())
      return std::nullopt;
  return at;
}

/// Where a part crosses itself: closed curves, each of pieces that two triangles have in common.
/// Pieces meet where an edge goes through a triangle.
class SelfCrossings {
 public:
  /// An edge by its two vertices, ascending, and the triangle that it goes through.
  using End = std::array<std::uint32_t, 3>;

  void add(const std::vector<std::pair<End, Vec3>>& piece) {
    const auto own = static_cast<std::uint32_t>(boxes_.size());
    boxes_.emplace_back();
    for (const auto& [end, at] : piece) {
      boxes_[own].extend(at);
      const auto [known, is_new] = by_end_.emplace(end, own);
      if (!is_new) joined_.emplace_back(known->second, own);
    }
  }

  std::vector<Box> boxes() const {
    UnionFind sets(boxes_.size());
    for (const auto& [a, b] : joined_) sets.join(a, b);
    std::map<std::uint32_t, Box> by_set;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      by_set[static_cast<std::uint32_t>(sets.find(i))].extend(boxes_[i]);
    std::vector<Box> out;
    out.reserve(by_set.size());
    for (const auto& [set, box] : by_set) out.push_back(box);
    return out;
  }

 private:
  std::map<End, std::uint32_t> by_end_;  // the first piece that has it
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined_;
  std::vector<Box> boxes_;  // by piece
};

class CrossingFinder {
 public:
  CrossingFinder(const Soup& soup, const std::vector<std::uint32_t>& part)
      : soup_(soup), part_(part) {
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
      const std::uint32_t p = part[i];
      if (p >= of_part_.size()) of_part_.resize(p + 1), bounds_.resize(p + 1);
      of_part_[p].push_back(i);
      box_.emplace_back();
      for (const std::uint32_t v : soup.triangles[i]) box_.back().extend(soup.vertices[v]);
      bounds_[p].extend(box_.back());
    }
  }

  Crossings run(std::size_t most_pairs, const Progress& progress) {
    rank_parts();
    const auto use = [&](std::uint32_t i, std::uint32_t j) {
      part_[i] == part_[j] ? cross_itself(i, j) : cross(i, j);
    };
    if (!each_near_pair(box_, most_pairs, use, part_of(progress, 0, 0.7))) return {{}, false};
    for (const auto& [ranks, met] : met_)
      found_.push_back({order_[ranks.first], order_[ranks.second], met});
    add_corners(part_of(progress, 0.7, 1));
    Crossings out;
    for (const Crossing& c : found_) out.boxes.push_back(c.box);
    for (const Box& box : loops_.boxes()) out.boxes.push_back(box);
    return out;
  }

 private:
  /// Two parts that cross, and the box of what they have in common.
  struct Crossing {
    std::uint32_t p, q;
    Box box;
  };

  void rank_parts() {
    for (std::uint32_t p = 0; p < of_part_.size(); ++p)
      if (!of_part_[p].empty()) order_.push_back(p);
    std::ranges::stable_sort(order_, {}, [&](std::uint32_t p) { return bounds_[p].min().x(); });
    rank_.resize(of_part_.size());
    for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
  }

  /// The triangles of a part that are by a box.
  std::vector<std::uint32_t> triangles_by(std::uint32_t p, const Box& common) const {
    std::vector<std::uint32_t> out;
    std::ranges::copy_if(of_part_[p], std::back_inserter(out),
                         [&](std::uint32_t i) { return box_[i].intersects(common); });
    return out;
  }

  void cross(std::uint32_t i, std::uint32_t j) {
    Box met;
    add_piercings(met, i, j);
    if (met.isEmpty()) return;
    const std::uint32_t p = rank_[part_[i]], q = rank_[part_[j]];
    met_[{std::min(p, q), std::max(p, q)}].extend(met);
  }

  /// Two triangles of one part. Edges that end at the other triangle only touch it there.
  void cross_itself(std::uint32_t i, std::uint32_t j) {
    std::vector<std::pair<SelfCrossings::End, Vec3>> piece;
    for (const auto& [of, through] : {std::pair{i, j}, std::pair{j, i}}) {
      const Triangle &t = soup_.triangles[of], &other = soup_.triangles[through];
      const std::array<Vec3, 3> face = corners(through);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if (std::ranges::count(other, a) + std::ranges::count(other, b) > 0) continue;
        // From the same end for both triangles at the edge, which then meet in the same point.
        if (const auto at = piercing(soup_.vertices[a], soup_.vertices[b], face))
          piece.push_back({{a, b, through}, *at});
      }
    }
    if (!piece.empty()) loops_.add(piece);
  }

  std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    const Triangle& t = soup_.triangles[triangle];
    const auto& x = soup_.vertices;
    return {x[t[0]], x[t[1]], x[t[2]]};
  }

  void add_piercings(Box& met, std::uint32_t i, std::uint32_t j) const {
    const std::array<Vec3, 3> a = corners(i), b = corners(j);
    for (std::size_t k = 0; k < 3; ++k) {
      if (const auto at = piercing(a[k], a[(k + 1) % 3], b)) met.extend(*at);
      if (const auto at = piercing(b[k], b[(k + 1) % 3], a)) met.extend(*at);
    }
  }

  /// What two parts have in common reaches to where they cross, and to corners of the one inside
  /// the other.
  void add_corners(const Progress& progress) {
    std::vector<PartPoint> points;
    std::vector<std::pair<std::size_t, std::uint32_t>> of;  // the crossing, and the other part
    for (std::size_t c = 0; c < found_.size(); ++c)
      for (const auto& [part, other] :
           {std::pair{found_[c].p, found_[c].q}, std::pair{found_[c].q, found_[c].p}})
        for (const std::uint32_t i : triangles_by(part, bounds_[other]))
          for (const Vec3& x : corners(i))
            if (bounds_[other].contains(x)) points.push_back({x, part}), of.emplace_back(c, other);
    if (points.empty()) return;
    const std::vector<std::uint32_t> no_cap(part_.size(), Sealed::no_cap);
    const std::vector<PartWindings> around =
        part_windings(Sealed{soup_, part_, no_cap}, points, progress);
    for (std::size_t k = 0; k < points.size(); ++k)
      for (const auto& [part, winding] : around[k])
        if (part == of[k].second) found_[of[k].first].box.extend(points[k].x);
  }

  const Soup& soup_;
  const std::vector<std::uint32_t>& part_;
  std::vector<std::vector<std::uint32_t>> of_part_;             // triangles
  std::vector<Box> box_;                                        // by triangle
  std::vector<Box> bounds_;                                     // by part
  std::vector<std::uint32_t> order_, rank_;                     // of parts, from low x on
  std::map<std::pair<std::uint32_t, std::uint32_t>, Box> met_;  // by ranks of two parts
  std::vector<Crossing> found_;
  SelfCrossings loops_;
};

}  // namespace

Crossings find_crossings(const Soup& soup, const std::vector<std::uint32_t>& part,
                         const Progress& progress, std::size_t most_pairs) {
  return CrossingFinder(soup, part).run(most_pairs, progress);
}

}  // namespace sonde
