// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/carried_force.hpp"

#include <algorithm>

namespace sonde {
namespace {

Vec3 less(const Vec3& carried, double by) {
  const double size = carried.norm();
  return size > by ? Vec3(carried * (1 - by / size)) : Vec3(Vec3::Zero());
}

/// Removes from the sum a component against `wanted`.
Vec3 not_against(const Vec3& sum, const Vec3& wanted) {
  const double along = sum.dot(wanted);
  if (along >= 0) return sum;
  return sum - wanted * (along / wanted.squaredNorm());
}

}  // namespace

double share_where_it_yields(double speed) noexcept {
  return std::clamp(1 - speed / slow_enough, 0.01, 1.0);
}

double rate_of_end(double size, double rate, double along) noexcept {
  constexpr double of_what_only_pushes = 0.05;  // s
  if (!(along > 0)) return rate * share_where_it_yields(-along);
  return rate + size / of_what_only_pushes * std::min(1.0, along / slow_enough);
}

void CarriedForce::carry(const Wrench& felt, const Wrench& now) noexcept {
  more_.force = felt.force - now.force;
  more_.torque = felt.torque - now.torque;
  if (!more_.force.allFinite() || !more_.torque.allFinite()) restart();
}

Wrench CarriedForce::added_to(const Wrench& wanted, const ChangeRate& rate, const Vec3& velocity,
                              double dt) noexcept {
  if (more_.force.isZero(0) && more_.torque.isZero(0)) return wanted;
  // A loosely held handle moves in the direction in which the force changes.
  const double size = more_.force.norm();
  double along = size > 0 ? velocity.dot(more_.force) / size : 0;
  if (!(velocity.dot(wanted.force + more_.force) > 0)) along = std::min(along, 0.0);
  const double step = dt > 0 ? dt : 0;
  more_.force = rate.force > 0 ? less(more_.force, rate_of_end(size, rate.force, along) * step)
                               : Vec3(Vec3::Zero());
  more_.torque = rate.torque > 0 ? less(more_.torque, rate.torque * step) : Vec3(Vec3::Zero());
  Wrench out = wanted;
  out.force = not_against(wanted.force + more_.force, wanted.force);
  out.torque = not_against(wanted.torque + more_.torque, wanted.torque);
  return out;
}

}  // namespace sonde
