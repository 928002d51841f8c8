// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>

#include "app/accuracy.hpp"
#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/result_table.hpp"
#include "app/static_searches.hpp"
#include "app/timed.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/scene/poses.hpp"

namespace sonde::app {
namespace {

struct ReplayOptions {
  BodyOptions bodies;
  SolverOptions solver;
  AccuracyOptions accuracy;
  OutputOptions output;
  std::string trajectory;
  std::string coupling_mode;
  SettingValues coupling;
  SettingValues servo;
};

constexpr std::array<Column, 30> columns{
    {{"t", "s"},        {"px", "m"},       {"py", "m"},      {"pz", "m"},      {"qw", ""},
     {"qx", ""},        {"qy", ""},        {"qz", ""},       {"sx", "m"},      {"sy", "m"},
     {"sz", "m"},       {"sqw", ""},       {"sqx", ""},      {"sqy", ""},      {"sqz", ""},
     {"fx", "N"},       {"fy", "N"},       {"fz", "N"},      {"tx", "N*m"},    {"ty", "N*m"},
     {"tz", "N*m"},     {"depth", "m"},    {"sigma", "m^2"}, {"contacts", ""}, {"iterations", ""},
     {"tick_us", "us"}, {"saturated", ""}, {"late", ""},     {"jumped", ""},   {"converged", ""}}};

/// One tick's outcome.
struct Tick {
  TimedSeparation result;
  Wrench wrench;
};

Row row_of(const TimedPose& at, const Tick& tick, double rate_hz) {
  const Separation& s = tick.result.separation;
  const bool failed = s.status == Status::failed;
  Row row{at.t};
  append(row, at.pose);
  if (failed)
    append_nothing(row, 7);
  else
    append(row, s.separated);
  append(row, tick.wrench.force);
  append(row, tick.wrench.torque);
  if (failed)
    append_nothing(row, 2);
  else
    row.insert(row.end(), {s.depth, s.sigma});
  row.push_back(std::int64_t{failed ? 0 : s.clusters.size});
  row.push_back(std::int64_t{s.iterations});
  row.push_back(tick.result.time_us);
  row.push_back(std::int64_t{tick.wrench.saturated});
  row.push_back(std::int64_t{tick.result.time_us > 1e6 / rate_hz});
  row.push_back(std::int64_t{s.jumped});
  row.push_back(std::int64_t{s.converged});
  return row;
}

/// The haptic loop over the path, as the servo would run it.
std::vector<Tick> run_loop(const Pair& pair, const Scene& scene, std::span<const TimedPose> path,
                           const SolverOptions& options, ProgressLine& progress) {
  std::vector<Tick> ticks(path.size());
  HapticLoop loop(pair, options.chosen_method(), scene.coupling);
  StaticOptions search = options.static_options();
  search.budget = {};    // the budget is that of a tick
  bool started = false;  // a search that failed leaves nothing to follow: search again
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool searched = !started;
    if (searched) loop.reset(path[i].pose, search);
    const bool by_search = searched && loop.separation().jumped;
    const double dt = i == 0 ? 0 : path[i].t - path[i - 1].t;
    ticks[i].result.time_us = timed_us([&] { loop.tick(path[i].pose, dt, options.budget); });
    ticks[i].result.separation = loop.separation();
    ticks[i].result.separation.jumped |= by_search;
    ticks[i].wrench = loop.wrench();
    started = started || loop.separation().status != Status::failed;
    progress.show("replaying", i + 1, path.size());
  }
  progress.clear();
  return ticks;
}

/// The wrench of a separation that belongs to no motion: nothing is damped.
Wrench still_wrench(const Body& probe, const Separation& s, const Coupling& coupling) {
  if (s.status != Status::penetrating) return {};
  const Wrench free = coupling.mode == Coupling::Mode::object
                          ? object_norm_wrench(probe.mass, s.device, s.separated, coupling.k)
                          : classic_wrench(separation_motion(probe.mass, s.device, s.separated),
                                           Vec3::Zero(), Vec3::Zero(), coupling);
  return limit(free, coupling.max_force, coupling.max_torque);
}

/// Every row searched for itself.
std::vector<Tick> search_rows(const Pair& pair, const Scene& scene, std::span<const TimedPose> path,
                              const SolverOptions& options, ProgressLine& progress) {
  std::vector<Pose> poses;
  for (const TimedPose& at : path) poses.push_back(at.pose);
  std::vector<Tick> ticks;
  for (const TimedSeparation& result : search_all(pair, poses, options, progress))
    ticks.push_back({result, still_wrench(pair.probe(), result.separation, scene.coupling)});
  return ticks;
}

/// The scene with what the command line replaces in it.
Scene scene_for(const ReplayOptions& options) {
  Scene scene = scene_of(options.bodies);
  if (!options.trajectory.empty()) scene.trajectory = options.trajectory;
  if (!scene.trajectory) throw UsageError("the scene names no trajectory: give --trajectory");
  if (const auto mode = coupling_mode(options.coupling_mode)) scene.coupling.mode = *mode;
  for (const auto& [key, value] : options.coupling) set(scene.coupling, key, value);
  for (const auto& [key, value] : options.servo) set(scene.servo, key, value);
  return scene;
}

void run(const ReplayOptions& options) {
  const Scene scene = scene_for(options);
  Accuracy accuracy(options.accuracy, options.solver);
  std::vector<std::filesystem::path> inputs = inputs_of(scene);
  inputs.push_back(*scene.trajectory);
  check_output(options.output, inputs);
  const std::vector<TimedPose> path = read_trajectory(*scene.trajectory);

  // The scene's wall-clock budget is left out, so that the same input gives the same bits; its
  // budget of counted work holds where the command line gives none.
  SolverOptions solver = options.solver;
  if (solver.budget.steps == 0 && !options.accuracy.turned())
    solver.budget.steps = scene.servo.budget.steps;

  ProgressLine progress(options.output.quiet);
  const Pair pair = load_bodies(scene, options.output.quiet, progress);
  solver = accuracy.applied(solver, pair);
  const std::vector<Tick> ticks = solver.coherent()
                                      ? run_loop(pair, scene, path, solver, progress)
                                      : search_rows(pair, scene, path, solver, progress);
  const std::vector<Column> all_columns = accuracy.with_claims(columns);
  ResultTable table{all_columns, {}};
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    report_failure(ticks[i].result.separation, i);
    table.rows.push_back(row_of(path[i], ticks[i], scene.servo.rate_hz));
    accuracy.append_claim(table.rows.back(), ticks[i].result.separation);
  }
  write_result(options.output, options.output.json ? to_json(table) : to_csv(table));
}

}  // namespace

Command add_replay_command(CLI::App& program) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* parser = program.add_subcommand(
      "replay", "The haptic loop over a recorded device path: one tick for each row");
  add_scene(*parser, options->bodies);
  parser->add_option("--trajectory", options->trajectory,
                     "CSV t,px,py,pz,qw,qx,qy,qz in SI units; without it the scene's own");
  add_flags(*parser, options->solver, "coherent");
  add_flags(*parser, options->accuracy);
  add_flags(*parser, options->output);
  parser->add_option("--coupling", options->coupling_mode, "object: one stiffness k; classic")
      ->check(CLI::IsMember({"object", "classic"}))
      ->group("Settings of the scene to replace");
  add_setting_flags(*parser, coupling_settings(), options->coupling);
  // The budgets of the table are the flags --budget-us and --budget-steps of every command.
  add_setting_flags(*parser, servo_settings().first(1), options->servo);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
