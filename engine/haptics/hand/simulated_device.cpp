// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/simulated_device.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde {
namespace {

/// rad: largest phase of an oscillation in the hand's spring per step, so that a step that ends at
/// rest does so because of friction, not because of the phase.
constexpr double most_phase = 1;
constexpr double most_steps = 1000;

void expect(bool right, const char* complaint) {
  if (!right) throw std::invalid_argument(std::string("simulated device: ") + complaint);
}
bool at_least_zero(double x) { return std::isfinite(x) && x >= 0; }

void check(const HandleMotion& m) {
  expect(std::isfinite(m.inertia) && m.inertia > 0, "its inertia must be above zero");
  for (const double x :
       {m.damping, m.friction, m.resolution, m.limit, m.hand_stiffness, m.hand_damping})
    expect(at_least_zero(x), "no number may be below zero");
}

/// rad/s: frequency of the handle's oscillation in the hand; zero if it is overdamped.
double swing(const HandleMotion& m) {
  const double decay = (m.damping + m.hand_damping) / (2 * m.inertia);
  return std::sqrt(std::max(0.0, m.hand_stiffness / m.inertia - decay * decay));
}

Vec3 rounded(const Vec3& x, double step) {
  if (step == 0) return x;
  return (x / step).array().round().matrix() * step;
}

}  // namespace

SimulatedDevice::LinearStep SimulatedDevice::linear_step(const HandleMotion& motion, double time) {
  const double stiffness = motion.hand_stiffness / motion.inertia;
  const double damping = (motion.damping + motion.hand_damping) / motion.inertia;
  // In units of the step, so that the matrix exponential is of numbers near one.
  Mat3 rates = Mat3::Zero();
  rates(0, 1) = 1;
  rates(1, 0) = -stiffness * time * time;
  rates(1, 1) = -damping * time;
  rates(1, 2) = 1;
  const Mat3 E = rates.exp();
  const double force = time * time / motion.inertia;
  return {E(0, 0),        E(0, 1) * time, E(0, 2) * force,
          E(1, 0) / time, E(1, 1),        E(1, 2) * force / time};
}

SimulatedDevice::Part SimulatedDevice::part(double time) const {
  if (time == 0) return {};
  const double fastest = std::max(swing(parameters_.translation), swing(parameters_.rotation));
  const double steps = std::max(1.0, std::ceil(fastest * time / most_phase));
  expect(steps <= most_steps, "the hand is too stiff for this inertia and sample time");
  const double step_time = time / steps;
  return {step_time, static_cast<std::size_t>(steps),
          linear_step(parameters_.translation, step_time),
          linear_step(parameters_.rotation, step_time)};
}

SimulatedDevice::SimulatedDevice(const SimulatedDeviceParameters& parameters, double sample_time,
                                 const Pose& X_WD)
    : parameters_(parameters), sample_time_(sample_time) {
  expect(std::isfinite(sample_time) && sample_time > 0, "the sample time must be above zero");
  check(parameters.translation);
  check(parameters.rotation);
  const double late = parameters.delay / sample_time;
  expect(at_least_zero(late) && late <= double(most_samples_late),
         "the delay must be between zero and 64 samples");
  samples_late_ = static_cast<std::size_t>(late);
  const double rest = (late - double(samples_late_)) * sample_time;
  older_ = part(rest);
  newer_ = part(sample_time - rest);
  reset(X_WD);
}

void SimulatedDevice::reset(const Pose& X_WD, const Pose& X_WH) noexcept {
  state_ = {.X_WD = X_WD};
  X_WH_ = X_WH;
  motors_ = {};
  commands_.fill({});
  newest_ = 0;
}

void SimulatedDevice::go_on_from(const SimulatedDevice& before) noexcept {
  state_ = before.state_;
  X_WH_ = before.X_WH_;
  motors_ = before.motors_;
  newest_ = 0;
  const std::size_t size = commands_.size();
  const double ratio = sample_time_ / before.sample_time_;
  for (std::size_t ago = 0; ago < size; ++ago) {
    const auto then =
        static_cast<std::size_t>(std::min(std::round(ratio * double(ago)), double(size - 1)));
    commands_[(size - ago) % size] = before.commands_[(before.newest_ + size - then) % size];
  }
}

void SimulatedDevice::step(const Wrench& command, const Pose& X_WH, const Wrench& push) noexcept {
  newest_ = (newest_ + 1) % commands_.size();
  commands_[newest_] = limit(command, parameters_.translation.limit, parameters_.rotation.limit);
  const auto given = [&](std::size_t samples_ago) -> const Wrench& {
    return commands_[(newest_ + commands_.size() - samples_ago) % commands_.size()];
  };
  const Vec3 hand_velocity = (X_WH.p - X_WH_.p) / sample_time_;
  const Vec3 hand_spin = rotation_vector(X_WH.q * X_WH_.q.conjugate()) / sample_time_;
  const auto with_push = [&](const Wrench& motors) {
    return Wrench{motors.force + push.force, motors.torque + push.torque};
  };
  advance(older_, with_push(given(samples_late_ + 1)), hand_velocity, hand_spin);
  advance(newer_, with_push(given(samples_late_)), hand_velocity, hand_spin);
  X_WH_ = X_WH;  // exactly, whatever the steps have rounded
  motors_ = given(samples_late_);
}

namespace {

/// One kind of motion over one step. `error` is the vector from target to handle; updates both.
template <class Step>
void move(const HandleMotion& motion, const Step& s, const Vec3& force, const Vec3& hand_velocity,
          Vec3& error, Vec3& velocity) {
  const Vec3 rate = velocity - hand_velocity;
  Vec3 g = force - motion.damping * hand_velocity;
  const Vec3 free = s.v_e * error + s.v_v * rate + s.v_g * g + hand_velocity;
  if (motion.friction > 0) {
    // The friction that brings the handle to rest at the end of the step, up to its limit.
    const Vec3 stopping = -free / s.v_g;
    const double size = stopping.norm();
    g += size <= motion.friction ? stopping : Vec3(stopping * (motion.friction / size));
  }
  const Vec3 new_error = s.e_e * error + s.e_v * rate + s.e_g * g;
  velocity = s.v_e * error + s.v_v * rate + s.v_g * g + hand_velocity;
  error = new_error;
}

}  // namespace

void SimulatedDevice::advance(const Part& part, const Wrench& given, const Vec3& hand_velocity,
                              const Vec3& hand_spin) noexcept {
  const Vec3 hand_shift = hand_velocity * part.step_time;
  const Vec3 hand_turn = hand_spin * part.step_time;
  for (std::size_t i = 0; i < part.steps; ++i) {
    Vec3 offset = state_.X_WD.p - X_WH_.p;
    move(parameters_.translation, part.translation, given.force, hand_velocity, offset,
         state_.velocity);
    X_WH_.p += hand_shift;
    state_.X_WD.p = X_WH_.p + offset;

    const Vec3 before = rotation_vector(state_.X_WD.q * X_WH_.q.conjugate());
    Vec3 turn = before;
    move(parameters_.rotation, part.rotation, given.torque, hand_spin, turn, state_.spin);
    X_WH_.q = (rotation_by(hand_turn) * X_WH_.q).normalized();
    state_.X_WD.q = (rotation_by(turn - before + hand_turn) * state_.X_WD.q).normalized();
  }
}

Pose SimulatedDevice::measured() const noexcept {
  const double step = parameters_.rotation.resolution;
  return {step == 0 ? state_.X_WD.q : rotation_by(rounded(rotation_vector(state_.X_WD.q), step)),
          rounded(state_.X_WD.p, parameters_.translation.resolution)};
}

}  // namespace sonde
