// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion_map.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// The i-th of `count` even values from −largest to largest; 0 if there is only one.
double value_of(std::size_t i, std::size_t count, double largest) {
  if (count < 2) return 0;
  return largest * (2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1);
}

void check(const InsertionMap& map) {
  if (map.offsets == 0 || map.tilts == 0) throw InputError("a map has at least one point");
  for (const double range : {map.largest_offset, map.largest_tilt})
    if (!(range >= 0 && std::isfinite(range)))
      throw InputError("the range of offsets and that of tilts must be finite, and 0 or more");
}

}  // namespace

double InsertionMap::offset(std::size_t i) const { return value_of(i, offsets, largest_offset); }

double InsertionMap::tilt(std::size_t j) const { return value_of(j, tilts, largest_tilt); }

Vec3 lateral_to(const Vec3& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vec3 wanted = Vec3::Unit(least);
  return (wanted - axis.dot(wanted) * axis).normalized();
}

std::optional<Vec3> square_to(const Vec3& axis, const Vec3& direction) {
  constexpr double least = 1e-6;  // of the direction: less is the rounding of what was typed
  const Vec3 wanted = direction.stableNormalized();
  const Vec3 square = wanted - axis.dot(wanted) * axis;
  if (!(square.norm() > least)) return std::nullopt;
  return square.normalized();
}

InsertionPath moved(const InsertionPath& way, const Pair& pair, const InsertionMap& map,
                    double offset, double tilt) {
  InsertionPath out = way;
  const Quat turn = rotation_about(map.axis.cross(map.lateral), tilt);
  const Vec3& com = pair.probe().mass.com;
  for (Pose& X : out.poses) {
    const Vec3 at = X * com + offset * map.lateral;
    X.q = (turn * X.q).normalized();
    X.p = at - X.q * com;
  }
  return out;
}

double free_travel(const Pair& pair, const InsertionPath& way, const Progress& progress) {
  if (touch(pair, way.poses.front())) return -1;
  const auto first = first_contact(pair, way, progress);
  return first ? first->travel : way.travel.back();
}

std::vector<double> free_travels(const Pair& pair, const InsertionPath& way,
                                 const InsertionMap& map, unsigned threads,
                                 const Progress& progress) {
  check(map);
  std::vector<double> out(map.offsets * map.tilts);
  double done = 0;  // in points, with what is done of those under way
  std::mutex reporting;
  run_parallel(out.size(), std::max(1u, threads), [&](std::size_t k) {
    const double offset = map.offset(k / map.tilts), tilt = map.tilt(k % map.tilts);
    double of_point = 0;
    const Progress within = [&](double fraction) {
      const std::lock_guard lock(reporting);
      done += fraction - std::exchange(of_point, fraction);
      report(progress, done / static_cast<double>(out.size()));
      return true;
    };
    out[k] = free_travel(pair, moved(way, pair, map, offset, tilt), within);
    within(1);
  });
  return out;
}

}  // namespace sonde
