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

constexpr double usual_rate_hz = 1000;
/// A path of more than a minute is run with longer ticks: nobody waits longer for a picture.
constexpr double most_ticks = 60'000;
constexpr double loop_part = 0.7;  // of the progress

/// At the path's own times, so that what is said of a moment is what `sonde replay` says of it.
std::vector<TimedPose> by_tick(const std::vector<TimedPose>& path, double ticks) {
  const double first = path.front().t, whole = path.back().t - path.front().t;
  std::vector<TimedPose> out;
  const auto count = static_cast<std::size_t>(ticks);
  out.reserve(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = first + double(i) / ticks * whole;
    out.push_back({t, pose_at(path, t)});
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
                 const Progress& progress) {
  const double seconds = path.back().t - path.front().t;
  const double ticks = std::clamp(std::round(seconds * usual_rate_hz), 1.0, most_ticks);
  const double rate_hz = ticks / seconds;
  const std::vector<LoopStep> steps = steps_of(by_tick(path, ticks), coupling);
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
