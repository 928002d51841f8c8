// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/force_gate.hpp"

#include <algorithm>
#include <cmath>

#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde {
namespace {

/// s: a late tick must not let the whole ramp pass at once.
constexpr double longest_step = 0.005;

}  // namespace

const char* words(Withheld why) {
  switch (why) {
    case Withheld::nothing:
      return "";
    case Withheld::stopped:
      return "force stopped";
    case Withheld::paused:
      return "paused";
    case Withheld::let_go:
      return "clutch open";
    case Withheld::changed:
      return "another hand, or other axes";
    case Withheld::untrusted:
      return "the device is gone, or its pose cannot be true";
    case Withheld::not_finite:
      return "a pose or a force that is not a number";
    case Withheld::failed:
      return "no separated pose was found";
    case Withheld::stalled:
      return "the geometry does not keep up";
    case Withheld::unsettled:
      return "the separated pose is not settled";
    case Withheld::diverged:
      return "the loop diverged, and threw the hand";
    case Withheld::shut_down:
      return "the loop has ended";
  }
  return "";
}

void ForceGate::restart() noexcept {
  last_ = Wrench{};
  share_ = 0;
  slewed_ = false;
}

double ForceGate::rise(const Wrench& wanted, double step) const noexcept {
  const double by_time = settings_.ramp_time > 0 ? step / settings_.ramp_time : 1;
  return std::min(by_time, share_of_change(wanted, rate_, step));
}

double ForceGate::closer(double limit, double other) noexcept {
  return limit > 0 && other > 0 ? std::min(limit, other) : std::max(limit, other);
}

Wrench ForceGate::pass(const Wrench& wanted, Withheld why, double max_force, double max_torque,
                       double dt) noexcept {
  const bool finite = wanted.force.allFinite() && wanted.torque.allFinite();
  withheld_ = why == Withheld::nothing && !finite ? Withheld::not_finite : why;
  const bool fades = withheld_ == Withheld::unsettled && finite;
  if (withheld_ != Withheld::nothing && !fades) {
    restart();
    return last_;
  }
  const double step = dt > 0 ? std::min(dt, longest_step) : 0;  // NaN: 0
  const bool pushes = !wanted.force.isZero(0) || !wanted.torque.isZero(0);
  if (fades)
    share_ = settings_.fade_time > 0 ? std::max(0.0, share_ - step / settings_.fade_time) : 0;
  else if (pushes && share_ < 1)
    share_ = std::min(1.0, share_ + rise(wanted, step));
  Wrench out = wanted;
  out.force *= share_;
  out.torque *= share_;
  slewed_ = false;
  const bool close = pushes || !slew_.ends_at_once;
  // A falling wrench may change faster: it does not accelerate the hand, and an outdated force must
  // not remain.
  const auto falling = [&](const Vec3& to, const Vec3& from, double besides) {
    if (!(to.norm() < from.norm())) return 0.0;
    return besides + (settings_.fade_time > 0 ? from.norm() / settings_.fade_time : 0);
  };
  const double force = closer(
      settings_.force_slew, close && slew_.force > 0
                                ? slew_.force + falling(out.force, last_.force, slew_.falling_force)
                                : 0);
  const double torque =
      closer(settings_.torque_slew,
             close && slew_.torque > 0
                 ? slew_.torque + falling(out.torque, last_.torque, slew_.falling_torque)
                 : 0);
  if (force > 0) out.force = towards(out.force, last_.force, force * step, &slewed_);
  if (torque > 0) out.torque = towards(out.torque, last_.torque, torque * step, &slewed_);
  return last_ = limit(out, max_force, max_torque);
}

}  // namespace sonde
