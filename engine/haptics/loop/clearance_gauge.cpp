// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/clearance_gauge.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/body/body.hpp"
#include "engine/platform/real_time.hpp"
#include "engine/proximity/queries/distance.hpp"

namespace sonde {
namespace {

bool same(const Pose& a, const Pose& b) { return a.p == b.p && a.q.coeffs() == b.q.coeffs(); }

}  // namespace

std::optional<double> signed_clearance(const Separation& separation,
                                       const GaugedClearance* measured) {
  switch (separation.status) {
    case Status::penetrating:
      return 0 - separation.depth;  // no -0
    case Status::separated:
      return measured ? std::optional(measured->distance) : std::nullopt;
    case Status::failed:
      break;
  }
  return {};
}

struct ClearanceGauge::State {
  explicit State(const Pair& bodies) : pair(bodies) {}

  Pair pair;
  std::optional<DistanceHint> hint;  ///< used by the thread only: the last pair of triangles
  std::mutex mutex;                  ///< guards the three below
  std::optional<Pose> wanted;
  std::optional<GaugedClearance> newest;
  bool stopping = false;
  std::condition_variable asked, answered;
  std::thread thread;

  GaugedClearance measure(const Pose& X_FM) {
    const Distance d = distance(pair.probe(), pair.fixed(), Transform(X_FM), hint);
    hint = DistanceHint{d.triangle_a, d.triangle_b};
    return {X_FM, d.distance, d.on_a, d.on_b};
  }

  void run() {
    name_thread("sonde-clear");
    std::unique_lock lock(mutex);
    for (;;) {
      asked.wait(lock, [this] { return stopping || wanted; });
      if (stopping) return;
      const Pose X_FM = *std::exchange(wanted, std::nullopt);
      lock.unlock();
      const GaugedClearance found = measure(X_FM);
      lock.lock();
      newest = found;
      answered.notify_all();
    }
  }
};

ClearanceGauge::ClearanceGauge(const Pair& pair) : state_(std::make_unique<State>(pair)) {
  State& s = *state_;
  s.thread = std::thread([&s] { s.run(); });
}

ClearanceGauge::~ClearanceGauge() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->asked.notify_one();
  state_->thread.join();
}

std::optional<GaugedClearance> ClearanceGauge::at(const Pose& X_FM,
                                                  std::chrono::microseconds patience) {
  State& s = *state_;
  std::unique_lock lock(s.mutex);
  const auto there = [&] { return s.newest && same(s.newest->device, X_FM); };
  if (there()) return s.newest;
  s.wanted = X_FM;
  s.asked.notify_one();
  s.answered.wait_for(lock, patience, there);
  return s.newest;
}

}  // namespace sonde
