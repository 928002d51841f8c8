// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/hand_way.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/geometry/chart.hpp"

namespace sonde {

void HandWay::restart() noexcept {
  way_ = way_before_ = 0;
  leapt_ = false;
  forget_force();
}

void HandWay::forget_force() noexcept {
  passed_ = Wrench{};
  unspent_ = fresh_for_ = 0;
}

void HandWay::measure(const MassProperties& mass, const Motion& m) noexcept {
  way_before_ = way_;
  way_ = Chart(mass, m.before).coordinates(m.now).norm();
  leapt_ = m.fastest > 0 && way_ > m.fastest * m.since;
  // Until the next report is due, what this one has told is how the hand moves.
  const bool waits = !(way_ > 0) && fresh_for_ > 0;
  fresh_for_ = waits ? fresh_for_ - m.dt : m.since - m.dt;
  if (leapt_) way_ = unspent_ = 0;  // no hand moves that fast
  withdrawn_ = way_;
  if (waits) return;
  const Vec3 moved = m.now * mass.com - m.before * mass.com;
  const double force = m.force.norm();
  const double given = force > 0 ? m.force.dot(moved) / force : 0;
  yields_ = m.since > 0 ? given / m.since : 0;
  velocity_ = m.since > 0 ? Vec3(moved / m.since) : Vec3(Vec3::Zero());
  // The force may grow only with motion against it or across it, not with motion in its direction.
  if (given > 0) way_ = std::sqrt(std::max(0.0, way_ * way_ - given * given));
}

/// A report permits a change by what the hand moved. What a tick makes less of it, because of the
/// device's own limit, is left to the ticks until the next report is due.
void HandWay::spend(const Wrench& passed, double dt) noexcept {
  const double spent = per_way_ > 0 ? (passed.force - passed_.force).norm() / per_way_ : infinity;
  unspent_ = fresh_for_ > dt / 2 ? std::max(0.0, way_ + unspent_ - spent) : 0;
  passed_ = passed;
}

ForceGate::Slew HandWay::slew(const MassProperties& mass, const Coupling& c, const Most& most,
                              const ChangeRate& rate, bool separated, double dt) noexcept {
  constexpr double margin = 2;
  if (!(rate.force > 0) || !(dt > 0)) return {};
  const bool object = in_object_norm(c.mode);
  const double b_t = c.mode == Coupling::Mode::object ? 0 : c.b_t;
  const double largest = mass.inertia.maxCoeff();
  const double per_turn = largest > 0 ? 1 / std::sqrt(largest) : 0;
  const double stiff = object ? c.k : c.k_t;
  const double turning = object ? c.k / (per_turn > 0 ? per_turn : 1) : c.k_r * per_turn;
  const double turning_b = object ? b_t / (per_turn > 0 ? per_turn : 1) : c.b_r * per_turn;
  const double way = way_ + unspent_, both = (way + way_before_) / dt;
  per_way_ = margin * stiff;
  ForceGate::Slew slew{margin * (stiff * way + b_t * both) / dt,
                       margin * (turning * way + turning_b * both) / dt, separated && !leapt_,
                       margin * stiff * withdrawn_ / dt, margin * turning * withdrawn_ / dt};
  slew.force = std::min(slew.force, most.force / whole_force) + rate.force;
  slew.torque = std::min(slew.torque, most.torque / whole_force) + rate.torque;
  return slew;
}

}  // namespace sonde
