// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/borne_gains.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr double light_hand = 1;        // N·s/m; for rotations times inertia / mass
constexpr double most_felt_turn = 1.2;  // factor on kÎ, from real contacts

double largest_k(const BorneStiffness& most, const MassProperties& mass) {
  double out = most.translation;
  const double turn = most_felt_turn * mass.inertia.maxCoeff();
  if (most.rotation > 0 && turn > 0) {
    const double by_turn = most.rotation / turn;
    out = out > 0 ? std::min(out, by_turn) : by_turn;
  }
  return out;
}

double capped(double wanted, double most) { return most > 0 ? std::min(wanted, most) : wanted; }

double share_up_to(double from, double to, double most) {
  if (!(most > 0) || to <= most || to <= from) return 1;
  return from >= most ? 0 : (most - from) / (to - from);
}

}  // namespace

BorneStiffness borne_by_device(const DeviceTraits& device) noexcept {
  return {device.max_stiffness, device.max_rotational_stiffness};
}

BorneStiffness stable_by_estimate(const DeviceTraits& device, double sample_time) noexcept {
  const double late = sample_time / 2 + device.delay;
  if (!(device.damping > 0) || !(late > 0)) return {};
  BorneStiffness out{(device.damping + light_hand) / late, 0};
  if (device.mass > 0 && device.inertia > 0 && device.rotational_damping > 0)
    out.rotation = (device.rotational_damping + light_hand * device.inertia / device.mass) / late;
  return out;
}

Coupling borne(const Coupling& wanted, const BorneStiffness& most,
               const MassProperties& mass) noexcept {
  Coupling out = wanted;
  out.k = capped(wanted.k, largest_k(most, mass));
  out.k_t = capped(wanted.k_t, most.translation);
  out.k_r = capped(wanted.k_r, most.rotation);
  return out;
}

double share_of_way(const GainGlide& glide, const BorneStiffness& most,
                    const MassProperties& mass) noexcept {
  const Coupling &from = glide.from(), &to = glide.to();
  if (from.mode != to.mode) return 1;
  if (to.mode == Coupling::Mode::object) return share_up_to(from.k, to.k, largest_k(most, mass));
  return std::min(share_up_to(from.k_t, to.k_t, most.translation),
                  share_up_to(from.k_r, to.k_r, most.rotation));
}

}  // namespace sonde
