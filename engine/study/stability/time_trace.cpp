// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/time_trace.hpp"

#include <algorithm>
#include <cmath>

#include "engine/body/body.hpp"
#include "engine/study/stability/chatter.hpp"

namespace sonde {
namespace {

constexpr double settled_band = 0.05;
constexpr double last_part = 0.1;  // s

std::vector<double> forces_from(const std::vector<TraceSample>& samples, double t) {
  std::vector<double> out;
  for (const TraceSample& sample : samples)
    if (sample.t >= t) out.push_back(sample.motors.force.norm());
  return out;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / double(values.size());
}

double chatter_of(const std::vector<FeltTick>& felt, const ClosedLoopSetup& setup) {
  const double length = std::sqrt(setup.pair.probe().mass.inertia.maxCoeff());
  const Chatter heard = chatter(felt, setup.sample_time, felt_handle(setup), length);
  return heard.buzzes() ? heard.force : 0;
}

void measure(TimeTrace& trace, HandCourse course, const ClosedLoopSetup& setup) {
  TraceFigures& f = trace.figures;
  f.force = mean(forces_from(trace.samples, course_time - last_part));
  if (!(f.force > 0)) return;
  const std::vector<double> steady = forces_from(trace.samples, steady_from(course));
  f.overshoot = std::max(0.0, *std::ranges::max_element(steady) / f.force - 1);
  f.settling_time = settling_time(steady, setup.sample_time, f.force, settled_band);
  if (f.settling_time && *f.settling_time > course_time - last_part - steady_from(course))
    f.settling_time.reset();
}

}  // namespace

std::optional<double> settling_time(std::span<const double> values, double dt, double last,
                                    double band) {
  std::size_t since = values.size();
  while (since > 0 && std::abs(values[since - 1] - last) <= band * std::abs(last)) --since;
  if (since == values.size()) return std::nullopt;
  return double(since) * dt;
}

TimeTrace trace(ClosedLoop& loop, HandCourse course, const CoursePlace& place) {
  const ClosedLoopSetup& setup = loop.setup();
  TimeTrace out;
  const auto ticks = std::llround(course_time / setup.sample_time);
  out.samples.reserve(static_cast<std::size_t>(ticks));
  loop.reset(place.X_FM);
  std::vector<FeltTick> felt;
  felt.reserve(static_cast<std::size_t>(ticks));
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    const double t = double(tick) * setup.sample_time;
    const HandleState before = loop.device().state();
    const HandInput hand = hand_at(course, place, t);
    loop.step(hand.X_FH, hand.push);
    const Separation& s = loop.haptic_loop().separation();
    const Wrench& motors = loop.device().motors();
    const HandleState& now = loop.device().state();
    // The motors' force is constant over most of a tick, so the trapezoidal rule on velocities
    // gives its work.
    out.figures.energy += setup.sample_time / 2 *
                          (motors.force.dot(before.velocity + now.velocity) +
                           motors.torque.dot(before.spin + now.spin));
    out.figures.jumps += s.fell();
    out.figures.failures += s.status == Status::failed;
    felt.push_back(felt_tick(now, motors, place.X_FM));
    out.samples.push_back({t, motors, s.status == Status::penetrating ? s.depth : 0});
  }
  out.figures.chatter = chatter_of(felt, setup);
  measure(out, course, setup);
  return out;
}

}  // namespace sonde
