// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/error.hpp"
#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupler.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {
namespace {

/// The turn between two poses of a way must be well below half a turn, so that the shorter way is
/// unambiguous.
constexpr double largest_turn = 0.5 * std::numbers::pi;
constexpr double most_twist = 1e6;
/// Probe's radii. On a longer way the rounding of places comes near the room at which bodies touch,
/// and rows are so far apart that none of them is at the fixed body.
constexpr double most_travel = 1e6;
/// Share of a step: the distance of the nearest row of a table from the first contact.
constexpr double finest = 1e-3;

InputError refused(const std::string& reason) { return InputError::in("the way", reason); }

Vec3 com_at(const Pair& pair, const Pose& X) { return X * pair.probe().mass.com; }

/// The position of a travel in the way's list: the index of the pose before it, and the fraction of
/// the way to the next pose.
struct Place {
  std::size_t pose;
  double part;
};
Place place_of(const InsertionPath& way, double travel) {
  const auto after = std::ranges::upper_bound(way.travel, travel);
  const auto last = std::ssize(way.travel) - 1;
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - way.travel.begin() - 1, 0, last - 1));
  const double length = way.travel[i + 1] - way.travel[i];
  return {i, length > 0 ? std::clamp((travel - way.travel[i]) / length, 0.0, 1.0) : 0};
}

/// The rows of the table: at even steps, and ever closer ones about the first contact.
std::vector<double> rows_of(const InsertionPath& way, std::size_t steps,
                            const std::optional<FirstContact>& first) {
  const double all = way.travel.back(), step = all / static_cast<double>(steps);
  std::vector<double> out;
  for (std::size_t i = 0; i <= steps; ++i) out.push_back(step * static_cast<double>(i));
  out.back() = all;
  if (!first) return out;
  out.push_back(first->travel);
  for (double off = 0.5 * step; off >= finest * step; off *= 0.5)
    for (const double at : {first->travel - off, first->travel + off})
      if (at > 0 && at < all) out.push_back(at);
  ordering::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// The least room of a table's rows, which is that of a way that is blocked.
LeastRoom room_of(const Insertion& found) {
  LeastRoom out;
  for (const InsertionStep& step : found.steps) {
    if (step.clearance.overlapping || !(step.clearance.distance < out.clearance)) continue;
    out.clearance = step.clearance.distance;
    out.travel = step.travel;
    out.X_FM = step.X_FM;
  }
  if (!found.first) return out;
  out.tolerance = out.clearance;
  out.searched = found.first->travel;
  out.complete = true;
  return out;
}

}  // namespace

InsertionPath way_along(const Pair& pair, const Pose& start, const Vec3& axis, double travel,
                        double twist) {
  if (!axis.allFinite() || !std::isfinite(travel) || !std::isfinite(twist))
    throw refused("a number is not finite");
  const Vec3 unit = axis.stableNormalized();
  if (!(unit.squaredNorm() > 0.5)) throw refused("the axis has no length");
  if (!(travel > 0)) throw refused("the travel must be positive");
  if (travel > most_travel * pair.probe().mass.radius)
    throw refused("is over a million times as long as the probe is large");
  if (std::abs(twist) > most_twist) throw refused("the twist is beyond a million radians");
  const auto pieces =
      static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(twist) / largest_turn)));
  InsertionPath out;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(pieces);
    const Quat q = (rotation_about(unit, part * twist) * start.q).normalized();
    const Vec3 com = com_at(pair, start) + part * travel * unit;
    out.poses.push_back({q, com - q * pair.probe().mass.com});
    out.travel.push_back(part * travel);
  }
  return out;
}

InsertionPath way_through(const Pair& pair, const std::vector<Pose>& poses) {
  if (poses.size() < 2) throw refused("holds less than two poses");
  InsertionPath out{poses, {0}};
  for (std::size_t i = 1; i < poses.size(); ++i)
    out.travel.push_back(out.travel.back() +
                         (com_at(pair, poses[i]) - com_at(pair, poses[i - 1])).norm());
  if (!(out.travel.back() > 0)) throw refused("has no length");
  return out;
}

Pose pose_at(const InsertionPath& way, const Pair& pair, double travel) {
  const auto [i, part] = place_of(way, travel);
  if (part <= 0) return way.poses[i];
  if (part >= 1) return way.poses[i + 1];
  return Motion(pair.probe().mass, way.poses[i], way.poses[i + 1]).pose_at(part);
}

Insertion insertion(const Pair& pair, const InsertionPath& way, std::size_t steps,
                    const Coupling& coupling, const Progress& progress, std::int64_t work) {
  constexpr double sweeps = 0.2, table = 0.7;  // of the time: up to their ends
  Insertion out;
  out.first = first_contact(pair, way, part_of(progress, 0, sweeps));
  Coupling unlimited = coupling;
  unlimited.max_force = unlimited.max_torque = std::numeric_limits<double>::max();
  unlimited.b_t = unlimited.b_r = 0;
  Coupler coupler(pair.probe().mass, unlimited);
  CoherentSolver follower(pair);
  follower.reset(way.poses.front());
  const std::vector<double> rows = rows_of(way, std::max<std::size_t>(steps, 1), out.first);
  const Progress of_table = part_of(progress, sweeps, table);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    report(of_table, static_cast<double>(i) / static_cast<double>(rows.size()));
    InsertionStep step;
    step.travel = rows[i];
    step.X_FM = pose_at(way, pair, rows[i]);
    step.clearance = distance(pair, step.X_FM);
    // Up to the first contact the way is known to be free: there the probe is at the way's pose.
    const bool is_free = !out.first || rows[i] <= out.first->travel;
    step.held = is_free ? follower.reset(step.X_FM) : follower.tick(step.X_FM);
    step.wrench = coupler.wrench(step.held, 0);
    out.steps.push_back(step);
  }
  out.room = room_of(out);
  if (!out.first) out.room = least_room(pair, way, out.room, work, part_of(progress, table, 1));
  return out;
}

}  // namespace sonde
