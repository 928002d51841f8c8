// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/demo_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/body/body.hpp"
#include "engine/recording/loop_run.hpp"
#include "engine/scene/path_hand.hpp"

namespace sonde::ui {
namespace {

constexpr double rate_hz = 1000;
constexpr double loop_part = 0.7;  // of the progress

std::vector<TimedPose> by_tick(const std::vector<TimedPose>& path, double seconds) {
  const auto ticks = static_cast<std::size_t>(std::max(std::ceil(seconds * rate_hz), 1.0));
  const double first = path.front().t, whole = path.back().t - path.front().t;
  std::vector<TimedPose> out;
  out.reserve(ticks + 1);
  for (std::size_t i = 0; i <= ticks; ++i) {
    const double place = double(i) / double(ticks);
    out.push_back({place * seconds, pose_at(path, first + place * whole)});
  }
  return out;
}

Snapshot without_clock(Snapshot tick) {
  tick.tick_us = 0;
  tick.late = 0;
  tick.rate_hz = 0;
  return tick;
}

}  // namespace

DemoRun run_demo(const Pair& pair, const std::vector<TimedPose>& path, const Coupling& coupling,
                 double seconds, const Progress& progress) {
  const std::vector<LoopStep> steps = steps_of(by_tick(path, seconds), coupling);
  DemoRun run{.kept = std::make_shared<KeptTicks>()};
  run.kept->name = QStringLiteral("The path");
  run.kept->ticks = std::make_unique<TickLog>(pair.probe().mass.radius, rate_hz);
  TickLog& log = *run.kept->ticks;
  log.along_path = true;
  Snapshot deepest;
  double depth = 0;
  std::size_t done = 0;
  run_loop(pair, steps, {.budget = {}, .search = {}, .rate_hz = rate_hz},
           [&](const Snapshot& made) {
             const Snapshot tick = without_clock(made);
             log.add(tick);
             const Separation& s = tick.separation;
             const bool deeper = s.status == Status::penetrating && s.depth > depth;
             if (deeper || !run.touches) deepest = tick;
             if (deeper) depth = s.depth, run.touches = true;
             report(progress, loop_part * double(++done) / double(steps.size()));
           });
  log.seal();
  run.deepest = deepest.time;
  log.add(RecordedSearch{deepest.time, searched_fully(pair, deepest.separation.device)});
  run.kept->curves = curves_of(log);
  return run;
}

}  // namespace sonde::ui
