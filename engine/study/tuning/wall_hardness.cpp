// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/wall_hardness.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/base/numbers.hpp"

namespace sonde {
namespace {

constexpr double felt_first = 0.01;  // s
constexpr int parts_of_sample = 60;  // errors of a second-order step are then far below 1e-3
/// A handle meets a wall at any moment between two samples. What is measured is the mean over
/// these moments, evenly spaced: at one of them alone, it would go in leaps of a whole sample.
constexpr int moments = 10;
constexpr int parts_of_moment = parts_of_sample / moments;

/// The handle against the wall, x > 0 inside, in sub-steps of a sample.
class Handle {
 public:
  /// The last sample was `moment` of all moments and a half before.
  Handle(const SampledAxis& axis, double stiffness, const AxisHand& hand, double speed, int moment)
      : axis_(axis),
        stiffness_(stiffness),
        hand_(hand),
        v_(speed),
        part_(parts_of_moment * moment + parts_of_moment / 2) {}

  /// Advances by a sub-step; the target is that of the hand's spring.
  void step(double target) {
    if (part_ == 0) sample();
    const double h = axis_.sample_time / parts_of_sample;
    const double now = at(time_ + h / 2);
    const auto a = [&](double x, double v) {
      return (hand_.stiffness * (target - x) - (axis_.damping + hand_.damping) * v - now) /
             axis_.inertia;
    };
    const double x = x_ + h / 2 * v_, v = v_ + h / 2 * a(x_, v_);
    x_ += h * v;
    v_ += h * a(x, v);
    time_ = ++steps_ * h;
    part_ = (part_ + 1) % parts_of_sample;
    force_ = now;
  }
  double time() const { return time_; }
  double force() const { return force_; }  ///< of the motors, against the motion

 private:
  struct Command {
    double due, force;
  };

  void sample() {
    const double inside = std::max(x_, 0.0), before = std::max(sampled_, 0.0);
    const double f =
        stiffness_ * inside + axis_.virtual_damping * (inside - before) / axis_.sample_time;
    sampled_ = x_;
    commands_.push_back({time_ + axis_.delay, x_ > 0 ? f : 0});
  }
  double at(double time) {
    while (commands_.size() > 1 && commands_[1].due <= time) commands_.pop_front();
    return commands_.front().due <= time ? commands_.front().force : 0;
  }

  SampledAxis axis_;
  double stiffness_;
  AxisHand hand_;
  double x_ = 0, v_, time_ = 0, sampled_ = 0, force_ = 0;
  int part_, steps_ = 0;
  std::deque<Command> commands_;
};

}  // namespace

double rate_hardness(const SampledAxis& axis, double stiffness) {
  double sum = 0;
  for (int moment = 0; moment < moments; ++moment) {
    Handle handle(axis, stiffness, {}, 1, moment);
    while (handle.time() < felt_first) handle.step(0);
    sum += handle.force();
  }
  return sum / moments / felt_first;
}

double rise_time(const SampledAxis& axis, double stiffness, const AxisHand& hand) {
  // The two springs are in series.
  const double final = stiffness * hand.stiffness / (stiffness + hand.stiffness);
  const double longest = 10;  // s: far longer than any handle in a hand takes
  double sum = 0;
  for (int moment = 0; moment < moments; ++moment) {
    Handle handle(axis, stiffness, hand, 0, moment);
    double tenth = 0, rise = infinity;
    while (handle.time() < longest && rise == infinity) {
      handle.step(1);
      if (tenth == 0 && handle.force() >= 0.1 * final) tenth = handle.time();
      if (handle.force() >= 0.9 * final) rise = handle.time() - tenth;
    }
    if (rise == infinity) return infinity;
    sum += rise;
  }
  return sum / moments;
}

}  // namespace sonde
