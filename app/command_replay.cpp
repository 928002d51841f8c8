// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/accuracy.hpp"
#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/phases.hpp"
#include "app/recordings.hpp"
#include "app/result_table.hpp"
#include "app/room.hpp"
#include "app/static_searches.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/queries/body_queries.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/recording/loop_run.hpp"
#include "engine/recording/recording.hpp"
#include "engine/recording/recording_writer.hpp"
#include "engine/scene/poses.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct ReplayOptions {
  BodyOptions bodies;
  SolverOptions solver;
  AccuracyOptions accuracy;
  PhaseOptions phases{.with_converged = false};
  OutputOptions output;
  std::string trajectory;
  std::string record;
  bool as_recorded = false;
  bool clearance = false;  ///< a column with the room between the bodies
  std::string coupling_mode;
  SettingValues coupling;
  SettingValues servo;
};

constexpr std::array<Column, 31> replay_columns{
    {{"t", "s"},        {"px", "m"},       {"py", "m"},      {"pz", "m"},      {"qw", ""},
     {"qx", ""},        {"qy", ""},        {"qz", ""},       {"sx", "m"},      {"sy", "m"},
     {"sz", "m"},       {"sqw", ""},       {"sqx", ""},      {"sqy", ""},      {"sqz", ""},
     {"fx", "N"},       {"fy", "N"},       {"fz", "N"},      {"tx", "N*m"},    {"ty", "N*m"},
     {"tz", "N*m"},     {"depth", "m"},    {"sigma", "m^2"}, {"contacts", ""}, {"iterations", ""},
     {"tick_us", "us"}, {"saturated", ""}, {"late", ""},     {"jumped", ""},   {"converged", ""},
     {"released", "J"}}};

std::vector<Column> with_clearance(const ReplayOptions& options, std::vector<Column> columns) {
  if (options.clearance) columns.insert(columns.end(), {{"part", ""}, {"clearance", "m"}});
  return columns;
}

/// What the tick let go; none where no energy of the coupling is defined by the separation.
enum class Released { known, unknown };

Row row_of(const Snapshot& tick, double rate_hz, Released released) {
  const Separation& s = tick.separation;
  const bool failed = s.status == Status::failed;
  Row row{tick.time};
  append(row, s.device);
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
  row.push_back(tick.tick_us);
  row.push_back(tick.wrench.saturated);
  row.push_back(tick.tick_us > 1e6 / rate_hz);
  row.push_back(s.jumped);
  row.push_back(s.converged);
  if (released == Released::known && in_object_norm(tick.coupling.mode))
    row.push_back(0.5 * tick.coupling.k * s.released);
  else
    append_nothing(row, 1);
  return row;
}

/// What the command line replaces of gains.
void replace(Coupling& coupling, const ReplayOptions& options) {
  if (const auto mode = coupling_mode(options.coupling_mode)) coupling.mode = *mode;
  for (const auto& [key, value] : options.coupling) set(coupling, key, value);
}

/// What is run: a scene along a path, with the gains of each tick.
struct Job {
  Scene scene;
  std::vector<LoopStep> steps;
  std::vector<std::filesystem::path> inputs;
  bool along_path = true;  ///< the time between two steps is known, however long
};

/// What becomes of the ticks: rows of the table, and where it is asked for a recording.
class Results {
 public:
  Results(const ReplayOptions& options, const Scene& scene, const Accuracy& accuracy,
          RecordingHeader header)
      : options_(options),
        scene_(scene),
        accuracy_(accuracy),
        columns_(with_clearance(options,
                                with_phases(options.phases, accuracy.with_claims(replay_columns)))),
        table_{{columns_, scene.probe.offset}, {}},
        header_(std::move(header)),
        log_(header_.probe_radius, header_.rate_hz) {
    // A header that cannot be written is told of before the work.
    if (!options.record.empty()) header_bytes(header_, options.record);
  }

  /// What is said of the bodies.
  void remark(std::vector<std::string> remarks) { table_.head.remarks = std::move(remarks); }
  /// Between what the room is measured, where that is asked for.
  void measure(const Pair& pair) { pair_ = pair; }

  void add(const Snapshot& tick) {
    if (tick.separation.status == Status::failed)
      failures_.emplace_back(table_.rows.size(), tick.separation);
    table_.rows.push_back(row_of(tick, scene_.servo.rate_hz, Released::known));
    accuracy_.append_claim(table_.rows.back(), tick.separation);
    append_phases(options_.phases, table_.rows.back(), tick.separation);
    if (options_.clearance) append_room(table_.rows.back(), tick.separation);
    picture_.add(tick.separation, tick.tick_us);
    if (!options_.record.empty()) log_.add(tick);
  }

  void write() {
    const std::string what = options_.solver.coherent() ? "ticks" : "searches";
    for (const auto& [index, separation] : failures_) report_failure(separation, index);
    const std::string table = options_.output.json ? to_json(table_) : to_csv(table_);
    if (options_.record.empty())
      return picture_.write_with(options_.phases, what, options_.output, table);
    log_.seal();
    finish_despite_interrupts();
    // It takes its name once the table is written: both appear, or neither.
    PendingFile recording(options_.record, recording_bytes(options_.record, header_, log_));
    picture_.write_with(options_.phases, what, options_.output, table);
    recording.commit();
  }

 private:
  void append_room(Row& row, const Separation& s) {
    if (s.status == Status::failed) return append_nothing(row, 2);
    Separation measured = s;
    if (s.status == Status::separated) measured.clearance = distance(pair_.value(), s.device);
    const Room room = room_of(measured);
    if (room.on_fixed)
      row.push_back(names_.emplace(part_at(pair_->fixed(), *room.on_fixed)).first->c_str());
    else
      append_nothing(row, 1);
    row.push_back(room.clearance.value());
  }

  const ReplayOptions& options_;
  const Scene& scene_;
  const Accuracy& accuracy_;
  std::optional<Pair> pair_;
  std::set<std::string, std::less<>> names_;  // of parts, which rows point to
  std::vector<Column> columns_;
  ResultTable table_;
  std::vector<std::pair<std::size_t, Separation>> failures_;
  PhasePicture picture_;
  RecordingHeader header_;
  TickLog log_;
};

/// The haptic loop over the path, as the servo would run it.
void run_in_step(const Pair& pair, const Job& job, const SolverOptions& options,
                 ProgressLine& progress, Results& results) {
  const LoopRun run{.budget = options.budget,
                    .search = options.static_options(),
                    .time_phases = options.time_phases,
                    .rate_hz = job.scene.servo.rate_hz};
  std::size_t done = 0;
  run_loop(pair, job.steps, run, [&](const Snapshot& tick) {
    results.add(tick);
    progress.show("replaying", ++done, job.steps.size());
  });
}

/// The wrench of a separation that belongs to no motion: nothing is damped.
Wrench still_wrench(const Body& probe, const Separation& s, const Coupling& coupling) {
  if (s.status != Status::penetrating) return {};
  const Wrench free = in_object_norm(coupling.mode)
                          ? object_norm_wrench(probe.mass, s.device, s.separated, coupling.k)
                          : classic_wrench(separation_motion(probe.mass, s.device, s.separated),
                                           Vec3::Zero(), Vec3::Zero(), coupling);
  return limit(free, coupling.max_force, coupling.max_torque);
}

/// Every row searched for itself.
void search_rows(const Pair& pair, const Job& job, const SolverOptions& options,
                 ProgressLine& progress, Results& results) {
  std::vector<Pose> poses;
  for (const LoopStep& step : job.steps) poses.push_back(step.at.pose);
  Snapshot tick;
  for (const TimedSeparation& result : search_all(pair, poses, options, progress)) {
    const LoopStep& step = job.steps[tick.tick++];
    tick.time = step.at.t;
    tick.separation = result.separation;
    tick.wrench = still_wrench(pair.probe(), result.separation, step.coupling);
    tick.coupling = step.coupling;
    tick.tick_us = result.time_us;
    tick.rate_hz = job.scene.servo.rate_hz;
    results.add(tick);
  }
}

std::unique_ptr<Recording> read(const ReplayOptions& options) {
  std::unique_ptr<Recording> recording = recording_at(options.bodies.scene, options.bodies.within);
  if (!recording->cut.empty() && !options.output.quiet)
    std::cerr << "sonde: " << printable(recording->file.string()) << ": " << recording->cut
              << "; what is before it is replayed\n";
  return recording;
}

/// The ticks as they were: nothing is computed, so neither mesh is read.
void write_as_recorded(const ReplayOptions& options) {
  if (!is_recording(options.bodies.scene))
    throw UsageError("--as-recorded is for a recording: " + options.bodies.scene + " is none");
  if (options.phases.timed())
    throw UsageError("--as-recorded runs nothing: there are no --phases, and no picture of them");
  check_output(options.output, {options.bodies.scene});
  const std::unique_ptr<Recording> recording = read(options);
  const TickLog& ticks = recording->ticks;
  ResultTable table{{replay_columns, recording->header.scene.probe.offset}, {}};
  for (std::uint64_t i = ticks.begin(); i < ticks.end(); ++i)
    table.rows.push_back(row_of(ticks.at(i), recording->header.rate_hz, Released::unknown));
  write_result(options.output, options.output.json ? to_json(table) : to_csv(table));
}

Job job_of_recording(const ReplayOptions& options) {
  const std::unique_ptr<Recording> recording = read(options);
  check_meshes(recording->header, recording->file);
  return {recording->header.scene,
          steps_of(recording->ticks),
          {recording->file, recording->header.scene.probe.mesh, recording->header.scene.fixed.mesh},
          recording->ticks.along_path};
}

Job job_of_scene(const ReplayOptions& options) {
  Scene scene = scene_of(options.bodies);
  take_trajectory(scene, options.trajectory);
  if (!scene.trajectory) throw UsageError("the scene names no trajectory: give --trajectory");
  std::vector<std::filesystem::path> inputs = inputs_of(scene);
  inputs.push_back(*scene.trajectory);
  require_trajectory(scene);
  std::vector<LoopStep> steps = steps_of(read_trajectory(*scene.trajectory), scene.coupling);
  return {std::move(scene), std::move(steps), std::move(inputs)};
}

/// With what the command line replaces in it.
Job job_for(const ReplayOptions& options) {
  const bool recorded = is_recording(options.bodies.scene);
  if (recorded && !options.trajectory.empty())
    throw UsageError("a recording has its own path: leave out --trajectory");
  Job job = recorded ? job_of_recording(options) : job_of_scene(options);
  for (LoopStep& step : job.steps) replace(step.coupling, options);
  replace(job.scene.coupling, options);
  if (const auto offset = offset_of(options.bodies.allowance, options.bodies.safety))
    job.scene.probe.offset = *offset;
  for (const auto& [key, value] : options.servo) set(job.scene.servo, key, value);
  return job;
}

/// The command line's, or else the accuracy that the scene wants of its ticks.
AccuracyOptions knob_of(const ReplayOptions& options, const Scene& scene) {
  AccuracyOptions knob = options.accuracy;
  const Budget& given = options.solver.budget;
  const bool limited =
      knob.turned() || given.steps > 0 || given.microseconds > 0 || scene.servo.budget.steps > 0;
  // What a recording's loop wanted is no wish for running it again.
  if (!limited && options.solver.coherent() && !is_recording(options.bodies.scene) &&
      scene.servo.accuracy > 0)
    knob.accuracy = number_text(scene.servo.accuracy);
  return knob;
}

void run(const ReplayOptions& options) {
  if (options.solver.bound.value_or(false))
    throw UsageError(
        "a replay makes no lower bound: leave out --bound (sonde query has it, of each pose)");
  if (options.as_recorded) return write_as_recorded(options);
  const Job job = job_for(options);
  const Scene& scene = job.scene;
  const AccuracyOptions knob = knob_of(options, scene);
  Accuracy accuracy(knob, options.solver);
  check_output(options.output, job.inputs);
  check_beside(options.output, "--record", options.record, job.inputs);
  check_picture(options.phases, options.output, job.inputs);
  if (!options.record.empty() && same_file(options.record, options.phases.picture))
    throw UsageError("--record and --phases-picture name the same file: " + options.record);

  // The scene's wall-clock budget is left out, so that the same input gives the same bits; its
  // budget of counted work holds where the command line gives none.
  SolverOptions solver = options.solver;
  if (solver.budget.steps == 0 && !knob.turned()) solver.budget.steps = scene.servo.budget.steps;

  ProgressLine progress(options.output.quiet);
  RecordingHeader header;
  // The marks are those of the meshes that are run, whatever becomes of the files meanwhile.
  if (!options.record.empty()) header = header_of(scene, 0);
  const Pair pair = load_bodies(scene, options.output.quiet, progress);
  header.rate_hz = scene.servo.rate_hz;
  header.probe_radius = pair.probe().mass.radius;
  header.along_path = job.along_path;
  solver = accuracy.applied(solver, pair);
  solver.time_phases = options.phases.timed();
  Results results(options, scene, accuracy, std::move(header));
  results.remark(remarks_on(pair));
  results.measure(pair);
  if (solver.coherent())
    run_in_step(pair, job, solver, progress, results);
  else
    search_rows(pair, job, solver, progress, results);
  progress.clear();
  if (!options.output.quiet) accuracy.note_unreached();
  results.write();
}

}  // namespace

Command add_replay_command(CLI::App& program) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* parser = program.add_subcommand(
      "replay", "Runs the haptic loop over a recorded device path, one tick for each row");
  add_scene(*parser, options->bodies);
  parser->get_option("SCENE")->description(
      "scene file, NAME.sonde.json; or a recording, whose path and gains are run again");
  auto* record = parser->add_option("--record", options->record,
                                    "recording to write, whole or not at all: NAME.sonderec");
  auto* clearance = parser->add_flag(
      "--clearance", options->clearance,
      "the least distance of the bodies, less than zero, by the depth, where held, and before it "
      "the part of the fixed body there");
  parser
      ->add_flag("--as-recorded", options->as_recorded,
                 "the ticks of a recording as they were: nothing is run again, no mesh is read")
      ->excludes(record)
      ->excludes(clearance);
  parser->add_option("--trajectory", options->trajectory,
                     "CSV t,px,py,pz,qw,qx,qy,qz in SI units; without it the scene's own");
  add_flags(*parser, options->solver, "coherent");
  add_flags(*parser, options->accuracy);
  add_flags(*parser, options->phases);
  add_flags(*parser, options->output);
  parser
      ->add_option("--coupling", options->coupling_mode,
                   "object: one stiffness k; classic; damped: object with b_t")
      ->check(CLI::IsMember({"object", "classic", "damped"}))
      ->group("Settings that replace the scene's");
  add_setting_flags(*parser, coupling_settings(), options->coupling);
  // The budgets of the table are the flags --budget-us and --budget-steps of every command.
  add_setting_flags(*parser, servo_settings().first(1), options->servo);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
