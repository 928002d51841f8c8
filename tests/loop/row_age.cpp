// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/loop/row_age.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/quantile.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/loop/contact_feed.hpp"
#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {
namespace {

Spread spread(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5), quantile(values, 0.99), values.back()};
}

/// The path at a time of its own, between its poses by a straight line and one turn.
Pose pose_at(std::span<const TimedPose> path, double t) {
  const auto after = std::upper_bound(path.begin(), path.end(), t,
                                      [](double x, const TimedPose& p) { return x < p.t; });
  if (after == path.begin()) return path.front().pose;
  if (after == path.end()) return path.back().pose;
  const TimedPose& from = *(after - 1);
  const double s = (t - from.t) / (after->t - from.t);
  return {from.pose.q.slerp(s, after->pose.q), from.pose.p + s * (after->pose.p - from.pose.p)};
}

/// How far a point of the probe goes from one pose to the next, at most, m.
double path_length(const MassProperties& mass, const Pose& from, const Pose& to) {
  const Chart chart(mass, from);
  return Motion(chart, Vec6::Zero(), chart.coordinates(to)).farthest(mass.radius);
}

Wrench wrench_of(const MassProperties& mass, const Separation& s, double k) {
  if (s.status != Status::penetrating) return {};
  return object_norm_wrench(mass, s.device, s.separated, k);
}

struct Samples {
  std::vector<double> force, torque, solve_us;
  int held_back = 0;
};

}  // namespace

std::vector<RowAge> measure_row_age(const Pair& pair, std::span<const TimedPose> path,
                                    const RowAgeOptions& options) {
  const MassProperties& mass = pair.probe().mass;
  ContactFeed feed(pair, options.method);
  feed.reset(path.front().pose, {});
  const int oldest = *std::max_element(options.ages.begin(), options.ages.end());
  std::vector<LocalContacts> kept(static_cast<std::size_t>(oldest) + 1, feed.contacts());
  std::vector<Samples> samples(options.ages.size());
  std::vector<double> speeds, refresh_us;
  double largest_force = 0;

  const double duration = path.back().t - path.front().t;
  const auto ticks = static_cast<std::size_t>(duration * options.rate_hz / options.speed);
  Pose before = path.front().pose;
  for (std::size_t i = 1; i <= ticks; ++i) {
    const double t = path.front().t + double(i) * options.speed / options.rate_hz;
    const Pose device = pose_at(path, t);
    speeds.push_back(path_length(mass, before, device) * options.rate_hz);
    before = device;
    const double refresh_begin = processor_time_us();
    const LocalContacts& now = kept[i % kept.size()] = feed.refresh(device, i, t, options.budget);
    refresh_us.push_back(processor_time_us() - refresh_begin);
    const Wrench in_step = wrench_of(mass, now.separation, options.k);
    largest_force = std::max(largest_force, in_step.force.norm());
    for (std::size_t a = 0; a < options.ages.size(); ++a) {
      const auto age = static_cast<std::size_t>(options.ages[a]);
      if (i <= age) continue;
      const LocalContacts& old = kept[(i - age) % kept.size()];
      const double begin = processor_time_us();
      const LocalAnswer answer = separate_locally(mass, options.method, old, device);
      samples[a].solve_us.push_back(processor_time_us() - begin);
      const bool contact = now.separation.status == Status::penetrating ||
                           answer.separation.status == Status::penetrating;
      if (!contact || old.jumps != now.jumps) continue;
      const Wrench aged = wrench_of(mass, answer.separation, options.k);
      samples[a].force.push_back((aged.force - in_step.force).norm());
      samples[a].torque.push_back((aged.torque - in_step.torque).norm());
      samples[a].held_back += answer.held_back;
    }
  }

  std::vector<RowAge> out;
  for (std::size_t a = 0; a < samples.size(); ++a)
    out.push_back({.age = options.ages[a],
                   .ticks = static_cast<int>(samples[a].force.size()),
                   .held_back = samples[a].held_back,
                   .probe_speed = spread(speeds).p99,
                   .largest_force = largest_force,
                   .force_error = spread(samples[a].force),
                   .torque_error = spread(samples[a].torque),
                   .solve_us = spread(samples[a].solve_us),
                   .refresh_us = spread(refresh_us)});
  return out;
}

}  // namespace sonde
