// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/pulse_player.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/result.hpp"

namespace sonde {
namespace {

/// Pulses of an axis grow, and so do their excursions: a pulse whose excursion is this much smaller
/// than an earlier one's was held by somebody. Remaining gravity, and friction that is not uniform,
/// have a smaller effect.
constexpr double held_share = 0.2;
constexpr double far = 3;  // times the intended travel
/// In rests: additional time for a handle that still moves when a pulse is due. A late tick makes a
/// pulse longer than planned, and a heavy handle needs time to stop.
constexpr std::size_t most_waits = 4;
/// In rests, in total: the recording is then half as long again, and has no room for more.
constexpr std::size_t most_waits_in_all = 40;

Vec3 way(const Pose& from, const Pose& to) { return to.p - from.p; }
Vec3 turn(const Pose& from, const Pose& to) { return rotation_vector(to.q * from.q.conjugate()); }

double along(const Pulse& pulse, const Pose& from, const Pose& to) {
  const Vec3 moved = pulse.axis < 3 ? way(from, to) : turn(from, to);
  return std::abs(moved[static_cast<Eigen::Index>(pulse.axis % 3)]);
}

bool beyond(const Pose& from, const Pose& to, double travel, double angle) {
  return !(way(from, to).norm() <= travel) || !(turn(from, to).norm() <= angle);
}

}  // namespace

PulseBounds bounds_of(const PulsePlan& plan, const PulseLimits& limits) {
  PulseBounds bounds;
  for (const Pulse& pulse : plan.pulses) {
    double& most = pulse.axis < 3 ? bounds.force : bounds.torque;
    most = std::max(most, std::abs(pulse.amplitude));
  }
  bounds.travel = far * limits.travel;
  bounds.turn = far * limits.turn;
  return bounds;
}

const char* words(PulsesEnd end) {
  switch (end) {
    case PulsesEnd::none:
    case PulsesEnd::done:
      return "";
    case PulsesEnd::stopped:
      return "cancelled";
    case PulsesEnd::withheld:
      return "the loop withheld the force";
    case PulsesEnd::lost:
      return "the device is gone, or its pose cannot be true";
    case PulsesEnd::restless:
      return "the handle was not at rest between pulses: let go of it, and keep it from drifting";
    case PulsesEnd::held:
      return "a pulse moved the handle much less than a smaller one before: let go of it, and keep "
             "its way clear";
    case PulsesEnd::drifted:
      return "the handle went too far from where it began: begin in the middle of its workspace, "
             "or with less force and travel";
  }
  return "";
}

PulsePlayer::PulsePlayer(const PulsePlan& plan, const PulseBounds& bounds)
    : bounds_(bounds),
      watched_rest_(plan.rest / 3),
      longest_wait_(most_waits * plan.rest),
      left_to_wait_(most_waits_in_all * plan.rest),
      commands_(commands_of(plan)),
      rows_(commands_.size() + left_to_wait_ + watched_rest_) {
  std::size_t begin = plan.rest;
  for (const Pulse& pulse : plan.pulses) {
    pulses_.push_back({pulse, begin, begin + 4 * pulse.part});
    begin = pulses_.back().end + plan.rest;
  }
  trial_.max_force = bounds.force;
  trial_.max_torque = bounds.torque;
}

void PulsePlayer::finish(PulsesEnd end) noexcept { end_.store(end, std::memory_order_release); }

bool PulsePlayer::restless(const Pose& X_BH) noexcept {
  if (pulse_ >= pulses_.size()) return false;
  const std::size_t due = pulses_[pulse_].begin, watched = due - watched_rest_;
  if (place_ < watched || place_ > due) return false;
  if (place_ == watched) rest_ = X_BH;
  if (!beyond(rest_, X_BH, bounds_.rest_travel, bounds_.rest_turn)) return false;
  const std::size_t more = place_ - watched;
  waited_ += more;
  if (waited_ > longest_wait_ || more > left_to_wait_) return true;
  left_to_wait_ -= more;
  place_ = watched;
  rest_ = X_BH;
  return false;
}

/// Follows the current pulse, from its first sample to the one after its last.
bool PulsePlayer::held(const Pose& X_BH) noexcept {
  if (pulse_ >= pulses_.size() || place_ <= pulses_[pulse_].begin) return false;
  const Timed& present = pulses_[pulse_];
  excursion_ = std::max(excursion_, along(present.pulse, rest_, X_BH));
  if (place_ < present.end) return false;
  double& largest = largest_[present.pulse.axis];
  const bool is_held = excursion_ < held_share * largest;
  largest = std::max(largest, excursion_);
  excursion_ = 0;
  waited_ = 0;
  ++pulse_;
  return is_held;
}

PulsesEnd PulsePlayer::watch(double t, const Pose& X_BH, bool trusted) noexcept {
  const Withheld why = trial_.withheld;
  if (stopping_.load(std::memory_order_relaxed)) return PulsesEnd::stopped;
  if (!trusted || !is_finite(X_BH) || !std::isfinite(t)) return PulsesEnd::lost;
  // The tick in which a hand is taken over has no force, and no force was requested in it.
  if (why != Withheld::nothing && why != Withheld::changed) {
    withheld_.store(why, std::memory_order_relaxed);
    return PulsesEnd::withheld;
  }
  if (beyond(start_, X_BH, bounds_.travel, bounds_.turn)) return PulsesEnd::drifted;
  if (restless(X_BH)) return PulsesEnd::restless;
  return held(X_BH) ? PulsesEnd::held : PulsesEnd::none;
}

HandTrial& PulsePlayer::next(double t, const Pose& X_BH, bool trusted) noexcept {
  const bool ended = end_.load(std::memory_order_relaxed) != PulsesEnd::none;
  if (played_.load(std::memory_order_relaxed) == 0) start_ = last_ = rest_ = X_BH;
  if (!ended)
    if (const PulsesEnd end = watch(t, X_BH, trusted); end != PulsesEnd::none) finish(end);
  asked_ = end_.load(std::memory_order_relaxed) == PulsesEnd::none;
  trial_.wrench = asked_ ? commands_[place_] : Wrench{};
  trial_.withheld = Withheld::nothing;
  const bool follows = trusted && is_finite(X_BH);
  trial_.way = follows ? way(last_, X_BH) : Vec3(Vec3::Zero());
  trial_.turn = follows ? turn(last_, X_BH) : Vec3(Vec3::Zero());
  if (follows) last_ = X_BH;
  now_ = {t, {}, X_BH};
  return trial_;
}

void PulsePlayer::rendered(const Wrench& wrench) noexcept {
  if (!asked_) return;  // a resting loop renders without a sample
  asked_ = false;
  const std::size_t row = played_.load(std::memory_order_relaxed);
  now_.command = wrench;
  rows_[row] = now_;
  played_.store(row + 1, std::memory_order_release);
  ++place_;
  reached_.store(std::max(place_, reached_.load(std::memory_order_relaxed)),
                 std::memory_order_relaxed);
  if (place_ == commands_.size()) finish(PulsesEnd::done);
}

PulseProgress PulsePlayer::progress() const noexcept {
  PulseProgress out{.end = end_.load(std::memory_order_acquire),
                    .withheld = withheld_.load(std::memory_order_relaxed),
                    .sample = reached_.load(std::memory_order_relaxed),
                    .samples = commands_.size(),
                    .pulse = 0,
                    .pulses = pulses_.size()};
  out.pulse = static_cast<std::size_t>(
      std::ranges::count_if(pulses_, [&](const Timed& each) { return each.begin < out.sample; }));
  return out;
}

Response PulsePlayer::response() const {
  const auto played = static_cast<std::ptrdiff_t>(played_.load(std::memory_order_acquire));
  return {rows_.begin(), rows_.begin() + played};
}

}  // namespace sonde
