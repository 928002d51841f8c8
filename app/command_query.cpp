// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <iostream>
#include <memory>
#include <vector>

#include "app/accuracy.hpp"
#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/phases.hpp"
#include "app/result_table.hpp"
#include "app/static_searches.hpp"
#include "app/timed.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/scene/poses.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

struct QueryOptions {
  BodyOptions bodies;
  SolverOptions solver;
  AccuracyOptions accuracy;
  PhaseOptions phases;
  OutputOptions output;
  std::string poses;
};

constexpr std::array<Column, 16> query_columns{{{"index", ""},
                                                {"status", ""},
                                                {"depth", "m"},
                                                {"sigma", "m^2"},
                                                {"px", "m"},
                                                {"py", "m"},
                                                {"pz", "m"},
                                                {"qw", ""},
                                                {"qx", ""},
                                                {"qy", ""},
                                                {"qz", ""},
                                                {"lower_bound", "m"},
                                                {"contacts", ""},
                                                {"residual", ""},
                                                {"iterations", ""},
                                                {"time_us", "us"}}};

Row row_of(const TimedSeparation& result, std::size_t index) {
  const Separation& s = result.separation;
  const bool failed = s.status == Status::failed;
  Row row{static_cast<std::int64_t>(index), name_of(s.status)};
  if (failed) {
    append_nothing(row, 10);  // from depth to lower_bound
  } else {
    row.insert(row.end(), {s.depth, s.sigma});
    append(row, s.separated);
    row.push_back(s.lower_bound ? Cell(*s.lower_bound) : Cell());
  }
  row.push_back(std::int64_t{failed ? 0 : s.clusters.size});
  row.push_back(failed ? Cell() : Cell(s.residual));
  row.push_back(std::int64_t{s.iterations});
  row.push_back(result.time_us);
  return row;
}

std::vector<TimedSeparation> follow_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress) {
  std::vector<TimedSeparation> results(poses.size());
  CoherentSolver solver(pair, options.chosen_method());
  solver.time_phases(options.time_phases);
  bool started = false;  // a search that failed leaves nothing to follow: search again
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Separation& separation = results[i].separation;
    results[i].time_us = timed_us([&] {
      separation = started ? solver.tick(poses[i], options.budget)
                           : solver.reset(poses[i], options.static_options());
    });
    started = started || separation.status != Status::failed;
    progress.show("following", i + 1, poses.size());
  }
  progress.clear();
  return results;
}

void note_unfinished(const std::vector<TimedSeparation>& results) {
  std::size_t unfinished = 0;
  for (const TimedSeparation& result : results)
    if (result.separation.status == Status::penetrating && !result.separation.converged)
      ++unfinished;
  if (unfinished > 0)
    std::cerr << "sonde: " << unfinished << " of " << results.size()
              << " poses did not converge: their depths are upper bounds\n";
}

/// Whether a limited time was kept, for each row; nothing where there is no limit.
class Lateness {
 public:
  explicit Lateness(double limit_us) : limit_us_(limit_us) {}

  std::vector<Column> with_column(std::vector<Column> columns) const {
    if (limit_us_ > 0) columns.push_back({"late", ""});
    return columns;
  }
  void append(Row& row, double time_us) {
    if (!(limit_us_ > 0)) return;
    const bool late = time_us > not_late * limit_us_;
    row.push_back(std::int64_t{late});
    late_ += late;
    ++all_;
  }
  void note() const {
    if (late_ > 0)
      std::cerr << "sonde: " << late_ << " of " << all_ << " poses took over "
                << number_text(not_late, 2) << " times the time for each, "
                << number_text(1e-3 * limit_us_, 3) << " ms (late)\n";
  }

 private:
  double limit_us_;
  std::size_t late_ = 0, all_ = 0;
};

void run(const QueryOptions& options) {
  const Scene scene = scene_of(options.bodies);
  Accuracy accuracy(options.accuracy, options.solver);
  std::vector<std::filesystem::path> inputs = inputs_of(scene);
  inputs.emplace_back(options.poses);
  check_output(options.output, inputs);
  check_picture(options.phases, options.output, inputs);
  const std::vector<Pose> poses = read_poses(options.poses);

  ProgressLine progress(options.output.quiet);
  const Pair pair = load_bodies(scene, options.output.quiet, progress);
  SolverOptions solver = accuracy.applied(options.solver, pair);
  solver.time_phases = options.phases.timed();
  const auto results = solver.coherent() ? follow_all(pair, poses, solver, progress)
                                         : search_all(pair, poses, solver, progress);
  Lateness lateness(accuracy.time_us());
  const std::vector<Column> all_columns =
      with_phases(options.phases, lateness.with_column(accuracy.with_claims(query_columns)));
  ResultTable table{all_columns, {}, pair.probe().offset.by, remarks_on(pair)};
  PhasePicture picture;
  for (std::size_t i = 0; i < results.size(); ++i) {
    report_failure(results[i].separation, i);
    table.rows.push_back(row_of(results[i], i));
    accuracy.append_claim(table.rows.back(), results[i].separation);
    lateness.append(table.rows.back(), results[i].time_us);
    append_phases(options.phases, table.rows.back(), results[i].separation);
    picture.add(results[i].separation, results[i].time_us);
  }
  if (!options.output.quiet) {
    accuracy.note_unreached();
    lateness.note();
    note_unfinished(results);
  }
  picture.write_with(options.phases, "searches", options.output,
                     options.output.json ? to_json(table) : to_csv(table));
}

}  // namespace

Command add_query_command(CLI::App& program) {
  const auto options = std::make_shared<QueryOptions>();
  CLI::App* parser = program.add_subcommand(
      "query", "Computes penetration depth and separated pose for each pose of a file");
  add_scene_or_meshes(*parser, options->bodies);
  parser
      ->add_option("--poses", options->poses,
                   "CSV px,py,pz,qw,qx,qy,qz: the probe's mesh frame in the fixed body's, metres")
      ->required();
  add_flags(*parser, options->solver, "static");
  add_flags(*parser, options->accuracy);
  add_flags(*parser, options->phases);
  add_flags(*parser, options->output);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
