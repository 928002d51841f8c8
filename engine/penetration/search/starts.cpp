// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {
namespace {

/// The starts of a random round that are not near known ends.
constexpr std::size_t far_starts = 3;

/// In estimated errors of the sketches: gaps to which they are moved apart, one after the other,
/// until the bodies are free. If no pose is free, the bodies are pushed apart.
constexpr double apart[] = {0, 0.5, 1, 2, 4};

/// Number of spins that least_overlap() compares at most, 3.75 degrees apart. Two solids of like
/// size need some 40 for steps of two cells; a large surface about a small solid would need any
/// number, and its best spin may then lie between two.
constexpr double most_turns = 96;

}  // namespace

Starts::Starts(const Pair& pair, const Chart& chart, const Deadline& before,
               const SearchTuning& tuning)
    : probe_(pair.probe()),
      fixed_(pair.fixed()),
      chart_(chart),
      before_(before),
      tuned_(tuning),
      lanes_{SearchWorker(probe_, fixed_, tuning), SearchWorker(probe_, fixed_, tuning)} {
  const Sketches& sketches = pair.sketches();
  if (!sketches) return;
  for (std::size_t k = 0; k < lanes_.size(); ++k)
    sketch_descents_.emplace_back(*sketches.probe, *sketches.fixed, fixed_.mass);
}

int Starts::limited() const {
  int out = 0;
  for (const SearchWorker& lane : lanes_) out += lane.limited();
  return out;
}

void Starts::time_phases() noexcept {
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    lanes_[k].time_into(&times_[k]);
    if (!sketch_descents_.empty()) sketch_descents_[k].time_into(&times_[k]);
  }
}

PhaseTimes Starts::phases() const {
  PhaseTimes out = times_[0];
  return out += times_[1];
}

std::optional<Vec6> Starts::free_sample(Random& random, const Vec6& center, double radius,
                                        Method method, std::size_t lane) {
  return lanes_[lane].free_sample(chart_, random, center, radius, method, before_,
                                  sketch_descents_.empty() ? nullptr : &sketch_descents_[lane]);
}

LocalOptimum Starts::descend_from_nearest_free(Random random, const Aim& aim, std::size_t lane) {
  SearchWorker& in = lanes_[lane];
  for (double radius = in.smallest_free_radius; radius < tuned_.largest_ball * probe_.mass.radius;
       radius *= tuned_.ball_growth)
    if (const auto y = free_sample(random, Vec6::Zero(), radius, aim.method, lane)) {
      in.smallest_free_radius = std::max(in.smallest_ball(), y->norm() / 2);
      return in.descend(chart_, *y, aim.method, limits(aim, y->norm()));
    }
  return {};
}

LocalOptimum Starts::descend_from_sketch_end(const SketchEnd& end, const Aim& aim,
                                             std::size_t lane) {
  const auto y = freed(end.y, aim.method, lane);
  return y ? lanes_[lane].descend_exactly(chart_, *y, aim.method, limits(aim)) : LocalOptimum{};
}

LocalOptimum Starts::descend_beyond_sketch_end(const SketchEnd& end, const Aim& aim,
                                               std::size_t lane) {
  const auto y = first_free_beyond(end.y, aim.method, lane);
  return y ? lanes_[lane].descend_exactly(chart_, *y, aim.method, limits(aim)) : LocalOptimum{};
}

std::optional<Vec6> Starts::first_free_beyond(const Vec6& end, Method method,
                                              std::size_t lane) const {
  double beyond = tuned_.same;
  for (int tries = 0; tries < 5; ++tries, beyond *= 3)
    if (const Vec6 y = (1 + beyond) * end; chart_.v(y).norm() < descent_tuning.largest_start_v &&
                                           lanes_[lane].leaps(method).is_free(chart_, y))
      return y;
  return std::nullopt;
}

/// A free pose near an end on the sketches: found by moving the sketches further apart, or by
/// pushing the bodies apart.
std::optional<Vec6> Starts::freed(const Vec6& end, Method method, std::size_t lane) {
  SketchDescent& sketches = sketch_descents_[lane];
  Vec6 y = end;
  for (const double gap : apart) {
    if (gap > 0)
      y = sketches
              .run(chart_, y,
                   {.method = method,
                    .margin = gap * tuned_.sketch_error * sketches.spacing(),
                    .steps = tuned_.descent_steps})
              .y;
    if (lanes_[lane].leaps(method).is_free(chart_, y)) return y;
  }
  // With little time, the few tests that surely find a pose come first.
  if (before_.microseconds > 0)
    if (auto out = first_free_beyond(end, method, lane)) return out;
  return lanes_[lane].push(method).from(chart_, end, std::numeric_limits<double>::infinity(),
                                        before_);
}

LocalOptimum Starts::push_apart_and_descend(const Vec6& y, const Aim& aim, std::size_t lane) {
  const auto free =
      lanes_[lane].push(aim.method).from(chart_, y, tuned_.rough_error * aim.beat, before_);
  LocalOptimum out;
  if (free && !(aim.known && aim.known->is_known(*free, tuned_.same_place)))
    out = lanes_[lane].descend_exactly(chart_, *free, aim.method, limits(aim));
  out.starts = 0;  // not independent: they all begin near the device pose
  return out;
}

LocalOptimum Starts::push_apart_within(double radius, Random& random, const Aim& aim,
                                       std::size_t lane) {
  return push_apart_and_descend(lanes_[lane].sample(random, radius, aim.method), aim, lane);
}

LocalOptimum Starts::push_least_overlap_apart(double radius, Random& random, const Aim& aim,
                                              std::size_t lane) {
  Vec6 best = Vec6::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tuned_.tries_in_a_ball; ++i) {
    const Vec6 y = lanes_[lane].sample(random, radius, Method::pdt);
    if (const double depth = sketch_descents_[lane].depth_of_points(chart_, y); depth < least)
      least = depth, best = y;
  }
  return push_apart_and_descend(best, aim, lane);
}

std::optional<Fit> Starts::fitted(Random& random, double farthest, std::size_t lane) {
  const MassProperties &probe = probe_.mass, &fixed = fixed_.mass;
  const Pose& device = chart_.device();
  const auto axis_of = [&](const Mat3& axes) {
    const Vec3 axis = axes.col(std::min(2, static_cast<int>(random.uniform(0, 3))));
    return Vec3(random.uniform(0, 1) < 0.5 ? -axis : axis);
  };
  const double cell = sketch_descents_.empty() ? 0 : sketch_descents_[lane].spacing();
  for (int tries = 0; tries < tuned_.tries_in_a_ball && !before_.passed(); ++tries) {
    const Vec3 axis = axis_of(fixed.R_MP), own = device.q * axis_of(probe.R_MP);
    const Quat upright = Quat::FromTwoVectors(own, axis) * device.q;
    const double spin = random.uniform(-1, 1) * std::numbers::pi;
    const Vec3 centre = fixed.com + random.uniform(-1, 1) * fixed.radius * axis;
    // No spin, and no shift of one and a half cells in two directions, brings it near enough.
    if ((centre - chart_.com()).norm() >= farthest + 3 * cell) continue;
    const Vec3 aside = axis.unitOrthogonal(), beside = axis.cross(aside);
    const auto placed = [&](const Vec3& by) -> std::optional<Vec6> {
      const Quat q = (rotation_about(axis, spin + by[0] / probe.radius) * upright).normalized();
      const Vec6 y =
          chart_.coordinates({q, centre + by[1] * aside + by[2] * beside - q * probe.com});
      if (chart_.v(y).norm() < descent_tuning.largest_start_v && y.norm() < farthest) return y;
      return std::nullopt;
    };
    if (sketch_descents_.empty()) {
      if (const auto y = placed(Vec3::Zero())) return Fit{*y, 0};
    } else if (auto fit = least_overlap(placed, lane)) {
      return fit;
    }
  }
  return std::nullopt;
}

std::optional<Fit> Starts::least_overlap(
    const std::function<std::optional<Vec6>(const Vec3&)>& placed, std::size_t lane) {
  SketchDescent& sketches = sketch_descents_[lane];
  std::optional<Fit> best;
  Vec3 at = Vec3::Zero();
  const auto look = [&](const Vec3& by) {
    const auto y = placed(by);
    if (!y) return;
    const double overlap = sketches.depth_of_points(chart_, *y);
    if (!best || overlap < best->overlap) best = Fit{*y, overlap}, at = by;
  };
  const double cell = sketches.spacing();
  const double round = 2 * std::numbers::pi * probe_.mass.radius;
  const double turns = std::clamp(std::ceil(round / (2 * cell)), 1.0, most_turns);
  for (double k = 0; k < turns && !before_.passed(); ++k) look({k * round / turns, 0, 0});
  if (!best) return best;
  for (const double step : {cell, cell / 2})
    for (int k = 0; k < 3; ++k) {
      const Vec3 middle = at;
      look(middle - step * Vec3::Unit(k));
      look(middle + step * Vec3::Unit(k));
    }
  return best;
}

LocalOptimum Starts::descend_from_ball(Random random, const Aim& aim, std::size_t lane) {
  const double width = random.uniform(tuned_.least_ball, tuned_.farthest_ball) * aim.beat;
  std::optional<Vec6> y;
  for (double grown = 1; !y && grown < tuned_.largest_ball && !before_.passed();
       grown *= tuned_.ball_growth)
    y = free_sample(random, Vec6::Zero(), grown * width, aim.method, lane);
  return y ? lanes_[lane].descend(chart_, *y, aim.method, limits(aim)) : LocalOptimum{};
}

LocalOptimum Starts::descend_near_end(const Vec6& end, Random random, const Aim& aim,
                                      std::size_t lane) {
  const double part = random.uniform(0, 1),
               radius = aim.beat *
                        (tuned_.same_place + (tuned_.end_ball - tuned_.same_place) * part * part);
  const auto y = free_sample(random, end, radius, aim.method, lane);
  LocalOptimum out = y ? lanes_[lane].descend(chart_, *y, aim.method, limits(aim)) : LocalOptimum{};
  out.starts = 0;
  return out;
}

LocalOptimum Starts::descend_in_round(std::size_t turn, std::size_t k,
                                      const std::vector<Vec6>& ends, Random random, const Aim& aim,
                                      std::size_t lane) {
  if (k >= far_starts)
    return descend_near_end(ends[(turn * (per_round - far_starts) + k) % ends.size()], random, aim,
                            lane);
  const auto independent = [](LocalOptimum out) {
    out.starts = 1;
    return out;
  };
  const bool may_fit = aim.method == Method::pdg && !sketch_descents_.empty();
  if (may_fit && k > 0)
    if (const auto fit = fitted(random, tuned_.farthest_overlap * aim.beat, lane))
      return independent(push_apart_and_descend(fit->y, aim, lane));
  if (probe_.solid && fixed_.solid && turn % 2 == 0) {
    const double radius = random.uniform(tuned_.same_place, tuned_.farthest_overlap) * aim.beat;
    return independent(push_apart_within(radius, random, aim, lane));
  }
  return descend_from_ball(random, aim, lane);
}

LocalOptimum Starts::descend_from_outside(std::size_t k, const Aim& aim, std::size_t lane) {
  const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
  const Vec3 offset = chart_.com() - center;
  const double half = (fixed_.tree.high - center).norm();
  const double away = 1.01 * (offset.norm() + half + probe_.mass.radius);
  const auto axis = static_cast<int>(k / 2) - 1;
  Vec3 way = axis < 0 ? offset : Vec3(fixed_.mass.R_MP.col(axis));
  if (k % 2 == 1) way = -way;
  if (!(way.norm() > 0)) way = Vec3::Ones();
  Vec6 y = Vec6::Zero();
  y.tail<3>() = away * way.normalized();
  y = lanes_[lane].leaps(Method::pdt).pull_in(chart_, y);
  return lanes_[lane].descend(chart_, y, Method::pdt, limits(aim));
}

}  // namespace sonde
