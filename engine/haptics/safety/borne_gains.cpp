// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/borne_gains.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr double light_hand = 1;  // N·s/m; for rotations times inertia / mass
/// Share of inertia / (sample time + delay): at most that much virtual damping counts, since it is
/// delayed itself. The estimate is then up to a fifth above the limit by the eigenvalues of an
/// axis; with twice this share, up to two fifths.
constexpr double counted_damping = 1.0 / 6;
constexpr double most_felt_turn = 1.2;  // factor on kÎ, from real contacts

/// m²: ratio of the largest stiffness felt in a rotation to the gain of the object norm.
double felt_turn(const MassProperties& mass) { return most_felt_turn * mass.inertia.maxCoeff(); }

/// The largest value of a gain that acts on translations and, times Î, on rotations.
double largest_of_both(double translation, double rotation, const MassProperties& mass) {
  const double turn = felt_turn(mass);
  if (!(rotation > 0 && turn > 0)) return translation;
  const double by_turn = rotation / turn;
  return translation > 0 ? std::min(translation, by_turn) : by_turn;
}

double largest_k(const BorneGains& most, const MassProperties& mass) {
  return largest_of_both(most.translation, most.rotation, mass);
}

DeviceTraits as_assumed(const DeviceTraits& device) {
  const auto scale = [](double ratio) { return ratio > 0 ? ratio : 1; };
  const DeviceTraits least =
      traits_at_probe(assumed_traits(), scale(device.ratio), scale(device.turn_ratio));
  DeviceTraits out = device;
  out.damping = least.damping;
  out.delay = least.delay;
  out.mass = least.mass;
  out.inertia = least.inertia;
  if (device.max_torque > 0) out.rotational_damping = least.rotational_damping;
  return out;
}

double capped(double wanted, double most) { return most > 0 ? std::min(wanted, most) : wanted; }

/// The share of a change up to which a stiffness exceeds its limit by no more than allowed.
/// `before` and `after`: excess over the limit before the change and after all of it.
double share_of(double before, double after) {
  if (after <= 0 || after <= before) return 1;
  return before >= 0 ? 0 : before / (before - after);
}

double share_up_to(double from, double most_before, double to, double most_after) {
  return most_before > 0 && most_after > 0 ? share_of(from - most_before, to - most_after) : 1;
}

}  // namespace

FeltGains felt_gains(const Coupling& c, const MassProperties& mass) noexcept {
  if (!in_object_norm(c.mode)) return {c.k_t, c.k_r, c.b_t, c.b_r};
  const double b = c.mode == Coupling::Mode::damped ? c.b_t : 0;
  return {c.k, c.k * felt_turn(mass), b, b * felt_turn(mass)};
}

BorneGains borne_by_device(const DeviceTraits& device) noexcept {
  return {device.max_stiffness, device.max_rotational_stiffness, device.max_damping,
          device.max_rotational_damping};
}

double most_object_damping(const BorneGains& most, const MassProperties& mass) noexcept {
  return largest_of_both(most.damping, most.rotational_damping, mass);
}

DeviceTraits assumed_traits() noexcept {
  DeviceTraits least;
  least.damping = 0.2;
  least.delay = 1e-3;
  least.rotational_damping = 1e-4;
  least.mass = 0.05;
  least.inertia = 5e-5;
  return least;
}

BorneGains stable_by_estimate(const DeviceTraits& device, double sample_time,
                              const Coupling& coupling, const MassProperties& mass) noexcept {
  const bool told = device.known || device.mass > 0;
  const DeviceTraits handle = told ? device : as_assumed(device);
  const double period = std::max(sample_time, handle.period);
  const double late = period / 2 + handle.delay;
  if (!handle.force || !(late > 0)) return {};
  const FeltGains taken = felt_gains(borne(coupling, borne_by_device(device), mass), mass);
  const auto counted = [&](double damping, double inertia) {
    return std::min(damping, counted_damping * inertia / (period + handle.delay));
  };
  BorneGains out{(handle.damping + light_hand + counted(taken.b_t, handle.mass)) / late};
  if (handle.mass > 0 && handle.inertia > 0 && handle.rotational_damping > 0)
    out.rotation = (handle.rotational_damping + light_hand * handle.inertia / handle.mass +
                    counted(taken.b_r, handle.inertia)) /
                   late;
  return out;
}

Coupling borne(const Coupling& wanted, const BorneGains& most,
               const MassProperties& mass) noexcept {
  Coupling out = wanted;
  out.k = capped(wanted.k, largest_k(most, mass));
  out.k_t = capped(wanted.k_t, most.translation);
  out.k_r = capped(wanted.k_r, most.rotation);
  out.b_t =
      capped(wanted.b_t, wanted.mode == Coupling::Mode::classic ? most.damping
                                                                : most_object_damping(most, mass));
  out.b_r = capped(wanted.b_r, most.rotational_damping);
  return out;
}

bool is_reduced(const Coupling& borne, const Coupling& wanted) noexcept {
  const bool by_b = wanted.mode != Coupling::Mode::object && borne.b_t < wanted.b_t;
  if (in_object_norm(wanted.mode)) return by_b || borne.k < wanted.k;
  return by_b || borne.k_t < wanted.k_t || borne.k_r < wanted.k_r || borne.b_r < wanted.b_r;
}

double share_of_way(const GainGlide& glide, const DeviceTraits& device, double sample_time,
                    const MassProperties& mass) noexcept {
  const FeltGains from = felt_gains(glide.from(), mass), to = felt_gains(glide.to(), mass);
  const BorneGains before = stable_by_estimate(device, sample_time, glide.from(), mass);
  const BorneGains after = stable_by_estimate(device, sample_time, glide.to(), mass);
  // The felt stiffness is linear along the glide, in a blend of two modes too. The limit is the
  // smaller of two linear functions, so it is nowhere below the straight line between its values at
  // the ends.
  return std::min(share_up_to(from.k_t, before.translation, to.k_t, after.translation),
                  share_up_to(from.k_r, before.rotation, to.k_r, after.rotation));
}

}  // namespace sonde
