// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/servo.hpp"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "engine/haptics/ring.hpp"
#include "engine/haptics/schedule.hpp"
#include "engine/haptics/triple_buffer.hpp"

namespace sonde {
namespace {

constexpr std::int64_t second = 1'000'000'000;
constexpr std::size_t history_ticks = 4096;

std::int64_t monotonic_now() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<std::int64_t>(t.tv_sec) * second + t.tv_nsec;
}

void sleep_until(std::int64_t due) noexcept {
  timespec t{};
  t.tv_sec = static_cast<time_t>(due / second);
  t.tv_nsec = static_cast<long>(due % second);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
}

std::int64_t period_of(double rate_hz) {
  constexpr double slowest = 1, fastest = 1e5;
  const double rate = rate_hz >= slowest ? std::min(rate_hz, fastest) : slowest;  // NaN: slowest
  return std::llround(static_cast<double>(second) / rate);
}

}  // namespace

struct Servo::State {
  HapticLoop loop;
  ServoSettings settings;
  Coupling coupling;  ///< the newest asked for, as the calling thread knows it
  bool seen = false;  ///< the reader's side of `snapshots` holds a tick of this run

  TripleBuffer<Pose> poses;
  TripleBuffer<Coupling> couplings;
  TripleBuffer<Snapshot> snapshots;
  Ring<Snapshot> history{history_ticks};
  std::atomic<bool> stopping{false};
  std::atomic<bool> paused{false};
  std::thread thread;

  State(HapticLoop l, const ServoSettings& s, const Coupling& c)
      : loop(std::move(l)), settings(s), coupling(c) {}

  // On the servo thread.
  class Run;
  bool wait_for(std::int64_t due) noexcept;
  void take_commands() noexcept;
};

/// False where the servo is to stop. The sleep is cut in slices, so that a slow loop stops promptly
/// too.
bool Servo::State::wait_for(std::int64_t due) noexcept {
  constexpr std::int64_t slice = 20'000'000;
  for (;;) {
    if (stopping.load(std::memory_order_relaxed)) return false;
    const std::int64_t now = monotonic_now();
    if (now >= due) return true;
    sleep_until(std::min(due, now + slice));
  }
}

void Servo::State::take_commands() noexcept {
  if (couplings.update()) loop.set_coupling(couplings.front());
  poses.update();
}

/// One run of the servo thread, from start() to stop().
class Servo::State::Run {
 public:
  explicit Run(State& state)
      : s_(state),
        start_(monotonic_now()),
        schedule_{.period = period_of(state.settings.rate_hz), .due = start_} {}

  void go() noexcept {
    while (s_.wait_for(schedule_.due)) {
      const std::int64_t begin = monotonic_now();
      if (s_.paused.load(std::memory_order_relaxed))
        idle(begin);
      else
        tick(begin);
    }
  }

 private:
  void idle(std::int64_t begin) noexcept {
    if (!snapshot_.paused && snapshot_.tick > 0) {
      snapshot_.paused = true;
      s_.snapshots.write(snapshot_);
    }
    meter_ = RateMeter{};
    last_begin_ = 0;
    schedule_.finish(begin);  // an idle period is never counted as late
  }

  void tick(std::int64_t begin) noexcept {
    s_.take_commands();
    const double dt = last_begin_ == 0 ? 0 : static_cast<double>(begin - last_begin_) * 1e-9;
    s_.loop.tick(s_.poses.front(), dt, s_.settings.budget);
    last_begin_ = begin;
    meter_.tick(begin);
    publish(begin, monotonic_now());
  }

  void publish(std::int64_t begin, std::int64_t end) noexcept {
    ++snapshot_.tick;
    snapshot_.time = static_cast<double>(begin - start_) * 1e-9;
    snapshot_.separation = s_.loop.separation();
    snapshot_.wrench = s_.loop.wrench();
    snapshot_.tick_us = static_cast<double>(end - begin) * 1e-3;
    snapshot_.rate_hz = meter_.rate();
    snapshot_.paused = false;
    if (schedule_.finish(end)) ++snapshot_.late;
    s_.snapshots.write(snapshot_);
    s_.history.push(snapshot_);
  }

  State& s_;
  std::int64_t start_;
  Schedule schedule_;
  RateMeter meter_;
  Snapshot snapshot_;
  std::int64_t last_begin_ = 0;  ///< 0: no tick right before this one, so no rates from it
};

Servo::Servo(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed, Method method,
             const Coupling& coupling, const ServoSettings& settings)
    : state_(std::make_unique<State>(
          HapticLoop(std::move(probe), std::move(fixed), method, coupling), settings, coupling)) {}

Servo::~Servo() { stop(); }

void Servo::start(const Pose& X_FM) {
  stop();
  State& s = *state_;
  s.loop.set_coupling(s.coupling);
  s.loop.reset(X_FM, StaticOptions{});
  s.poses.fill(X_FM);
  s.couplings.fill(s.coupling);
  s.snapshots.fill(Snapshot{});
  s.history.clear();
  s.seen = false;
  s.stopping.store(false, std::memory_order_relaxed);
  s.thread = std::thread([&s] { State::Run(s).go(); });
}

void Servo::stop() {
  if (!state_->thread.joinable()) return;
  state_->stopping.store(true, std::memory_order_relaxed);
  state_->thread.join();
}

bool Servo::running() const { return state_->thread.joinable(); }

void Servo::set_device_pose(const Pose& X_FM) { state_->poses.write(X_FM); }

void Servo::set_coupling(const Coupling& coupling) {
  state_->coupling = coupling;
  state_->couplings.write(coupling);
}

void Servo::set_paused(bool paused) { state_->paused.store(paused, std::memory_order_relaxed); }

const Snapshot* Servo::latest() {
  if (state_->snapshots.update()) state_->seen = true;
  return state_->seen ? &state_->snapshots.front() : nullptr;
}

bool Servo::next_tick(Snapshot& out) { return state_->history.pop(out); }

std::uint64_t Servo::ticks_dropped() const { return state_->history.lost(); }

}  // namespace sonde
