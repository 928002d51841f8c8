// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/push_apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/base/ordering.hpp"
#include "engine/base/phase_timer.hpp"
#include "engine/penetration/contact/separating_axes.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/penetration/descent/push_apart_tuning.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {
namespace {

/// A direction that separates two triangles, and their gap along it.
struct WayOut {
  Vec3 normal = Vec3::UnitZ(), on_probe = Vec3::Zero();
  double gap = -std::numeric_limits<double>::infinity();
};

WayOut way_apart(const Corners& a, const Corners& b) {
  const ClosestPoints p = closest_points(a, b);
  return {p.normal, p.a, p.gap};
}

/// The separating direction that needs the least displacement. The point is the one whose motion
/// changes the gap, which a turn needs: if the face of A is the separating plane, the foot of B's
/// corner and not one of A's, which may be as far away as the triangle is long.
WayOut way_out(const Corners& a, const Corners& b, bool solid_a, bool solid_b) {
  const auto face = [](const Corners& t) { return Vec3(area_normal(t).normalized()); };
  const Vec3 face_a = face(a), face_b = face(b);
  WayOut best;
  const auto look = [&](const Vec3& axis, const auto& point) {
    const double length = axis.norm();
    for (const double side : {1 / length, -1 / length}) {
      const Vec3 n = side * axis;
      if ((solid_b && n.dot(face_b) < -push_apart_tuning.aside) ||
          (solid_a && n.dot(face_a) > push_apart_tuning.aside))
        continue;
      const double gap = gap_along(n, a, b);
      if (!(gap > best.gap)) continue;
      if (const std::optional<Vec3> on_probe = point(n, gap)) best = {n, *on_probe, gap};
    }
  };
  using Point = std::optional<Vec3>;
  if (const Vec3 axis = area_normal(a); axis.squaredNorm() > 0)
    look(axis, [&](const Vec3& n, double gap) -> Point { return lowest_corner(b, -n) + gap * n; });
  if (const Vec3 axis = area_normal(b); axis.squaredNorm() > 0)
    look(axis, [&](const Vec3& n, double) -> Point { return lowest_corner(a, n); });
  any_edges(a, b, [&](const Vec3& axis, std::size_t i, std::size_t j) {
    look(axis,
         [&](const Vec3& n, double gap) { return point_between_edges(a, i, b, j, axis, n, gap); });
    return false;
  });
  return best;
}

}  // namespace

PushApart::PushApart(const Body& probe, const Body& fixed, Method method)
    : probe_(probe), fixed_(fixed), method_(method), found_(push_apart_tuning.most_pairs) {
  rows_.reserve(push_apart_tuning.most_pairs);
  displacements_.reserve(push_apart_tuning.most_pairs);
}

bool PushApart::is_free(const Chart& chart, const Vec6& y) const {
  const PhaseTimer timer(times_, Phase::verify);
  return !overlap(probe_, fixed_, Transform(chart.pose(y)), Doubt::contact);
}

void PushApart::gather(const Chart& here, double margin) {
  const PhaseTimer timer(times_, Phase::look);
  const Transform X(here.device());
  Effort unlimited;
  const std::size_t count = find_violations(probe_, fixed_, X, margin, found_, unlimited);
  rows_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const Corners a = place(X, corners(surface(probe_), found_[i].triangle_a));
    const Corners b = corners(surface(fixed_), found_[i].triangle_b);
    const WayOut way =
        found_[i].gap > 0 ? way_apart(a, b) : way_out(a, b, probe_.solid, fixed_.solid);
    if (!std::isfinite(way.gap)) continue;
    HalfSpace row{here.row(Vec6::Zero(), way.on_probe, way.normal), margin - way.gap};
    if (method_ == Method::pdt) row.normal.head<3>().setZero();
    rows_.push_back({row, 0});
  }
  limit_displacements();
}

/// Two large triangles that just cross at an edge of a solid may be separable only by a long way,
/// since the short one leads into the solid. The rows of their neighbours know the short one.
void PushApart::limit_displacements() {
  if (rows_.empty()) return;
  const auto way = [](const Row& row) {
    return row.half_space.bound / row.half_space.normal.norm();
  };
  displacements_.clear();
  for (const Row& row : rows_) displacements_.push_back(way(row));
  const auto middle =
      displacements_.begin() + static_cast<std::ptrdiff_t>(displacements_.size() / 2);
  ordering::nth_element(displacements_.begin(), middle, displacements_.end(), std::less<>());
  const double most = push_apart_tuning.longest_way * *middle;
  for (Row& row : rows_)
    if (way(row) > most) row.half_space.bound = most * row.half_space.normal.norm();
}

/// y after a step in the chart of the probe's present pose. A step past half a turn comes back into
/// the device's chart from its other side.
Vec6 PushApart::moved(const Chart& chart, const Vec6& y, const Chart& here,
                      const Vec6& step) const {
  if (method_ == Method::pdt) return y + step;  // exactly without a turn
  return chart.coordinates(here.pose(step));
}

/// Projected Gauss-Seidel on the regularised dual: rows that contradict each other are both met in
/// part.
Vec6 PushApart::compromise() {
  const PhaseTimer timer(times_, Phase::solve);
  Vec6 step = Vec6::Zero();
  for (int sweep = 0; sweep < push_apart_tuning.sweeps; ++sweep)
    for (auto& [row, push] : rows_) {
      const double size = row.normal.squaredNorm();
      const double lacking =
          row.bound - row.normal.dot(step) - push_apart_tuning.give * size * push;
      const double next = std::max(0.0, push + lacking / (size * (1 + push_apart_tuning.give)));
      step += (next - push) * row.normal;
      push = next;
    }
  return step;
}

std::optional<Vec6> PushApart::from(const Chart& chart, const Vec6& start, double farthest,
                                    const Deadline& deadline) {
  double margin = push_apart_tuning.margin * chart.mass().radius;
  Vec6 y = start;
  int returns = 0;
  for (int looks = 0; looks < push_apart_tuning.most_looks && !deadline.passed(); ++looks) {
    if (is_free(chart, y)) {
      if (chart.v(y).norm() < descent_tuning.largest_start_v) return y;
      return std::nullopt;
    }
    // In a fit with less room, triangles on both sides contradict each other.
    if (2 * looks > push_apart_tuning.most_looks) margin *= push_apart_tuning.less_margin;
    const Chart here(chart.mass(), chart.pose(y));
    gather(here, margin);
    if (rows_.empty()) return std::nullopt;  // one body is inside the other
    Vec6 step = compromise();
    step *= std::min(1.0, descent_tuning.largest_turn / std::max(here.v(step).norm(), 1e-30));
    y = moved(chart, y, here, step);
    if (y.norm() < farthest) continue;
    if (!(y.norm() > 0) || ++returns > push_apart_tuning.most_returns) return std::nullopt;
    y *= push_apart_tuning.returns_to * farthest / y.norm();
  }
  return std::nullopt;
}

}  // namespace sonde
