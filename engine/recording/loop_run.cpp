// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/loop_run.hpp"

#include <chrono>

#include "engine/base/error.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"

namespace sonde {
namespace {

constexpr double long_gap = 10;  // periods

/// One run of the loop, with the state that continues from tick to tick.
class Runner {
 public:
  Runner(const Pair& pair, const LoopRun& run)
      : run_(run), loop_(pair, run.search.method, Coupling{}) {
    loop_.time_phases(run.time_phases);
    tick_.rate_hz = run.rate_hz;
    tick_.hand.share = 1;
    tick_.hand.rows.in_step = true;
    run_.search.budget = {};  // the budget is that of a tick
  }

  const Snapshot& next(const LoopStep& step) {
    loop_.set_coupling(step.coupling);
    const bool searched = step.begins || !started_;
    if (searched) loop_.reset(step.at.pose, run_.search);
    const bool by_search = searched && loop_.separation().jumped;
    const auto start = std::chrono::steady_clock::now();
    loop_.tick(step.at.pose, step.dt, run_.budget);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    // After a failed search there is no pose to follow: search again.
    started_ = (started_ && !step.begins) || loop_.separation().status != Status::failed;
    keep(step, took.count(), by_search);
    return tick_;
  }

 private:
  void keep(const LoopStep& step, double time_us, bool by_search) {
    tick_.tick = step.begins ? 1 : tick_.tick + 1;
    tick_.time = step.at.t;
    tick_.separation = loop_.separation();
    if (by_search) tick_.separation.jumped = true, tick_.separation.lagged = false;
    tick_.wrench = tick_.hand.asked = loop_.wrench();
    tick_.hand.rows.separated = tick_.separation.separated;
    tick_.coupling = step.coupling;
    tick_.tick_us = time_us;
    tick_.late += time_us > 1e6 / run_.rate_hz;
  }

  LoopRun run_;
  HapticLoop loop_;
  bool started_ = false;
  Snapshot tick_;
};

}  // namespace

std::vector<LoopStep> steps_of(const TickLog& ticks, const Progress& progress) {
  std::vector<LoopStep> steps;
  const std::uint64_t count = ticks.end() - ticks.begin();
  steps.reserve(static_cast<std::size_t>(count));
  std::uint64_t before = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Snapshot tick = ticks.at(ticks.begin() + i);
    const bool begins = steps.empty() || tick.tick <= before;
    const double since = begins ? 0 : tick.time - steps.back().at.t;
    before = tick.tick;
    steps.push_back({.at = {tick.time, tick.separation.device},
                     .coupling = tick.coupling,
                     .dt = ticks.along_path || since * ticks.rate_hz() <= long_gap ? since : 0,
                     .begins = begins});
    if (progress && i % TickLog::block_ticks == 0 &&
        !progress(static_cast<double>(i) / static_cast<double>(count)))
      throw Cancelled();
  }
  return steps;
}

std::vector<LoopStep> steps_of(std::span<const TimedPose> path, const Coupling& coupling) {
  std::vector<LoopStep> steps;
  steps.reserve(path.size());
  for (const TimedPose& at : path)
    steps.push_back({.at = at,
                     .coupling = coupling,
                     .dt = steps.empty() ? 0 : at.t - steps.back().at.t,
                     .begins = steps.empty()});
  return steps;
}

void run_loop(const Pair& pair, std::span<const LoopStep> steps, const LoopRun& run,
              const std::function<void(const Snapshot&)>& ticked) {
  Runner runner(pair, run);
  for (const LoopStep& step : steps) ticked(runner.next(step));
}

}  // namespace sonde
