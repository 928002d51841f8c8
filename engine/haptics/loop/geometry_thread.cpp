// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/geometry_thread.hpp"

#include <chrono>

#include "engine/haptics/loop/loop_tuning.hpp"
#include "engine/haptics/loop/refresh_limit.hpp"
#include "engine/platform/real_time.hpp"

namespace sonde {
namespace {

StaticOptions quick_search() {
  StaticOptions options;
  options.starts = loop_tuning.starts_at_begin;
  options.agreement = loop_tuning.agreement_at_begin;
  return options;
}

/// Linux stops real-time threads that take more than 95 % of a second (sched_rt_runtime_us) for the
/// rest of that second: 50 ms, longer than rows may age. So a thread that is busy without pause
/// rests for a tenth of its time.
void rest(double busy_us) noexcept {
  std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(busy_us / 9));
}

}  // namespace

GeometryThread::GeometryThread(const Pair& pair, Method method, const Budget& budget,
                               bool real_time)
    : feed_(pair, method),
      budget_(budget),
      budget_us_(budget.microseconds),
      real_time_(real_time) {}

GeometryThread::~GeometryThread() { stop(); }

void GeometryThread::start(const Pose& X_FM) {
  stop();
  contacts_.fill(feed_.reset(X_FM, quick_search()));
  requests_.fill({.X_FM = X_FM, .tick = 0, .time = 0});
  asked_.store(0, std::memory_order_relaxed);
  stopping_.store(false, std::memory_order_relaxed);
  thread_ = std::thread([this] { run(); });
}

void GeometryThread::stop() {
  if (!thread_.joinable()) return;
  stopping_.store(true, std::memory_order_relaxed);
  asked_.fetch_add(1, std::memory_order_release);
  asked_.notify_one();
  thread_.join();
}

void GeometryThread::ask(const Pose& X_FM, std::uint64_t tick, double time) noexcept {
  requests_.write({.X_FM = X_FM, .tick = tick, .time = time});
  asked_.fetch_add(1, std::memory_order_release);
  asked_.notify_one();  // a system call only if the thread sleeps
}

const LocalContacts& GeometryThread::newest() noexcept {
  contacts_.update();
  return contacts_.front();
}

void GeometryThread::run() noexcept {
  name_thread("sonde-geometry");
  touch_stack();
  if (real_time_) {
    request_precedence();
    request_processor(LoopThread::geometry);
  }
  std::int32_t seen = 0;
  RefreshLimit limit;
  for (;;) {
    asked_.wait(seen, std::memory_order_acquire);
    seen = asked_.load(std::memory_order_acquire);
    if (stopping_.load(std::memory_order_relaxed)) return;
    if (!requests_.update()) continue;
    const Request& request = requests_.front();
    budget_.microseconds = budget_us_.load(std::memory_order_relaxed);
    Budget patient = budget_;
    patient.microseconds = limit.of(budget_.microseconds);
    feed_.time_phases(time_phases_.load(std::memory_order_relaxed));
    const LocalContacts& found =
        feed_.refresh(request.X_FM, request.tick, request.time, patient, budget_);
    limit.learn(found.separation.converged);
    contacts_.write(found);
    if (stopping_.load(std::memory_order_relaxed)) return;
    if (real_time_ && asked_.load(std::memory_order_relaxed) != seen) rest(found.refresh_us);
  }
}

}  // namespace sonde
