// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "engine/geometry/random.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/response.hpp"

namespace sonde::test {

/// A handle whose truth is known, along one axis.
struct TrueHandle {
  double inertia = 0.1, damping = 0.4, friction = 0.05, delay = 1e-3, step = 3e-5;
  double hand = 0;  ///< N/m, of a hand that holds it where it was
  double drag = 0;  ///< N·s²/m², of the square of its speed: what the fitted model has not
};

/// What it does under commands that hold for a sample each: Runge and Kutta's fourth order, in 100
/// steps a sample, with Coulomb friction that stops the handle where it would turn it round. It
/// shares nothing with the model that is fitted. `phase`: where it begins, in steps of the encoder.
class Integration {
 public:
  explicit Integration(const TrueHandle& handle, double sample_time, double phase = 0)
      : h_(handle), T_(sample_time), x_(phase * handle.step), start_(x_) {}

  /// Until the next sample, under a command of `delayed(t)`, t in s from the sample.
  template <class Delayed>
  void sample(const Delayed& delayed) {
    constexpr int steps = 100;
    const double h = T_ / steps;
    for (int i = 0; i < steps; ++i) step(delayed((i + 0.5) * h), h);
  }
  double measured() const { return h_.step == 0 ? x_ : std::round(x_ / h_.step) * h_.step; }

 private:
  double force(double given, double x, double v, double way) const {
    return (given - h_.hand * (x - start_) - h_.damping * v - h_.drag * v * std::abs(v) -
            way * h_.friction) /
           h_.inertia;
  }
  struct State {
    double x, v;
  };
  State after(double given, double h, double way) const {
    const double a1 = force(given, x_, v_, way);
    const double a2 = force(given, x_ + h / 2 * v_, v_ + h / 2 * a1, way);
    const double a3 = force(given, x_ + h / 2 * v_ + h * h / 4 * a1, v_ + h / 2 * a2, way);
    const double a4 = force(given, x_ + h * v_ + h * h / 2 * a2, v_ + h * a3, way);
    return {x_ + h * v_ + h * h / 6 * (a1 + a2 + a3), v_ + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }
  /// The part of a step after which the handle stops.
  double part_to_stop(double given, double h, double way) const {
    double moves = 0, turned = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = (moves + turned) / 2;
      (after(given, middle * h, way).v * way > 0 ? moves : turned) = middle;
    }
    return turned;
  }
  void step(double given, double h) {
    const double pull = given - h_.hand * (x_ - start_);
    if (v_ == 0 && std::abs(pull) <= h_.friction) return;
    const double way = std::copysign(1.0, v_ != 0 ? v_ : pull);
    const State next = after(given, h, way);
    if (next.v * way >= 0) {
      x_ = next.x;
      v_ = next.v;
      return;
    }
    const double part = part_to_stop(given, h, way);
    x_ = after(given, part * h, way).x;
    v_ = 0;
    step(given, (1 - part) * h);
  }

  TrueHandle h_;
  double T_, x_, v_ = 0, start_;
};

/// Its answer to a plan along one axis, with noise of this size (uniform, m | rad) on the encoder.
inline Response answer(const TrueHandle& handle, const PulsePlan& plan, std::size_t axis,
                       std::uint64_t seed = 1, double noise = 0) {
  const std::vector<Wrench> commands = commands_of(plan);
  const auto i = static_cast<Eigen::Index>(axis % 3);
  const auto at = [&](double samples) {
    if (samples < 0) return 0.0;
    const Wrench& w = commands[static_cast<std::size_t>(samples)];
    return (axis < 3 ? w.force : w.torque)[i];
  };
  Random random(seed);
  Integration integration(handle, plan.sample_time, random.uniform(-0.5, 0.5));
  Response out;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const double read = integration.measured() + noise * random.uniform(-1, 1);
    ResponseSample sample{
        .t = static_cast<double>(k) * plan.sample_time, .command = commands[k], .X_BH = {}};
    if (axis < 3)
      sample.X_BH.p[i] = read;
    else
      sample.X_BH.q = Quat(Eigen::AngleAxisd(read, Vec3::Unit(i)));
    out.push_back(sample);
    integration.sample([&](double t) {
      return at(std::floor(static_cast<double>(k) + (t - handle.delay) / plan.sample_time));
    });
  }
  return out;
}

}  // namespace sonde::test
