// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/penetration/bound/bound_tuning.hpp"
#include "engine/penetration/bound/surface_patch.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// Share of a body's extent: the flat parts of surface(body) are as near to its mesh
/// (rounding_flatness).
constexpr double flatness = 1e-11;
/// Share of the reach by which a curve is moved off a surface; the bound loses as much.
constexpr double shift = 1e-7;

/// µs for each triangle of a mesh that is looked through.
constexpr double us_to_scan = 0.01;

/// Two triangles that meet, and a point of the segment that they share, at first its middle; in F.
struct Meet {
  Vec3 normal_probe, normal_fixed;  // unit
  Vec3 at;
  Vec3 along;   // unit: of the segment
  double half;  // m: of its length
};

/// The part of segment p, q that is on the inner side of a triangle's three sides.
bool clip(Vec3& p, Vec3& q, const Corners& t, const Vec3& normal) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 in = normal.cross(t[(k + 1) % 3] - t[k]);
    const double hp = in.dot(p - t[k]), hq = in.dot(q - t[k]);
    if (hp < 0 && hq < 0) return false;
    if (hp < 0) p += hp / (hp - hq) * (q - p);
    if (hq < 0) q += hq / (hq - hp) * (p - q);
  }
  return true;
}

/// Where two triangles meet across each other; no value if one lies in the other's plane.
std::optional<Meet> meet(const Corners& a, const Corners& b) {
  const Vec3 of_a = (a[1] - a[0]).cross(a[2] - a[0]), normal = (b[1] - b[0]).cross(b[2] - b[0]);
  std::array<Vec3, 2> ends;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &u = a[k], &v = a[(k + 1) % 3];
    const double hu = normal.dot(u - b[0]), hv = normal.dot(v - b[0]);
    if ((hu > 0) != (hv > 0) && count < 2) ends[count++] = u + hu / (hu - hv) * (v - u);
  }
  if (count < 2 || !clip(ends[0], ends[1], b, normal)) return std::nullopt;
  const double length = (ends[1] - ends[0]).norm();
  if (!(length > 0)) return std::nullopt;
  return Meet{of_a.normalized(), normal.normalized(), (ends[0] + ends[1]) / 2,
              (ends[1] - ends[0]) / length, length / 2};
}

std::vector<Meet> meets(const Placement& at) {
  std::vector<Meet> out;
  PairStack<SlotPair> stack;
  SlotPairs found;
  stack.push(at.roots());
  for (int opened = 0; !stack.empty() && opened < bound_tuning.most_opened &&
                       out.size() < bound_tuning.most_meets;) {
    const SlotPair p = stack.pop();
    if (at.is_leaf(p)) {
      if (const auto m = meet(at.corners_a(at.triangle_a(p)), at.corners_b(at.triangle_b(p))))
        out.push_back(*m);
      continue;
    }
    ++opened;
    at.open_overlapping(p, Opening::larger, found);
    for (const SlotPair& child : found) stack.push(child);
  }
  return out;
}

/// The point of a segment that is nearest to x, but none of its ends: these lie on sides of the
/// triangles, where rounding leaves it open what a curve pierces.
Meet moved_towards(const Vec3& x, Meet m) {
  const double most = bound_tuning.off_the_ends * m.half;
  m.at += std::clamp(m.along.dot(x - m.at), -most, most) * m.along;
  return m;
}

/// Some of the places: that nearest to the middle of all shared segments, then each the furthest
/// from those before.
std::vector<Meet> spread(const std::vector<Meet>& all, std::size_t most) {
  std::vector<Meet> out;
  if (all.empty()) return out;
  Vec3 middle = Vec3::Zero();
  double length = 0;
  for (const Meet& m : all) middle += m.half * m.at, length += m.half;
  middle /= length;
  std::vector<double> away;
  std::size_t next = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    away.push_back(infinity);
    if ((all[i].at - middle).squaredNorm() < (all[next].at - middle).squaredNorm()) next = i;
  }
  while (out.size() < std::min(most, all.size())) {
    out.push_back(out.empty() ? moved_towards(middle, all[next]) : all[next]);
    for (std::size_t i = 0; i < all.size(); ++i)
      away[i] = std::min(away[i], (all[i].at - out.back().at).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(away.begin(), away.end()) - away.begin());
    if (!(away[next] > 0)) break;
  }
  return out;
}

/// Divides a curve that begins at a place into pieces of at most `length`. The place itself is no
/// end of a piece: the first piece extends beyond it, since an end there would lie on the patch.
std::vector<Vec3> divided(const std::vector<Vec3>& points, double length) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 step = points[i + 1] - points[i];
    const int parts = 1 + static_cast<int>(step.norm() / length);
    for (int k = 1; k <= parts; ++k)
      out.push_back(points[i] + (i == 0 ? k - 0.5 : k) / parts * step);
    if (i == 0) out.push_back(points[1]);
  }
  return out;
}

double length_of(const std::vector<Vec3>& points) {
  double out = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) out += (points[i + 1] - points[i]).norm();
  return out;
}

/// A part of a curve that ends at one of its points, from the place's piece outwards.
struct Part {
  double to_patch;  // m, of the end
  double border;    // m, from the whole part
  double price;     // the largest of its points
  bool odd;         // how often it pierces the patch
};

class Search {
 public:
  Search(const Body& probe, const Body& fixed, const Transform& X_FM, const CrossingSearch& options)
      : probe_(probe),
        fixed_(fixed),
        at_(probe, fixed, X_FM),
        options_(options),
        guard_(4 * at_.guard + flatness * (extent(probe) + extent(fixed))),
        shift_(std::max(shift * options.reach, 100 * guard_) * Vec3(0.41, 0.72, 0.56)) {
    best_.bound = options.beat;
  }

  Crossing run() {
    if (is_over()) return {};
    const std::vector<Meet> all = meets(at_);
    for (const Meet& m : spread(all, bound_tuning.most_crossings)) {
      if (is_over(us_to_look())) break;
      about(m);
    }
    return best_.depth > 0 ? best_ : Crossing{};
  }

 private:
  bool is_over(double ahead = 0) const {
    return work_ > options_.work || options_.deadline.passed(ahead);
  }
  /// About what it takes to look for the triangles about a place.
  double us_to_look() const {
    double out = 0;
    for (const Body* body : {&probe_, &fixed_})
      if (scans_mesh(*body)) out += us_to_scan * static_cast<double>(body->soup.triangles.size());
    return out;
  }

  /// Both ways: a curve on the probe through a patch of the fixed body, and the other way round.
  void about(const Meet& m) {
    const LocalSurface probe = local_surface(probe_, at_.X, m.at, options_.reach,
                                             bound_tuning.most_local_triangles, work_),
                       fixed = local_surface(fixed_, Transform(), m.at, options_.reach,
                                             bound_tuning.most_local_triangles, work_);
    const std::uint32_t on_probe = probe.about(m.at, m.normal_probe, guard_),
                        on_fixed = fixed.about(m.at, m.normal_fixed, guard_);
    if (on_probe == LocalSurface::none || on_fixed == LocalSurface::none) return;
    curves(probe, on_probe, fixed, on_fixed, m);
    curves(fixed, on_fixed, probe, on_probe, m);
  }

  void curves(const LocalSurface& curved, std::uint32_t on, const LocalSurface& patched,
              std::uint32_t seed, const Meet& m) {
    const Corners t = curved.at(on);
    const Vec3 normal = area_normal(t).normalized();
    const SurfacePatch patch = patch_about(patched, seed, bound_tuning.least_cosine_of_patch);
    for (const double slope : bound_tuning.slopes_of_cuts) {
      if (is_over()) return;
      // The plane across the line in which the triangles meet, turned about the triangle's normal.
      const Vec3 across = m.along + slope * normal.cross(m.along);
      const auto cut = plane_cut(curved, on, m.at, across, bound_tuning.most_local_triangles);
      if (cut) take(*cut, patch, m);
    }
  }

  /// The part of the curve about the place that proves most.
  void take(const PlaneCut& cut, const SurfacePatch& patch, const Meet& m) {
    const double length =
        std::max(options_.reach / bound_tuning.pieces_of_reach,
                 (length_of(cut.ahead) + length_of(cut.behind)) / bound_tuning.most_pieces);
    const std::vector<Vec3> to = beside(divided(cut.ahead, length)),
                            from = beside(divided(cut.behind, length));
    Part middle{0, border(patch, from.front(), to.front()), 1, false};
    const auto through = pierced(patch, from.front(), to.front());
    if (!through || !is_worth(middle.border, 1)) return;
    middle.odd = *through;
    const std::vector<Part> ahead = parts(to, patch, m, middle);
    if (ahead.empty()) return;
    middle.odd = false;
    const std::vector<Part> behind = parts(from, patch, m, middle);
    for (const Part& a : ahead)
      for (const Part& b : behind)
        if (a.odd != b.odd)
          offer(std::min({a.to_patch, b.to_patch, a.border, b.border}), std::max(a.price, b.price),
                m);
  }

  /// A curve often runs exactly through edges of the patch, as where both bodies are symmetric. One
  /// beside it pierces the faces.
  std::vector<Vec3> beside(std::vector<Vec3> points) const {
    for (Vec3& x : points) x += shift_;
    return points;
  }

  /// Tries the parts of the curve that end at each of its points, as long as they may prove more
  /// than the best so far.
  std::vector<Part> parts(const std::vector<Vec3>& points, const SurfacePatch& patch, const Meet& m,
                          Part part) {
    std::vector<Part> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& x = points[i];
      part.price = std::max(part.price, options_.price(x));
      if (i > 0) {
        part.border = std::min(part.border, border(patch, points[i - 1], x));
        if (!is_worth(part.border, part.price)) break;
        const auto through = pierced(patch, points[i - 1], x);
        if (!through) break;
        part.odd = part.odd != *through;
      }
      // The place is on the patch.
      if (!is_worth((x - m.at).norm(), part.price)) continue;
      part.to_patch = patch.triangles.distance({x, x, x}, work_);
      out.push_back(part);
    }
    return out;
  }
  double border(const SurfacePatch& patch, const Vec3& from, const Vec3& to) {
    return patch.border.distance({from, to, to}, work_);
  }
  /// Whether a piece pierces the patch an odd number of times; no value if rounding leaves it open.
  std::optional<bool> pierced(const SurfacePatch& patch, const Vec3& from, const Vec3& to) {
    const auto count = patch.triangles.pierced(from, to, guard_, work_);
    if (!count) return std::nullopt;
    return *count % 2 == 1;
  }

  bool is_worth(double depth, double price) const { return depth > best_.bound * std::sqrt(price); }
  void offer(double depth, double price, const Meet& m) {
    depth = (depth - 2 * guard_ - shift_.norm()) * (1 - 1e-12);
    if (!(depth > 0) || !std::isfinite(depth)) return;
    const double bound = depth / std::sqrt(price) * (1 - 1e-12);
    if (bound > best_.bound) best_ = {m.at, depth, bound};
  }

  const Body& probe_;
  const Body& fixed_;
  Placement at_;
  const CrossingSearch& options_;
  double guard_;  // m: distance of a curve from surface(body)
  Vec3 shift_;    // m
  std::int64_t work_ = 0;
  Crossing best_;
};

}  // namespace

Crossing best_crossing(const Body& probe, const Body& fixed, const Transform& X_FM,
                       const CrossingSearch& search) {
  return Search(probe, fixed, X_FM, search).run();
}

}  // namespace sonde
