// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/crossings.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/mending/point_windings.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {
namespace {

using Box = Eigen::AlignedBox3d;
/// With more, one box holds them all: each costs lines of its own.
constexpr std::size_t most_boxes = 200;

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

class Crossings {
 public:
  Crossings(const Soup& soup, const std::vector<std::uint32_t>& part, std::size_t most_pairs)
      : soup_(soup), part_(part), most_pairs_(most_pairs) {
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
      const std::uint32_t p = part[i];
      if (p >= of_part_.size()) of_part_.resize(p + 1), bounds_.resize(p + 1);
      of_part_[p].push_back(i);
      box_.emplace_back();
      for (const std::uint32_t v : soup.triangles[i]) box_.back().extend(soup.vertices[v]);
      bounds_[p].extend(box_.back());
    }
  }

  std::vector<Box> run(const Progress& progress) {
    find_pairs(part_of(progress, 0, 0.7));
    if (pairs_ > most_pairs_) return {};
    add_corners(part_of(progress, 0.7, 1));
    std::vector<Box> out;
    for (const Crossing& c : found_) out.push_back(c.box);
    return apart(std::move(out));
  }

 private:
  /// Two parts that cross, and the box of what they have in common.
  struct Crossing {
    std::uint32_t p, q;
    Box box;
  };

  void find_pairs(const Progress& progress) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < of_part_.size(); ++p)
      if (!of_part_[p].empty()) order.push_back(p);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t p) { return bounds_[p].min().x(); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      report(progress, static_cast<double>(i) / static_cast<double>(order.size()));
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (bounds_[order[j]].min().x() > bounds_[order[i]].max().x()) break;
        if (++pairs_ > most_pairs_) return;
        if (bounds_[order[i]].intersects(bounds_[order[j]])) cross(order[i], order[j]);
        if (pairs_ > most_pairs_) return;
      }
    }
  }

  /// The triangles of a part that are by a box.
  std::vector<std::uint32_t> triangles_by(std::uint32_t p, const Box& common) const {
    std::vector<std::uint32_t> out;
    std::ranges::copy_if(of_part_[p], std::back_inserter(out),
                         [&](std::uint32_t i) { return box_[i].intersects(common); });
    return out;
  }

  void cross(std::uint32_t p, std::uint32_t q) {
    const Box common = bounds_[p].intersection(bounds_[q]);
    const std::vector<std::uint32_t> of_p = triangles_by(p, common);
    std::vector<std::uint32_t> of_q = triangles_by(q, common);
    std::ranges::stable_sort(of_q, {}, [&](std::uint32_t j) { return box_[j].min().x(); });
    Box met;
    for (const std::uint32_t i : of_p)
      for (const std::uint32_t j : of_q) {
        if (box_[j].min().x() > box_[i].max().x()) break;
        if (++pairs_ > most_pairs_) return;
        if (box_[i].intersects(box_[j])) add_piercings(met, i, j);
      }
    if (!met.isEmpty()) found_.push_back({p, q, met});
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

  /// Boxes that overlap as one, until none do; all as one where they are very many.
  static std::vector<Box> apart(std::vector<Box> boxes) {
    std::vector<Box> out;
    for (Box box : boxes) {
      const auto overlaps = [&](const Box& other) {
        return boxes.size() > most_boxes || other.intersects(box);
      };
      for (auto met = std::ranges::find_if(out, overlaps); met != out.end();
           met = std::ranges::find_if(out, overlaps)) {
        box.extend(*met);
        out.erase(met);
      }
      out.push_back(box);
    }
    return out;
  }

  const Soup& soup_;
  const std::vector<std::uint32_t>& part_;
  std::size_t most_pairs_, pairs_ = 0;
  std::vector<std::vector<std::uint32_t>> of_part_;  // triangles
  std::vector<Box> box_;                             // by triangle
  std::vector<Box> bounds_;                          // by part
  std::vector<Crossing> found_;
};

}  // namespace

std::vector<Eigen::AlignedBox3d> crossings_of_parts(const Soup& soup,
                                                    const std::vector<std::uint32_t>& part,
                                                    const Progress& progress,
                                                    std::size_t most_pairs) {
  return Crossings(soup, part, most_pairs).run(progress);
}

}  // namespace sonde
