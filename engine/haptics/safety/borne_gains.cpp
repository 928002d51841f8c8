// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/borne_gains.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr double light_hand = 1;        // N·s/m; for rotations times inertia / mass
constexpr double most_felt_turn = 1.2;  // factor on kÎ, from real contacts

/// Of a gain that acts on translations and, times Î, on rotations.
double largest_of_both(double translation, double rotation, const MassProperties& mass) {
  const double turn = most_felt_turn * mass.inertia.maxCoeff();
  if (!(rotation > 0 && turn > 0)) return translation;
  const double by_turn = rotation / turn;
  return translation > 0 ? std::min(translation, by_turn) : by_turn;
}

double largest_k(const BorneGains& most, const MassProperties& mass) {
  return largest_of_both(most.translation, most.rotation, mass);
}

double capped(double wanted, double most) { return most > 0 ? std::min(wanted, most) : wanted; }

double share_up_to(double from, double to, double most) {
  if (!(most > 0) || to <= most || to <= from) return 1;
  return from >= most ? 0 : (most - from) / (to - from);
}

}  // namespace

BorneGains borne_by_device(const DeviceTraits& device) noexcept {
  return {device.max_stiffness, device.max_rotational_stiffness, device.max_damping,
          device.max_rotational_damping};
}

BorneGains stable_by_estimate(const DeviceTraits& device, double sample_time) noexcept {
  const double late = sample_time / 2 + device.delay;
  if (!(device.damping > 0) || !(late > 0)) return {};
  BorneGains out{(device.damping + light_hand) / late};
  if (device.mass > 0 && device.inertia > 0 && device.rotational_damping > 0)
    out.rotation = (device.rotational_damping + light_hand * device.inertia / device.mass) / late;
  return out;
}

Coupling borne(const Coupling& wanted, const BorneGains& most,
               const MassProperties& mass) noexcept {
  Coupling out = wanted;
  out.k = capped(wanted.k, largest_k(most, mass));
  out.k_t = capped(wanted.k_t, most.translation);
  out.k_r = capped(wanted.k_r, most.rotation);
  out.b_t = capped(wanted.b_t, wanted.mode == Coupling::Mode::classic
                                   ? most.damping
                                   : largest_of_both(most.damping, most.rotational_damping, mass));
  out.b_r = capped(wanted.b_r, most.rotational_damping);
  return out;
}

bool is_reduced(const Coupling& borne, const Coupling& wanted) noexcept {
  const bool by_b = wanted.mode != Coupling::Mode::object && borne.b_t < wanted.b_t;
  if (in_object_norm(wanted.mode)) return by_b || borne.k < wanted.k;
  return by_b || borne.k_t < wanted.k_t || borne.k_r < wanted.k_r || borne.b_r < wanted.b_r;
}

double share_of_way(const GainGlide& glide, const BorneGains& most,
                    const MassProperties& mass) noexcept {
  const Coupling &from = glide.from(), &to = glide.to();
  if (in_object_norm(from.mode) != in_object_norm(to.mode)) return 1;
  if (in_object_norm(to.mode)) return share_up_to(from.k, to.k, largest_k(most, mass));
  return std::min(share_up_to(from.k_t, to.k_t, most.translation),
                  share_up_to(from.k_r, to.k_r, most.rotation));
}

}  // namespace sonde
