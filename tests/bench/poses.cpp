// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/poses.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/bench/meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::bench {
namespace {

constexpr double R = mesh_radius;
constexpr double degree = std::numbers::pi / 180;
constexpr double far_start = 4.1 * R;  // two bounding balls more than 2 R apart
constexpr double trip_length = 6 * R;  // from there, past B
constexpr double trip_turn = 60 * degree;
constexpr double link_tilt = 20 * degree;  // so little that linked rings cannot meet by it
constexpr double step_turn = 0.1 * degree;
constexpr std::array apart = {Place::far, Place::near_5, Place::near_1, Place::touching};
constexpr std::array meeting = {Place::shallow, Place::deep};

double gap_of(Place place) {
  switch (place) {
    case Place::far:
      return 2 * R;
    case Place::near_5:
      return 0.05 * R;
    case Place::near_1:
    case Place::trajectory:
      return 0.01 * R;
    case Place::touching:
      return 1e-6 * R;
    case Place::shallow:
      return -0.01 * R;
    case Place::deep:
      return -0.3 * R;
    case Place::trip:
    case Place::none:
      break;
  }
  return 0;
}

Quat turn(const Vec3& axis, double angle) { return Quat(Eigen::AngleAxisd(angle, axis)); }

Vec3 random_direction(std::mt19937_64& random) {
  return test::random_rotation(random) * Vec3::UnitZ();
}

/// A straight way towards B.
struct Approach {
  Quat q;
  Vec3 start, along;
  Pose at(double t) const { return {q, start + t * along}; }
};

Approach from_outside(std::mt19937_64& random, double aim_off) {
  const Vec3 start = far_start * random_direction(random);
  const Vec3 aim = test::random_in_ball(random, aim_off);
  return {test::random_rotation(random), start, (aim - start).normalized()};
}

Approach from_link(std::mt19937_64& random) {
  const Quat upright = turn(Vec3::UnitX(), 90 * degree);
  const Quat tilt = turn(random_direction(random), link_tilt * test::uniform(random, -1, 1));
  return {(tilt * upright).normalized(), Vec3(ring_middle_radius, 0, 0), random_direction(random)};
}

/// Moves on from t until the gap is as asked, to a hundredth of it. A step by what the gap is too
/// large cannot make it too small. No value: the way leads past B.
class Advance {
 public:
  Advance(const Body& a, const Body& b, const Approach& way) : a_(a), b_(b), way_(way) {}

  std::optional<double> to_gap(double gap, double t) {
    for (int tries = 0; tries < 2000 && t < 2 * far_start; ++tries) {
      const Distance d = triangle_distance(a_, b_, Transform(way_.at(t)), hint_);
      hint_ = {d.triangle_a, d.triangle_b};
      if (d.distance <= 1.01 * gap) return d.distance > 0.5 * gap ? std::optional(t) : std::nullopt;
      t += d.distance - gap;
    }
    return std::nullopt;
  }

 private:
  const Body& a_;
  const Body& b_;
  const Approach& way_;
  DistanceHint hint_;
};

bool meets(const Body& a, const Body& b, const Pose& X) {
  return triangles_meet(a, b, Transform(X), Doubt::exact);
}

/// One pose of each kind along one way; false where one cannot be had.
bool add_poses(const Body& a, const Body& b, bool linked, const Approach& way, PoseSet& out) {
  Advance advance(a, b, way);
  std::map<Place, Pose> found;
  double t = 0;
  for (const Place place : apart) {
    if (linked && place == Place::far) continue;
    const auto reached = advance.to_gap(gap_of(place), t);
    if (!reached) return false;
    t = *reached;
    found[place] = way.at(t);
  }
  for (const Place place : meeting) {
    found[place] = way.at(t - gap_of(place));
    if (!meets(a, b, found[place])) return false;
  }
  for (const auto& [place, pose] : found) out.poses[place].push_back(pose);
  return true;
}

Approach random_approach(std::mt19937_64& random, bool linked, double aim_off) {
  return linked ? from_link(random) : from_outside(random, aim_off);
}

/// The way that the direction and the orientation of another turn into after some steps.
Approach after_steps(const Approach& way, bool linked, const Vec3& axis, int steps) {
  const Quat part = turn(axis, step_turn * steps);
  const Vec3 start = linked ? way.start : part * way.start;
  return {(turn(Vec3(axis.y(), axis.z(), axis.x()), step_turn * steps) * way.q).normalized(), start,
          part * way.along};
}

std::vector<Pose> trajectory(const Body& a, const Body& b, bool linked, int steps,
                             std::mt19937_64& random) {
  const Approach way = random_approach(random, linked, 0.3 * R);
  const Vec3 axis = random_direction(random);
  std::vector<Pose> out;
  // Where a turned way leads past B, the step is left out; a bad beginning gives up sooner.
  for (int i = 0; static_cast<int>(out.size()) < steps && i < 2 * steps; ++i) {
    const Approach turned = after_steps(way, linked, axis, i);
    const auto t = Advance(a, b, turned).to_gap(gap_of(Place::trajectory), 0);
    if (t) out.push_back(turned.at(*t));
  }
  return out;
}

Trip random_trip(std::mt19937_64& random, bool linked) {
  const Approach way = random_approach(random, linked, R);
  const Quat end = turn(random_direction(random), trip_turn) * way.q;
  return {way.at(0), {end.normalized(), way.at(trip_length).p}};
}

}  // namespace

const char* name_of(Place place) {
  switch (place) {
    case Place::far:
      return "far";
    case Place::near_5:
      return "near-5%";
    case Place::near_1:
      return "near-1%";
    case Place::touching:
      return "touching";
    case Place::shallow:
      return "shallow";
    case Place::deep:
      return "deep";
    case Place::trajectory:
      return "trajectory";
    case Place::trip:
      return "trip";
    case Place::none:
      break;
  }
  return "-";
}

double from_touching(Place place) { return std::abs(gap_of(place)); }

PoseSet make_poses(const Body& a, const Body& b, bool linked, const PoseCounts& counts,
                   std::uint64_t seed) {
  // Generators of their own: a pair with fewer poses has the same trajectory and the same trips.
  std::mt19937_64 random(seed), random_steps(seed + 1), random_trips(seed + 2);
  PoseSet out;
  for (int found = 0, tries = 0; found < counts.poses; ++tries) {
    if (tries > 100 * counts.poses) throw std::runtime_error("no poses were found for a pair");
    found += add_poses(a, b, linked, random_approach(random, linked, 0.3 * R), out);
  }
  std::vector<Pose> steps;
  for (int tries = 0; static_cast<int>(steps.size()) <= counts.steps; ++tries) {
    if (tries > 100) throw std::runtime_error("no trajectory was found for a pair");
    steps = trajectory(a, b, linked, counts.steps + 1, random_steps);
  }
  out.lead_in = steps.front();
  out.poses[Place::trajectory].assign(steps.begin() + 1, steps.end());
  while (static_cast<int>(out.trips.size()) < counts.trips) {
    const Trip trip = random_trip(random_trips, linked);
    if (!meets(a, b, trip.from)) out.trips.push_back(trip);
  }
  return out;
}

}  // namespace sonde::bench
