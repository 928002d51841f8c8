// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/servo.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "engine/base/ring.hpp"
#include "engine/base/triple_buffer.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"
#include "engine/haptics/loop/geometry_thread.hpp"
#include "engine/haptics/loop/schedule.hpp"
#include "engine/platform/clock.hpp"

namespace sonde {
namespace {

constexpr std::int64_t second = 1'000'000'000;
constexpr std::size_t history_ticks = 4096;

double possible_rate(double rate_hz) {
  constexpr double slowest = 1, fastest = 1e5;
  return rate_hz >= slowest ? std::min(rate_hz, fastest) : slowest;  // NaN: slowest
}

HandLoopSettings hand_settings(const ServoSettings& settings) {
  return {.rate_hz = possible_rate(settings.rate_hz),
          .safety = settings.safety,
          .passivity = settings.passivity};
}

}  // namespace

struct Servo::State {
  HandLoop loop;
  GeometryThread geometry;
  ServoSettings settings;
  Coupling coupling;  ///< the newest requested gains, for the calling thread
  GainGlide glide;    ///< to these gains, on the servo thread
  bool seen = false;  ///< the reader has seen a tick of this run in `snapshots`
  Hand hand;

  TripleBuffer<Pose> poses;
  TripleBuffer<Coupling> couplings;
  TripleBuffer<Snapshot> snapshots;
  TripleBuffer<ServoTiming> timings;
  Ring<Snapshot> history{history_ticks};
  std::atomic<bool> stopping{false};
  std::atomic<bool> paused{false};
  std::atomic<bool> force{true};
  std::atomic<double> rate_hz;
  std::atomic<bool> passivity_control;
  std::thread thread;

  State(const Pair& pair, Method method, const ServoSettings& s, const Coupling& c)
      : loop(pair.probe().mass, method, c, hand_settings(s)),
        geometry(pair, method, s.budget, s.real_time),
        settings(s),
        coupling(c),
        glide(c),
        rate_hz(possible_rate(s.rate_hz)),
        passivity_control(s.passivity.control) {}

  // Used on the servo thread.
  class Run;
  bool wait_for(std::int64_t due) noexcept;
};

/// Returns false if the servo is to stop. The sleep is cut into slices, so that a slow loop also
/// stops promptly.
bool Servo::State::wait_for(std::int64_t due) noexcept {
  constexpr std::int64_t slice = 20'000'000;
  for (;;) {
    if (stopping.load(std::memory_order_relaxed)) return false;
    const std::int64_t now = monotonic_ns();
    if (now >= due) return true;
    sleep_until_ns(std::min(due, now + slice));
  }
}

/// One run of the servo thread, from start() to stop().
class Servo::State::Run {
 public:
  explicit Run(State& state) : s_(state), start_(monotonic_ns()), schedule_{.due = start_} {}

  void go() noexcept {
    name_thread("sonde-servo");
    touch_stack();
    if (s_.settings.real_time) timing_.real_time = request_real_time();
    schedule_.due = start_ = monotonic_ns();
    while (s_.wait_for(schedule_.due)) {
      const std::int64_t begin = monotonic_ns();
      take_settings();
      if (s_.paused.load(std::memory_order_relaxed) || fade_left_ > 0)
        idle(begin);
      else
        tick(begin);
    }
    end();
  }

 private:
  void take_settings() noexcept {
    s_.loop.set_passivity_control(s_.passivity_control.load(std::memory_order_relaxed));
    const double rate_hz = s_.rate_hz.load(std::memory_order_relaxed);
    if (rate_hz == rate_hz_) return;
    rate_hz_ = rate_hz;
    schedule_.period = std::llround(static_cast<double>(second) / rate_hz);
    s_.loop.set_rate(rate_hz);
  }

  void render(const Wrench& wrench) noexcept {
    if (s_.hand.render) s_.hand.render(wrench);
  }

  HandSample sample(std::int64_t begin) noexcept {
    const double dt = last_sample_ == 0 ? 0 : static_cast<double>(begin - last_sample_) * 1e-9;
    last_sample_ = begin;
    return s_.hand.sample(dt);
  }

  void idle(std::int64_t begin) noexcept {
    const HandSample hand = sample(begin);
    if (last_begin_ != 0) fade_left_ = HandLoop::longest_fade;
    const Wrench left = faded(hand);
    render(fade_left_ > 0 ? left : s_.loop.rest(Withheld::paused).wrench);
    if (!snapshot_.paused && snapshot_.tick > 0) {
      snapshot_.paused = true;
      snapshot_.hand.withheld = Withheld::paused;
      s_.snapshots.write(snapshot_);
      s_.history.push(snapshot_);
    }
    meter_ = RateMeter{};
    last_begin_ = 0;
    schedule_.finish(begin);  // an idle period is never counted as late
  }

  void tick(std::int64_t begin) noexcept {
    const std::int64_t since = last_begin_ == 0 ? 0 : begin - last_begin_;
    last_begin_ = begin;
    const HandLoop::Clock clock{.tick = snapshot_.tick + 1,
                                .now = static_cast<double>(begin - start_) * 1e-9,
                                .dt = static_cast<double>(since) * 1e-9};
    if (s_.couplings.update()) s_.glide.set(s_.couplings.front());
    const GainGlide::Blend& gains =
        s_.glide.next(clock.dt, s_.loop.most_of_glide(s_.glide, clock.dt));
    s_.loop.set_coupling(gains);
    snapshot_.coupling = gains.now;
    const HandSample hand = sample(begin);
    const LocalContacts& contacts = s_.geometry.newest();
    const Withheld why =
        s_.force.load(std::memory_order_relaxed) ? Withheld::nothing : Withheld::stopped;
    const HandTick& done = s_.loop.tick(hand, contacts, clock, why);
    render(done.wrench);
    if (s_.hand.follow) s_.hand.follow(s_.loop.behind());
    s_.geometry.ask(s_.loop.device(), clock.tick, clock.now);
    meter_.tick(begin);
    const std::int64_t end = monotonic_ns();
    measure(since, end - begin, done.hand.rows);
    publish(clock, end, done);
  }

  void measure(std::int64_t period, std::int64_t time, const RowsUsed& rows) noexcept {
    if (period > 0) timing_.period.add(static_cast<double>(period) * 1e-3);
    timing_.tick.add(static_cast<double>(time) * 1e-3);
    timing_.age.add(rows.age * 1e6);
    if (rows.age_ticks < last_age_ + 1) timing_.geometry.add(rows.refresh_us);  // new rows
    last_age_ = rows.age_ticks;
    ++timing_.ticks;
    timing_.in_step += rows.in_step;
  }

  void publish(const HandLoop::Clock& clock, std::int64_t end, const HandTick& done) noexcept {
    snapshot_.tick = clock.tick;
    snapshot_.time = clock.now;
    snapshot_.separation = done.separation;
    snapshot_.wrench = done.wrench;
    snapshot_.hand = done.hand;
    snapshot_.tick_us = static_cast<double>(end - last_begin_) * 1e-3;
    snapshot_.rate_hz = meter_.rate();
    snapshot_.paused = false;
    if (schedule_.finish(end)) ++snapshot_.late;
    timing_.late = snapshot_.late;
    s_.snapshots.write(snapshot_);
    s_.history.push(snapshot_);
    s_.timings.write(timing_);
  }

  /// Lets the force of a pressed hand fall gradually: the loop pauses, or another scene or method
  /// may begin soon.
  Wrench faded(const HandSample& hand) noexcept {
    if (!s_.force.load(std::memory_order_relaxed)) fade_left_ = 0;
    if (!(fade_left_ > 0)) return {};
    const double dt = static_cast<double>(schedule_.period) * 1e-9;
    Wrench left = s_.loop.fade(hand, dt, fade_left_).wrench;
    fade_left_ = left.force.isZero(0) && left.torque.isZero(0) ? 0 : fade_left_ - dt;
    return left;
  }

  /// Renders the final zero wrench.
  void end() noexcept {
    if (last_begin_ != 0) fade_left_ = HandLoop::longest_fade;
    while (fade_left_ > 0) {
      render(faded(sample(monotonic_ns())));
      if (fade_left_ > 0) sleep_until_ns(monotonic_ns() + schedule_.period);
    }
    render(Wrench{});
    if (snapshot_.tick == 0) return;
    snapshot_.wrench = Wrench{};
    snapshot_.hand.withheld = Withheld::shut_down;
    s_.snapshots.write(snapshot_);
  }

  State& s_;
  std::int64_t start_;
  Schedule schedule_;
  double rate_hz_ = 0;  ///< rate of the schedule; 0: none yet
  RateMeter meter_;
  Snapshot snapshot_;
  ServoTiming timing_;
  std::int64_t last_begin_ = 0;   ///< 0: no tick directly before this one, so no rates
  double fade_left_ = 0;          ///< s, for which a force may still fall; 0: there is none
  std::int64_t last_sample_ = 0;  ///< 0: none yet
  std::uint64_t last_age_ = 0;
};

Servo::Servo(const Pair& pair, Method method, const Coupling& coupling,
             const ServoSettings& settings)
    : state_(std::make_unique<State>(pair, method, settings, coupling)) {}

Servo::~Servo() { stop(); }

void Servo::start(const Pose& X_FM) {
  stop();
  TripleBuffer<Pose>& poses = state_->poses;
  start(X_FM, {.sample =
                   [&poses](double) {
                     poses.update();
                     return HandSample{.X_FM = poses.front()};
                   },
               .render = {}});
}

void Servo::start(const Pose& X_FM, Hand hand) {
  stop();
  State& s = *state_;
  s.hand = std::move(hand);
  s.glide.restart(s.coupling);
  s.loop.restart(X_FM);
  s.geometry.start(X_FM);
  s.poses.fill(X_FM);
  s.couplings.fill(s.coupling);
  s.snapshots.fill(Snapshot{});
  s.timings.fill(ServoTiming{});
  s.history.clear();
  s.seen = false;
  s.stopping.store(false, std::memory_order_relaxed);
  s.thread = std::thread([&s] { State::Run(s).go(); });
}

void Servo::stop() {
  if (!state_->thread.joinable()) return;
  state_->stopping.store(true, std::memory_order_relaxed);
  state_->thread.join();
  state_->geometry.stop();
}

bool Servo::running() const { return state_->thread.joinable(); }

void Servo::set_device_pose(const Pose& X_FM) { state_->poses.write(X_FM); }

void Servo::set_coupling(const Coupling& coupling) {
  state_->coupling = coupling;
  state_->couplings.write(coupling);
}

void Servo::set_rate(double rate_hz) {
  state_->rate_hz.store(possible_rate(rate_hz), std::memory_order_relaxed);
}

void Servo::set_passivity_control(bool on) {
  state_->passivity_control.store(on, std::memory_order_relaxed);
}

void Servo::set_budget_us(double time_us) { state_->geometry.set_budget_us(time_us); }

void Servo::set_time_phases(bool on) { state_->geometry.set_time_phases(on); }

void Servo::set_paused(bool paused) { state_->paused.store(paused, std::memory_order_relaxed); }

void Servo::set_force(bool on) { state_->force.store(on, std::memory_order_relaxed); }

const Snapshot* Servo::latest() {
  if (state_->snapshots.update()) state_->seen = true;
  return state_->seen ? &state_->snapshots.front() : nullptr;
}

const ServoTiming& Servo::timing() {
  state_->timings.update();
  return state_->timings.front();
}

bool Servo::next_tick(Snapshot& out) { return state_->history.pop(out); }

std::uint64_t Servo::ticks_dropped() const { return state_->history.lost(); }

}  // namespace sonde
