// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/profile_limits.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/haptics/safety/borne_gains.hpp"

namespace sonde {
namespace {

/// The largest stiffness for which one step of the encoder changes the force by no more than
/// friction dissipates (K ≤ 2 f_c/Δ: Abbott and Okamura, 2005), or by a hundredth of the device's
/// force if it has less friction than that. The damping's own step counts too.
double resolved_stiffness(double friction, double most, double step, double damping,
                          double sample_time) {
  if (step == 0) return infinity;
  return std::max(0.0, std::max(2 * friction, 0.01 * most) / step - damping / sample_time);
}

/// What the loop makes of the stiffest gains of an axis (borne), whatever the contact.
double rendered_stiffness(const TuningResults& results, const std::map<std::string, double>& device,
                          GainAxis axis) {
  const BorneGains most{.translation = device.at("max_stiffness"),
                        .rotation = device.at("max_rotational_stiffness")};
  MassProperties mass;
  mass.inertia.setConstant(results.largest_inertia);
  Coupling wanted;
  wanted.mode = results.mode;
  wanted.k = wanted.k_t = wanted.k_r = infinity;
  const Coupling taken = borne(wanted, most, mass);
  if (in_object_norm(axis)) return taken.k;
  if (axis == GainAxis::rotation) return taken.k_r;
  return is_joint(axis) ? std::min(taken.k_t, taken.k_r / results.joint.stiffness) : taken.k_t;
}

}  // namespace

void add_profile_limits(const TuningResults& results, const std::vector<const TuningLine*>& lines,
                        const std::map<std::string, double>& device, GainAxis axis, double damping,
                        std::vector<GainLimit>& limits) {
  const double T = results.sample_time;
  // With the ratio at which the felt stiffness was measured, whatever value is varied here.
  const double per = results.device.at("inertia") / results.device.at("mass");
  const bool joint = is_joint(axis);
  Coupling at;
  at.b_t = at.b_r = 0;
  set_gains(at, axis, 0, damping, results.joint);
  const bool damped = axis == GainAxis::damped;  // its damper is felt as its spring is
  for (const TuningLine* line : lines) {
    TuningResults::Felt felt = results.felt[line->situation];
    if (!in_object_norm(axis)) felt.rotation *= (joint ? results.joint.stiffness : 1) / per;
    const auto add = [&](const char* reason, double allowed, double felt_at_one) {
      if (felt_at_one > 0) limits.push_back({reason, allowed / felt_at_one, line->kind, ""});
    };
    if (axis != GainAxis::rotation) {
      add("driver", device.at("max_stiffness"), felt.translation);
      add("resolution",
          resolved_stiffness(device.at("friction"), device.at("max_force"), device.at("resolution"),
                             damped ? at.b_t * felt.translation : at.b_t, T),
          felt.translation);
    }
    if (axis != GainAxis::translation && device.at("max_torque") > 0) {
      if (device.at("max_rotational_stiffness") > 0)
        add("driver", device.at("max_rotational_stiffness"), felt.rotation);
      add("resolution",
          resolved_stiffness(device.at("rotational_friction"), device.at("max_torque"),
                             device.at("rotational_resolution"),
                             damped ? at.b_t * felt.rotation : at.b_r, T),
          felt.rotation);
    }
  }
  if (const double rendered = rendered_stiffness(results, device, axis); std::isfinite(rendered))
    limits.push_back({"rendered", rendered, "", ""});
}

}  // namespace sonde
