// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/hand_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/numbers.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/haptics/safety/hand_trial.hpp"
#include "engine/penetration/descent/result.hpp"

namespace sonde {
namespace {

/// s: a device that reports less often than this is slow for a force. So a pose that is wrong by a
/// centimetre is not taken for motion, at the default runaway_speed of 2 m/s and a ratio of 1, with
/// ticks no longer than this.
constexpr double longest_since = 0.005;

/// No limit that is in use becomes less than what is in use.
double at_least(double limit, double used) { return limit > 0 ? std::max(limit, used) : 0; }

}  // namespace

HandLoop::HandLoop(const MassProperties& mass, Method method, const Coupling& coupling,
                   const HandLoopSettings& settings)
    : mass_(mass),
      method_(method),
      least_stall_(settings.safety.stalled_after),
      stalled_after_(least_stall_),
      force_error_(settings.safety.force_error),
      fastest_{settings.safety.runaway_speed, settings.safety.runaway_turn},
      of_hand_(settings.safety.change_rate),
      set_{.now = coupling, .before = coupling},
      coupler_(mass, coupling, method),
      passivity_(mass, settings.passivity, 1 / settings.rate_hz),
      runaway_(fastest_),
      gate_(settings.safety) {
  set_rate(settings.rate_hz);
}

void HandLoop::set_rate(double rate_hz) noexcept {
  // The rows of a slow servo are a tick old at best.
  stalled_after_ = std::max(least_stall_, 4 / rate_hz);
  passivity_.set_period(1 / rate_hz);
  period_ = 1 / rate_hz;
}

void HandLoop::restart(const Pose& X_FM) noexcept {
  coupler_.forget();
  passivity_.restart(X_FM);
  runaway_.restart();
  gate_.restart();
  way_.restart();
  forget_force();
  ids_.forget();
  device_.reset();
  X_FM_ = X_FM;
  jumps_ = falls_ = 0;
  released_ = 0;
  resting_ = false;
  resumed_ = 0;
  anew_ = true;
  felt_already_.reset();
  out_ = HandTick{};
}

/// What the limits keep of the last force. The next one rises from zero.
void HandLoop::forget_force() noexcept {
  damping_ = Wrench{};
  carried_.restart();
  way_.forget_force();
}

Withheld HandLoop::fault(const HandSample& sample) const noexcept {
  if (!sample.trusted) return Withheld::untrusted;
  if (!is_finite(sample.X_FM)) return Withheld::not_finite;
  if (!sample.held) return Withheld::let_go;
  if (sample.changed) return Withheld::changed;
  return runaway_.seen() ? Withheld::diverged : Withheld::nothing;
}

Withheld HandLoop::fault(const HandSample& sample, const LocalContacts& contacts,
                         const Clock& clock) const noexcept {
  if (const Withheld own = fault(sample); own != Withheld::nothing) return own;
  if (const Withheld late = overdue(contacts, clock); late != Withheld::nothing) return late;
  return is_unsettled() ? Withheld::unsettled : Withheld::nothing;
}

double HandLoop::unsettled_share() const noexcept {
  if (out_.separation.converged || !(force_error_ > 0)) return 0;
  return stiffness_of_lag(coupler_.coupling(), mass_) * lag_ / force_error_;
}

double HandLoop::behind() const noexcept {
  return std::max(unsettled_share(), out_.hand.rows.age / stalled_after_);
}

Withheld HandLoop::overdue(const LocalContacts& contacts, const Clock& clock) const noexcept {
  if (clock.now - contacts.time <= stalled_after_) return Withheld::nothing;
  const bool of_before = contacts.time < resumed_;
  const bool in_time = clock.now - resumed_ <= stalled_after_;
  return of_before && in_time ? rest_ : Withheld::stalled;
}

/// Follows the newest plausible pose. Only a known device can be thrown by the force; a mouse may
/// jump arbitrarily.
void HandLoop::follow(const HandSample& sample, double dt) noexcept {
  const bool trusted = sample.trusted && is_finite(sample.X_FM);
  const Pose before = X_FM_;
  if (trusted) X_FM_ = sample.X_FM;
  const bool can_throw = sample.device && !sample.trial;
  const ThrownSpeed fastest = can_throw ? thrown_speed(*sample.device, fastest_) : fastest_;
  // A hand that follows the mouse (SimulatedHand) states no ratio.
  const double ratio = can_throw && sample.device->ratio > 0 ? sample.device->ratio : 1;
  // If a device reports less often than the servo samples, one tick has the motion of several.
  const double since = std::clamp(sample.since, dt, std::max(dt, longest_since));
  way_.measure(mass_, {.before = before,
                       .now = X_FM_,
                       .force = out_.wrench.force,
                       .fastest = fastest_.way * ratio,
                       .since = since,
                       .dt = dt});
  runaway_.set_fastest(fastest);
  if (!sample.device && !sample.trial) return runaway_.restart();
  if (!trusted || sample.changed || !(dt > 0)) return runaway_.lose_track();
  if (const HandTrial* trial = sample.trial)
    return runaway_.observe(trial->way, trial->turn, dt, pushed());
  const auto of_hand = [](const Vec3& of_probe, double ratio) {
    return ratio > 0 ? Vec3(of_probe / ratio) : Vec3(Vec3::Zero());
  };
  const Vec3 turn = rotation_vector(X_FM_.q * before.q.conjugate());
  runaway_.observe(of_hand(X_FM_ * mass_.com - before * mass_.com, sample.device->ratio),
                   of_hand(turn, sample.device->turn_ratio), dt, pushed());
}

double HandLoop::most_force() const noexcept {
  const double most = coupler_.coupling().max_force;
  return device_ && device_->max_force > 0 ? std::min(most, device_->max_force) : most;
}

double HandLoop::most_torque() const noexcept {
  const double most = coupler_.coupling().max_torque;
  return device_ && device_->max_torque > 0 ? std::min(most, device_->max_torque) : most;
}

/// The rate is limited for a known device only, since only that can be thrown.
void HandLoop::set_change_rate(const HandSample& sample) noexcept {
  rate_ = {.force = 0, .torque = 0};
  if (sample.device && !sample.trial)
    rate_ = change_rate_at_probe(of_hand_, most_force() * sample.device->ratio,
                                 most_torque() * sample.device->turn_ratio, sample.device->ratio,
                                 sample.device->turn_ratio);
  if (sample.device && !sample.trial)
    whole_rate_ = change_rate_at_probe(of_hand_, sample.device->max_force * sample.device->ratio,
                                       sample.device->max_torque * sample.device->turn_ratio,
                                       sample.device->ratio, sample.device->turn_ratio);
  else
    whole_rate_ = rate_;
  // If the handle yields to the force, as it does if nobody holds it, the force rises more slowly.
  const double share = share_where_it_yields(at_handle(way_.yields()));
  rate_.force *= share;
  rate_.torque *= share;
  gate_.set_change_rate(rate_);
}

void HandLoop::set_coupling(const GainGlide::Blend& blend) noexcept {
  set_ = blend;
  GainGlide::Blend taken = blend;
  out_.hand.capped = false;
  if (device_ && felt_already_) {
    const auto stable = [&](const Coupling& c) {
      BorneGains most = stable_by_estimate(*device_, period_, c, mass_);
      most.translation = at_least(most.translation, felt_already_->k_t);
      most.rotation = at_least(most.rotation, felt_already_->k_r);
      return borne(c, most, mass_);
    };
    taken.now = stable(blend.now);
    taken.before = stable(blend.before);
    if (is_reduced(taken.now, blend.now)) out_.hand.waiting = true;
  }
  out_.hand.gains = taken;
  if (device_) {
    const BorneGains most = borne_by_device(*device_);
    taken.now = borne(taken.now, most, mass_);
    taken.before = borne(taken.before, most, mass_);
    out_.hand.capped = is_reduced(taken.now, out_.hand.gains.now);
  }
  coupler_.set_coupling(taken);
}

/// In a contact, what is another handle to the probe than before bears other gains: those that were
/// stable may not be. They are held below until the contact is left, but not below what is felt
/// already, if that goes on.
void HandLoop::hold_below(double rescaled) noexcept {
  felt_already_ = FeltGains{};
  if (rescaled > 0) {
    felt_already_ = felt_gains(coupler_.coupling(), mass_);
    felt_already_->k_t /= rescaled * rescaled;
  }
  set_coupling(GainGlide::Blend(set_));
}

/// What the coupling wants, and what is carried over from another scale.
Wrench HandLoop::wanted(const HandSample& sample, double dt) noexcept {
  const bool contact = out_.separation.status == Status::penetrating;
  // A device may be known only some ticks after it was handed over, and an answer may fail: what it
  // bears is asked in the first tick of the contact that has both.
  anew_ = anew_ || sample.changed;
  const bool anew = anew_ && contact && device_;
  if (anew || out_.separation.status == Status::separated) anew_ = false;
  if (out_.separation.status == Status::separated) felt_already_.reset();
  if (!contact) carried_.restart();
  const bool scaled = sample.rescaled > 0 && sample.rescaled != 1;
  if (anew)
    hold_below(0);
  else if (scaled && contact && device_)
    hold_below(sample.rescaled);
  const Wrench felt = out_.hand.asked;
  const Wrench now = coupler_.wrench(out_.separation, dt);
  if (!anew && contact && device_ && pushed()) carry_over(felt, now, scaled ? sample.rescaled : 1);
  max_force_ = coupler_.coupling().max_force;
  max_torque_ = coupler_.coupling().max_torque;
  return carried_.added_to(now, whole_rate_, way_.velocity() * at_handle(1), dt);
}

void HandLoop::carry_over(const Wrench& felt, const Wrench& now, double rescaled) noexcept {
  const Coupling& c = coupler_.coupling();
  if (rescaled == 1 && c.max_force >= max_force_ && c.max_torque >= max_torque_) return;
  const double per = 1 / rescaled;
  gate_.rescale(per);
  damping_.force *= per;
  // Of what was asked the hand felt no more than its device can.
  const auto can = [](double most) { return most > 0 ? most : infinity; };
  carried_.carry(
      limit({per * felt.force, felt.torque}, can(device_->max_force), can(device_->max_torque)),
      now);
}

double HandLoop::most_of_glide(const GainGlide& glide, double dt) noexcept {
  const Separation& s = out_.separation;
  out_.hand.waiting = false;
  if (s.status != Status::penetrating || !pushed()) return 1;
  double left = 1;
  if (device_) {
    const double all = share_of_way(glide, *device_, period_, mass_);
    left = std::max(0.0, all - glide.made());
    out_.hand.waiting = all < 1 && left <= 0;
  }
  const auto spring = [&](const Coupling& c) {
    if (in_object_norm(c.mode)) return object_norm_wrench(mass_, s.device, s.separated, c.k);
    return classic_wrench(separation_motion(mass_, s.device, s.separated), Vec3::Zero(),
                          Vec3::Zero(), c);
  };
  const Wrench from = spring(glide.from()), to = spring(glide.to());
  return std::min(left, share_of_change({to.force - from.force, to.torque - from.torque}, rate_,
                                        dt > 0 ? dt : 0));
}

bool HandLoop::pushed() const noexcept {
  return !out_.wrench.force.isZero(0) || !out_.wrench.torque.isZero(0);
}

void HandLoop::separate(const LocalContacts& contacts, const Clock& clock) noexcept {
  const LocalAnswer answer = separate_locally(mass_, method_, contacts, X_FM_);
  out_.separation = answer.separation;
  lag_ = answer.lag;
  out_.separation.jumped = contacts.jumps != jumps_;
  out_.separation.lagged = out_.separation.jumped && contacts.falls == falls_;
  out_.separation.released = contacts.released - released_;
  jumps_ = contacts.jumps;
  falls_ = contacts.falls;
  released_ = contacts.released;
  ids_.follow(out_.separation.separated, mass_.radius, out_.separation.clusters);
  const std::uint64_t age = clock.tick - contacts.tick;
  out_.hand.rows = {.age_ticks = age,
                    .age = clock.now - contacts.time,
                    .in_step = age <= 1,
                    .held_back = answer.held_back,
                    .reach = contacts.reach,
                    .refresh_us = contacts.refresh_us,
                    .residual = contacts.separation.residual,
                    .phases = contacts.separation.phases,
                    .separated = contacts.separation.separated};
}

const HandTick& HandLoop::tick(const HandSample& sample, const LocalContacts& contacts,
                               const Clock& clock, Withheld why) noexcept {
  if (std::exchange(resting_, false)) resumed_ = clock.now;
  follow(sample, clock.dt);
  device_ = sample.device;
  set_change_rate(sample);
  passivity_.set_device(sample.device);
  passivity_.observe(X_FM_, clock.dt, way_.leapt() && device_ && !sample.trial, sample.since);
  separate(contacts, clock);
  if (out_.separation.status == Status::separated) runaway_.release();
  out_.hand.held = sample.held;
  out_.hand.device = sample.device;
  if (sample.trial) {
    try_out(*sample.trial, why == Withheld::nothing ? fault(sample) : why, clock.dt);
    return out_;
  }
  Withheld reason = why == Withheld::nothing ? fault(sample, contacts, clock) : why;
  if (reason == Withheld::nothing && out_.separation.status == Status::failed)
    reason = Withheld::failed;

  out_.hand.asked = wanted(sample, clock.dt);
  const bool given = reason == Withheld::nothing || reason == Withheld::unsettled;
  const bool acts = given && device_ && device_->force;
  gate_.set_slew(way_.slew(mass_, coupler_.coupling(), {most_force(), most_torque()}, rate_,
                           out_.separation.status == Status::separated, clock.dt));
  const Limits most = limits();
  const Wrench passed = gate_.pass(out_.hand.asked, reason, most.force, most.torque, clock.dt);
  way_.spend(passed, clock.dt);
  if (!given) carried_.restart();
  if (!acts) damping_ = Wrench{};
  out_.wrench = acts ? damped(passed, clock.dt) : passed;
  passivity_.rendered(out_.wrench);
  say_gate();
  out_.hand.energy = passivity_.energy();
  return out_;
}

/// Energy in excess is damped behind the gate. While a force still rises to what is wanted, after a
/// jump of the contact, what is taken from the wanted one would not be missed. The damping itself
/// comes no faster than the device's force may change by the hand's own motion, and by the share of
/// the ramp: after a fault it rises from zero too.
Wrench HandLoop::damped(const Wrench& passed, double dt) noexcept {
  const Wrench wanted = passivity_.control(passed);
  const double share = dt > 0 ? dt / HandWay::whole_force : 0;
  const Vec3 force = gate_.share() * (wanted.force - passed.force);
  const Vec3 torque = gate_.share() * (wanted.torque - passed.torque);
  damping_.force = towards(force, damping_.force, share * most_force());
  damping_.torque = towards(torque, damping_.torque, share * most_torque());
  const bool none = passed.force.isZero(0) && passed.torque.isZero(0);
  // No gate comes after this, and what is not a number would stay one in the ticks that follow.
  const bool finite = damping_.force.allFinite() && damping_.torque.allFinite();
  if (none || !finite) damping_ = Wrench{};
  const Limits most = limits();
  return limit({passed.force + damping_.force, passed.torque + damping_.torque}, most.force,
               most.torque);
}

HandLoop::Limits HandLoop::limits() const noexcept {
  const Coupling& c = coupler_.coupling();
  return {std::max(c.max_force, out_.hand.asked.force.norm()),  // NaN: those of the coupling
          std::max(c.max_torque, out_.hand.asked.torque.norm())};
}

/// The wrench of a trial is not counted in the energy, which is that of contacts.
void HandLoop::try_out(HandTrial& trial, Withheld reason, double dt) noexcept {
  coupler_.forget();
  forget_force();
  gate_.set_slew({});
  out_.hand.asked = trial.wrench;
  out_.wrench = gate_.pass(trial.wrench, reason, trial.max_force, trial.max_torque, dt);
  passivity_.rendered(Wrench{});
  say_gate();
  trial.withheld = gate_.withheld();
}

void HandLoop::say_gate() noexcept {
  out_.hand.withheld = gate_.withheld();
  out_.hand.share = gate_.share();
  out_.hand.slewed = gate_.slewed();
}

const HandTick& HandLoop::fade(const HandSample& sample, double dt, double time) noexcept {
  const bool can = sample.device && sample.device->ratio > 0 && !sample.trial && sample.trusted &&
                   sample.held && is_finite(sample.X_FM) && !sample.changed &&
                   out_.hand.withheld == Withheld::nothing && dt > 0 && time > 0;
  if (!can) return rest(Withheld::shut_down);
  device_ = sample.device;
  follow(sample, dt);
  if (fault(sample) != Withheld::nothing) return rest(Withheld::shut_down);
  set_change_rate(sample);
  const double force = out_.wrench.force.norm(), torque = out_.wrench.torque.norm();
  const auto less = [&](const Vec3& of, double size, double rate) {
    const double by = std::max(rate * dt, size * dt / time);
    return size > by ? Vec3(of * (1 - by / size)) : Vec3(Vec3::Zero());
  };
  const double along = at_handle(way_.yields());
  out_.wrench.force = less(out_.wrench.force, force, rate_of_end(force, whole_rate_.force, along));
  out_.wrench.torque =
      less(out_.wrench.torque, torque, rate_of_end(torque, whole_rate_.torque, along));
  return out_;
}

const HandTick& HandLoop::rest(Withheld why) noexcept {
  resting_ = true;
  rest_ = why;
  coupler_.forget();
  gate_.pass(Wrench{}, why, 0, 0, 0);
  forget_force();
  passivity_.rested();
  out_.wrench = Wrench{};
  out_.hand.withheld = why;
  out_.hand.share = 0;
  return out_;
}

}  // namespace sonde
