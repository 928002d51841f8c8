// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/separate_within.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/restricted/nearest_free.hpp"
#include "engine/penetration/restricted/planar_search.hpp"
#include "engine/penetration/search/option_check.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

Vec3 unit(const Vec3& given, const char* what) {
  if (!given.allFinite() || !(given.stableNorm() > 0))
    throw InputError(std::string(what) + " must be finite and of some length");
  return given.stableNormalized();
}

Pose normalized(const Pose& X) { return is_finite(X) ? Pose{X.q.normalized(), X.p} : X; }

/// m: a probe moved this far from X along a line touches nothing.
double far_enough(const Pair& pair, const Pose& X) {
  const auto reach = [](const Body& body) { return (body.tree.high - body.tree.low).norm(); };
  return (X * pair.probe().mass.com - pair.fixed().mass.com).norm() +
         2 * (reach(pair.probe()) + reach(pair.fixed()));
}

/// The only contact at the end of the motion. Its multiplier makes the component of its force along
/// the motion equal to y.
Contact contact_at(const Pair& pair, const Chart& chart, const FirstFree& found) {
  const ClosestPoints points =
      closest_points(place(Transform(found.X_FM), corners(surface(pair.probe()), found.triangle_a)),
                     corners(surface(pair.fixed()), found.triangle_b));
  Contact out{.on_probe = points.a, .on_fixed = points.b, .gap = points.gap};
  if (!(points.distance > 0)) return out;
  out.normal = points.normal;
  const Vec6 y = chart.coordinates(found.X_FM);
  const double along = chart.row(y, points.a, points.normal).dot(y);
  out.multiplier = along > 0 ? y.squaredNorm() / along : 0;
  return out;
}

Separation answer(const Pair& pair, const Pose& device, const FirstFree& found) {
  Chart chart(pair.probe().mass, device);
  chart.absorb_free_spin(found.X_FM);
  Descent::Outcome end;
  end.y = chart.coordinates(found.X_FM);
  end.contacts.push(contact_at(pair, chart, found));
  end.converged = true;
  end.iterations = 1;
  Separation out = make_separation(chart, end);
  out.device = device;
  out.separated = found.X_FM;
  return out;
}

/// The progress of one of several turns of equal length.
Progress turn_of(const Progress& progress, std::size_t turn, std::size_t turns) {
  const auto share = [&](std::size_t n) { return double(n) / double(turns); };
  return progress ? part_of(progress, share(turn), share(turn + 1)) : Progress{};
}

}  // namespace

Separation separate_along(const Pair& pair, const Pose& X_FM, std::span<const Vec3> directions_F,
                          const Progress& progress) {
  const RoundToNearest round_to_nearest;
  if (directions_F.empty()) throw InputError("there are no directions");
  std::vector<Vec3> directions;
  directions.reserve(directions_F.size());
  for (const Vec3& given : directions_F) directions.push_back(unit(given, "a direction"));
  const Pose X = normalized(X_FM);
  if (const auto trivial = trivial_separation(pair.probe(), pair.fixed(), X)) return *trivial;
  std::optional<FirstFree> best;
  double most = far_enough(pair, X);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto found =
        nearest_free(pair.probe(), pair.fixed(), OneDofMotion::along(X, directions[i]), most,
                     turn_of(progress, i, directions.size()));
    if (!found) continue;
    best = found;
    most = found->s;
  }
  return best ? answer(pair, X, *best) : failed(X, "no free pose was found along the directions");
}

Separation separate_about(const Pair& pair, const Pose& X_FM, const Vec3& point_F,
                          const Vec3& axis_F, const Progress& progress) {
  const RoundToNearest round_to_nearest;
  const Vec3 axis = unit(axis_F, "the axis");
  if (!point_F.allFinite()) throw InputError("the point of the axis is not finite");
  const Pose X = normalized(X_FM);
  if (const auto trivial = trivial_separation(pair.probe(), pair.fixed(), X)) return *trivial;
  const OneDofMotion there = OneDofMotion::about(X, point_F, axis);
  std::optional<FirstFree> best;
  double most = std::numbers::pi;
  for (const std::size_t turn : {std::size_t{0}, std::size_t{1}}) {
    const OneDofMotion motion = turn == 0 ? there : there.back();
    const auto found =
        nearest_free(pair.probe(), pair.fixed(), motion, most, turn_of(progress, turn, 2));
    if (!found) continue;
    best = found;
    most = found->s;
  }
  return best ? answer(pair, X, *best) : failed(X, "no turn about the axis sets the probe free");
}

Separation separate_in_plane(const Pair& pair, const Pose& X_FM, const InPlane& motions,
                             const StaticOptions& options, const Progress& progress) {
  const RoundToNearest round_to_nearest;
  check(options);
  const Vec3 normal = unit(motions.normal_F, "the normal");
  const Pose X = normalized(X_FM);
  if (const auto trivial = trivial_separation(pair.probe(), pair.fixed(), X)) return *trivial;
  return planar_separation(pair, X, normal, motions.turning, options, progress);
}

}  // namespace sonde
