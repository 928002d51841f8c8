// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/facets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/body/region.hpp"
#include "engine/geometry/repeated.hpp"

namespace sonde {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
/// A region grows by the plane of a single triangle, whose direction is the less accurate the
/// smaller the triangle is. The region is checked afterwards against a plane through all of it.
constexpr double grows_by = 1e4;  // times the flatness
/// Fewer triangles are not worth merging: a square already needs two.
constexpr std::size_t fewest = 3;

struct Plane {
  Vec3 normal = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double height(const Vec3& x) const { return normal.dot(x - point); }
};

using Triangles = std::vector<std::uint32_t>;
/// For each side of each triangle (3 i + k: from corner k to the next), the adjacent triangle.
using Neighbours = std::vector<std::uint32_t>;
using Segments = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class Merger {
 public:
  Merger(const Soup& soup, double flatness) : soup_(soup), flatness_(flatness) {}

  Facets run(bool solid, const Progress& progress) {
    dropped_ = repeated_triangles(soup_, solid, part_of(progress, 0, 0.2));
    out_.duplicates = static_cast<std::size_t>(std::count(dropped_.begin(), dropped_.end(), true));
    find_neighbours(part_of(progress, 0.2, 0.6));
    done_.resize(soup_.triangles.size(), false);
    for (std::uint32_t i = 0; i < dropped_.size(); ++i)
      if (dropped_[i]) done_[i] = true;
    const Triangles order = largest_first();
    for_each_index(order.size(), part_of(progress, 0.6, 1), [&](std::size_t k) {
      const std::uint32_t seed = order[k];
      if (!done_[seed]) merge(grown_from(seed));
    });
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i)
      if (!done_[i]) keep(i);
    out_.soup.vertices = soup_.vertices;
    report(progress, 1);
    return std::move(out_);
  }

 private:
  Vec3 at(std::uint32_t triangle, std::size_t k) const {
    return soup_.vertices[soup_.triangles[triangle][k]];
  }
  Vec3 twice_area(std::uint32_t i) const {
    return (at(i, 1) - at(i, 0)).cross(at(i, 2) - at(i, 0));
  }
  void keep(std::uint32_t i) {
    out_.soup.triangles.push_back(soup_.triangles[i]);
    out_.from.push_back(i);
  }

  /// Finds neighbours across edges of two triangles that agree in orientation.
  void find_neighbours(const Progress& progress) {
    struct Side {
      std::uint32_t other, side;
      bool up;
    };
    const std::size_t n = soup_.triangles.size();
    neighbours_.assign(3 * n, none);
    std::vector<std::uint32_t> end(soup_.vertices.size() + 1, 0);
    const auto each_side = [&](const Progress& part, const auto& visit) {
      for_each_index(n, part, [&](std::size_t i) {
        if (dropped_[i]) return;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = soup_.triangles[i][k], b = soup_.triangles[i][(k + 1) % 3];
          visit(std::min(a, b), Side{std::max(a, b), static_cast<std::uint32_t>(3 * i + k), a < b});
        }
      });
    };
    each_side(part_of(progress, 0, 0.3), [&](std::uint32_t low, const Side&) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Side> sides(end.back());
    each_side(part_of(progress, 0.3, 0.6),
              [&](std::uint32_t low, const Side& side) { sides[end[low]++] = side; });
    std::size_t start = 0;
    for_each_index(soup_.vertices.size(), part_of(progress, 0.6, 1), [&](std::size_t v) {
      const std::span<Side> at(sides.data() + start, end[v] - start);
      start = end[v];
      ordering::sort(at.begin(), at.end(), [](const Side& x, const Side& y) {
        return x.other != y.other ? x.other < y.other : x.side < y.side;
      });
      for (std::size_t i = 0, j = 0; i < at.size(); i = j) {
        for (j = i; j < at.size() && at[j].other == at[i].other;) ++j;
        if (j - i != 2 || at[i].up == at[i + 1].up) continue;
        neighbours_[at[i].side] = at[i + 1].side / 3;
        neighbours_[at[i + 1].side] = at[i].side / 3;
      }
    });
  }

  /// The planes of large triangles are the most accurate.
  Triangles largest_first() const {
    std::vector<std::pair<double, std::uint32_t>> by_area;
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i) {
      if (done_[i]) continue;
      const Vec3 area = twice_area(i);
      const Plane plane{area.normalized(), at(i, 0)};
      bool flat = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t j = neighbours_[3 * i + k];
        flat = flat || (j != none && lies_in(j, plane, grows_by * flatness_));
      }
      if (flat) by_area.emplace_back(-area.squaredNorm(), i);
    }
    ordering::sort(by_area.begin(), by_area.end());
    Triangles out;
    for (const auto& [area, i] : by_area) out.push_back(i);
    return out;
  }

  bool lies_in(std::uint32_t i, const Plane& plane, double flatness) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (!(std::abs(plane.height(at(i, k))) <= flatness)) return false;
    // A sliver's own normal is inaccurate.
    const Vec3 area = twice_area(i);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (at(i, (k + 1) % 3) - at(i, k)).norm());
    return area.dot(plane.normal) >= -longest * flatness;
  }

  Triangles grown_from(std::uint32_t seed) {
    const Plane plane{twice_area(seed).normalized(), at(seed, 0)};
    Triangles region{seed};
    done_[seed] = true;
    for (std::size_t next = 0; next < region.size(); ++next)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t j = neighbours_[3 * region[next] + k];
        if (j == none || done_[j] || !lies_in(j, plane, grows_by * flatness_)) continue;
        done_[j] = true;
        region.push_back(j);
      }
    return region;
  }

  /// A plane through three corners far from each other, with the normal of the triangles.
  Plane plane_of(const Triangles& region) const {
    const Vec3 first = at(region[0], 0);
    const auto farthest = [&](const auto& distance) {
      Vec3 best = first;
      double most = -1;
      for (const std::uint32_t i : region)
        for (std::size_t k = 0; k < 3; ++k)
          if (const double d = distance(at(i, k)); d > most) most = d, best = at(i, k);
      return best;
    };
    const Vec3 a = farthest([&](const Vec3& x) { return (x - first).squaredNorm(); });
    const Vec3 b = farthest([&](const Vec3& x) { return (x - a).squaredNorm(); });
    const Vec3 c = farthest([&](const Vec3& x) { return (b - a).cross(x - a).squaredNorm(); });
    Vec3 normal = (b - a).cross(c - a).normalized();
    if (normal.dot(twice_area(region[0])) < 0) normal = -normal;
    return {normal, a};
  }

  void merge(const Triangles& region) {
    if (region.size() < fewest || !join(region))
      for (const std::uint32_t i : region) keep(i);
  }

  /// Outputs the region in fewer triangles. Returns false, and does nothing, if that is impossible.
  bool join(const Triangles& region) {
    const Plane plane = plane_of(region);
    double area = 0;
    for (const std::uint32_t i : region) {
      if (!lies_in(i, plane, flatness_)) return false;
      area += twice_area(i).dot(plane.normal);
    }
    const auto outline = outline_of(region);
    if (!outline) return false;
    Eigen::Index drop = 0;
    plane.normal.cwiseAbs().maxCoeff(&drop);
    const Eigen::Index u = (drop + 1) % 3, v = (drop + 2) % 3;
    PlanarRegion flat;
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<std::uint32_t> corner;
    const auto numbered = [&](std::uint32_t vertex) {
      const auto [found, is_new] =
          number.try_emplace(vertex, static_cast<std::uint32_t>(corner.size()));
      if (is_new) {
        corner.push_back(vertex);
        flat.points.push_back({soup_.vertices[vertex][u], soup_.vertices[vertex][v]});
      }
      return found->second;
    };
    for (const auto& [a, b] : *outline) {
      const std::uint32_t from = numbered(a);
      flat.outline.emplace_back(from, numbered(b));
    }
    const auto triangles = triangulate(flat);
    if (!triangles || triangles->size() >= region.size()) return false;
    const bool turned = plane.normal[drop] < 0;
    std::vector<Triangle> found;
    double covered = 0;
    for (const auto& t : *triangles) {
      Triangle whole{corner[t[0]], corner[t[1]], corner[t[2]]};
      if (turned) std::swap(whole[1], whole[2]);
      const Vec3 &a = soup_.vertices[whole[0]], &b = soup_.vertices[whole[1]],
                 &c = soup_.vertices[whole[2]];
      if (is_degenerate(a, b, c)) return false;
      covered += (b - a).cross(c - a).dot(plane.normal);
      found.push_back(whole);
    }
    // The region folds over itself, or touches itself in a way that the outline does not show:
    // then, however small the fold is, some triangle lies on the wrong side of the outline.
    if (!(std::abs(covered - area) <= 1e-9 * area) || !have_sides(found, *outline)) return false;
    for (const Triangle& t : found) {
      out_.soup.triangles.push_back(t);
      out_.from.push_back(region[0]);
    }
    out_.merged += region.size();
    return true;
  }

  /// Whether each segment, in its direction, is a side of a triangle.
  static bool have_sides(const std::vector<Triangle>& triangles, const Segments& segments) {
    Segments sides;
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
    ordering::sort(sides.begin(), sides.end());
    return std::all_of(segments.begin(), segments.end(), [&](const auto& segment) {
      return std::binary_search(sides.begin(), sides.end(), segment);
    });
  }

  /// The sides that belong to only one triangle of the region, with straight runs joined. None if
  /// they do not form closed loops.
  std::optional<Segments> outline_of(const Triangles& region) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const std::uint32_t i : region)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = soup_.triangles[i][k], b = soup_.triangles[i][(k + 1) % 3];
        if (const auto back = sides.find({b, a}); back != sides.end()) {
          if (--back->second == 0) sides.erase(back);
        } else {
          ++sides[{a, b}];
        }
      }
    std::map<std::uint32_t, std::vector<std::uint32_t>> next;
    std::map<std::uint32_t, int> arriving;
    for (const auto& [side, times] : sides) {
      if (times != 1) return std::nullopt;
      next[side.first].push_back(side.second);
      ++arriving[side.second];
    }
    // A vertex at which the outline meets itself ends every run.
    const auto is_fixed = [&](std::uint32_t v) {
      return next.at(v).size() != 1 || arriving.at(v) != 1;
    };
    Segments out;
    std::map<std::uint32_t, bool> used;
    const auto follow = [&](std::uint32_t start, std::uint32_t second) {
      std::vector<std::uint32_t> run{start, second};
      while (run.back() != start && !is_fixed(run.back())) {
        used[run.back()] = true;
        run.push_back(next.at(run.back())[0]);
      }
      add_straight(run, out);
    };
    for (const auto& [v, ends] : next) {
      if (!arriving.contains(v)) return std::nullopt;
      if (is_fixed(v))
        for (const std::uint32_t to : ends) follow(v, to);
    }
    for (const auto& [v, ends] : next) {
      if (is_fixed(v) || used[v]) continue;
      const std::uint32_t corner = sharp_corner(v, next);
      used[corner] = true;
      follow(corner, next.at(corner)[0]);
    }
    return out;
  }

  /// A vertex of the loop through v that is certainly a corner: the one farthest from the mean.
  std::uint32_t sharp_corner(
      std::uint32_t v, const std::map<std::uint32_t, std::vector<std::uint32_t>>& next) const {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::uint32_t w = v; count == 0 || w != v; w = next.at(w)[0])
      sum += soup_.vertices[w], count += 1;
    const Vec3 middle = sum / count;
    std::uint32_t best = v;
    for (std::uint32_t w = next.at(v)[0]; w != v; w = next.at(w)[0])
      if ((soup_.vertices[w] - middle).squaredNorm() >
          (soup_.vertices[best] - middle).squaredNorm())
        best = w;
    return best;
  }

  /// Replaces a run of vertices by the fewest segments that contain all of them.
  void add_straight(const std::vector<std::uint32_t>& run, Segments& out) const {
    for (std::size_t from = 0; from + 1 < run.size();) {
      // With strides that grow and then shrink: a straight run may have very many vertices.
      std::size_t to = from + 1, stride = 1;
      const auto may_go = [&] {
        return to + stride < run.size() && is_straight(run, from, to + stride);
      };
      for (; may_go(); stride *= 2) to += stride;
      for (; stride > 0; stride /= 2)
        if (may_go()) to += stride;
      out.emplace_back(run[from], run[to]);
      from = to;
    }
  }
  bool is_straight(const std::vector<std::uint32_t>& run, std::size_t from, std::size_t to) const {
    const Vec3 a = soup_.vertices[run[from]], way = soup_.vertices[run[to]] - a;
    const double length = way.norm();
    if (!(length > 0)) return false;
    const Vec3 along = way / length;
    double before = 0;
    for (std::size_t k = from + 1; k <= to; ++k) {
      const Vec3 x = soup_.vertices[run[k]] - a;
      const double so_far = along.dot(x);
      if (so_far <= before || (x - so_far * along).norm() > flatness_) return false;
      before = so_far;
    }
    return true;
  }

  const Soup& soup_;
  double flatness_;
  std::vector<bool> dropped_, done_;
  Neighbours neighbours_;
  Facets out_;
};

}  // namespace

double rounding_flatness(const Soup& soup) {
  if (soup.vertices.empty()) return 0;
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::min(64 * std::numeric_limits<double>::epsilon() * farthest,
                  1e-11 * box.sizes().maxCoeff());
}

Facets merge_flat(const Soup& soup, double flatness, bool solid, const Progress& progress) {
  return Merger(soup, flatness).run(solid, progress);
}

}  // namespace sonde
