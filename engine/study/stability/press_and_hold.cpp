// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/press_and_hold.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/study/rendering/discontinuities.hpp"
#include "engine/study/stability/chatter.hpp"

namespace sonde {
namespace {

/// In whole ticks, so that rounding of times does not decide where a window ends.
struct Timetable {
  std::int64_t rise, knock_begin, knock_end, first, second, end;

  Timetable(const Press& p, double T) {
    const auto ticks = [T](double time) {
      return std::max<std::int64_t>(1, std::llround(time / T));
    };
    rise = ticks(p.rise_time);
    knock_begin = rise + ticks(p.settle_time);
    knock_end = knock_begin + ticks(p.knock_time);
    first = knock_end + ticks(p.settle_time);
    second = first + ticks(p.window_time);
    end = second + ticks(p.window_time);
  }
  bool knocking(std::int64_t tick) const { return tick >= knock_begin && tick < knock_end; }
  double push(std::int64_t tick) const { return std::min(1.0, double(tick) / double(rise)); }
};

Wrench push_at(std::int64_t tick, const Press& press, const Timetable& times) {
  const bool knocking = times.knocking(tick);
  const double by = times.push(tick) + (knocking ? press.knock : 0);
  const Wrench jolt = knocking ? press.jolt : Wrench{};
  return {by * press.push.force + jolt.force, by * press.push.torque + jolt.torque};
}

/// Root mean square of a difference over that of the reference.
struct Error {
  double difference = 0, reference = 0;
  void add(const Vec3& is, const Vec3& should) {
    difference += (is - should).squaredNorm();
    reference += should.squaredNorm();
  }
  double value() const { return reference > 0 ? std::sqrt(difference / reference) : 0; }
};

/// Collects the results, tick by tick.
class Observer {
 public:
  Observer(const ClosedLoop& loop, const Timetable& times) : loop_(loop), times_(times) {
    hold_.reserve(static_cast<std::size_t>(times.end - times.first));
  }

  void look(std::int64_t tick, const HandleState& before) {
    const Separation& s = loop_.haptic_loop().separation();
    const Wrench& motors = loop_.device().motors();
    if (s.status == Status::failed) ++out_.failures;
    const ClosedLoopSetup& setup = loop_.setup();
    const MassProperties& mass = setup.pair.probe().mass;
    const Wrench hooke = spring_wrench(mass, s, setup.coupling);
    count_breaks(mass, s, hooke);
    touched_ |= s.status == Status::penetrating;
    if (touched_) {
      const Wrench commanded = commanded_wrench(setup, s, before_);
      force_.add(motors.force, commanded.force);
      torque_.add(motors.torque, commanded.torque);
    }
    before_ = last_separation(mass, s);
    if (tick == times_.first) hold_from_ = loop_.device().state().X_WD;
    if (tick >= times_.first) look_at_hold(tick, before, s, motors);
  }

  /// What it has done cannot be made good: energies only add up.
  bool lost(const Press& press) const {
    if (out_.failures > 0) return true;
    const double first = energy_[0] / double(times_.second - times_.first);
    const double kinetic = energy_[1] / double(times_.end - times_.second);
    const double quiet = quiet_energy(press, loop_.setup().device);
    return kinetic > quiet && kinetic >= press.decay * std::max(first, quiet);
  }

  HoldReport report(const Press& press, HoldQuestion question) {
    const ClosedLoopSetup& setup = loop_.setup();
    const double n = double(std::max<std::size_t>(1, hold_.size()));
    for (double* mean : {&out_.depth, &out_.contact, &out_.saturation, &out_.force, &out_.torque})
      *mean /= n;
    const double first = energy_[0] / double(times_.second - times_.first);
    out_.kinetic = energy_[1] / double(times_.end - times_.second);
    const double quiet = quiet_energy(press, setup.device);
    const bool still = out_.kinetic <= quiet;
    out_.growth = still ? 0 : out_.kinetic / std::max(first, quiet);
    out_.stable = (still || out_.growth < press.decay) && out_.contact > 0.5 && out_.failures == 0;
    if (question == HoldQuestion::figures) listen();
    out_.saturated = out_.saturation > saturation_limit;
    out_.force_error = force_.value();
    out_.torque_error = torque_.value();
    return out_;
  }

 private:
  void count_breaks(const MassProperties& mass, const Separation& s, const Wrench& hooke) {
    RenderedTick now;
    now.moved = Chart(mass, device_).coordinates(s.device).norm();
    now.force = hooke.force;
    now.depth = s.status == Status::penetrating ? s.depth : 0;
    now.failed = s.status == Status::failed;
    if (s.fell()) ++out_.jumps;
    if (popped_through(last_, now, mass.radius)) ++out_.pop_throughs;
    last_ = now;
    device_ = s.device;
  }

  void listen() {
    const ClosedLoopSetup& setup = loop_.setup();
    const double length = std::sqrt(setup.pair.probe().mass.inertia.maxCoeff());
    const Chatter heard = chatter(hold_, setup.sample_time, felt_handle(setup), length);
    out_.chattering = heard.buzzes();
    out_.chatter = out_.chattering ? heard.force : 0;
  }

  void look_at_hold(std::int64_t tick, const HandleState& before, const Separation& s,
                    const Wrench& motors) {
    const HandleState& now = loop_.device().state();
    energy_[tick < times_.second ? 0 : 1] += kinetic_energy(loop_.setup().device, now);
    // The motors' force is constant over most of a tick, so the trapezoidal rule on velocities
    // gives its work.
    out_.work += loop_.setup().sample_time / 2 *
                 (motors.force.dot(before.velocity + now.velocity) +
                  motors.torque.dot(before.spin + now.spin));
    out_.depth += s.status == Status::penetrating ? s.depth : 0;
    out_.contact += s.status == Status::penetrating ? 1 : 0;
    out_.saturation += loop_.haptic_loop().wrench().saturated ? 1 : 0;
    out_.force += motors.force.norm();
    out_.torque += motors.torque.norm();
    hold_.push_back(felt_tick(now, motors, hold_from_));
  }

  const ClosedLoop& loop_;
  const Timetable& times_;
  HoldReport out_;
  Error force_, torque_;
  std::optional<LastSeparation> before_;
  std::vector<FeltTick> hold_;
  Pose hold_from_;
  double energy_[2] = {0, 0};
  RenderedTick last_;
  Pose device_;
  bool touched_ = false;
};

}  // namespace

HoldReport press_and_hold(ClosedLoop& loop, const Press& press, HoldQuestion question) {
  const Timetable times(press, loop.setup().sample_time);
  Observer observer(loop, times);
  loop.reset(press.X_FM);
  for (std::int64_t tick = 0; tick < times.end; ++tick) {
    const HandleState before = loop.device().state();
    loop.step(press.X_FM, push_at(tick, press, times));
    observer.look(tick, before);
    if (question == HoldQuestion::outcome && observer.lost(press)) break;
  }
  return observer.report(press, question);
}

Wrench push_at(const Press& press, double sample_time, std::int64_t tick) {
  return push_at(tick, press, Timetable(press, sample_time));
}

std::int64_t first_window_of(const Press& press, double sample_time) {
  return Timetable(press, sample_time).first;
}

double quiet_energy(const Press& press, const SimulatedDeviceParameters& device) {
  return device.translation.inertia * press.quiet_speed * press.quiet_speed / 2;
}

std::int64_t tick_count(const Press& press, double sample_time) {
  return Timetable(press, sample_time).end;
}

}  // namespace sonde
