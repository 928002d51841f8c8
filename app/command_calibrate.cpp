// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <memory>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/study_run.hpp"
#include "engine/base/error.hpp"
#include "engine/calibration/calibration_file.hpp"
#include "engine/study/parts/overlapping_poses.hpp"
#include "engine/study/trade/calibrate.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct CalibrateOptions {
  std::vector<std::string> scenes;
  std::string within, add;
  OutputOptions output;
  std::size_t count = 12;
  std::uint64_t seed = 1;
};

/// A scene's path where it has one, and poses in contact of it, or random ones.
TradeSetup setup_of(const Scene& scene, const CalibrateOptions& options, ProgressLine& progress) {
  TradeSetup setup{.pair = load_bodies(scene, options.output.quiet, progress)};
  setup.scene = utf8_text(scene.name);  // a file's name may be no UTF-8
  setup.seed = options.seed;
  const Body &probe = setup.pair.probe(), &fixed = setup.pair.fixed();
  const Stop stop = stop_on_interrupt();
  if (scene.trajectory) {
    setup.path = path_to_study(scene);
    if (options.count == 0) return setup;
    std::vector<Pose> all;
    for (const TimedPose& at : setup.path) all.push_back(at.pose);
    setup.poses = overlapping_poses(probe, fixed, all, options.count, stop);
  } else if (options.count == 0) {
    throw InputError::in(scene.file.string(), "no path: --count 0 leaves nothing to measure");
  } else {
    setup.poses = random_overlapping_poses(probe, fixed, options.count, options.seed, stop);
  }
  if (setup.poses.empty())
    throw InputError::in(scene.file.string(), "the probe overlaps the fixed body at no pose of it");
  return setup;
}

void run(const CalibrateOptions& options) {
  std::vector<Scene> scenes;
  std::vector<std::filesystem::path> inputs;
  for (const std::string& file : options.scenes) {
    scenes.push_back(scene_at(file, options.within));
    for (const auto& input : inputs_of(scenes.back())) inputs.push_back(input);
  }
  if (!options.add.empty()) inputs.emplace_back(options.add);
  check_output(options.output, inputs);
  Calibration other;
  if (!options.add.empty()) other = read_calibration(options.add);
  ProgressLine progress(options.output.quiet, ProgressLine::Elsewhere::lines);
  Calibration all;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const TradeSetup setup = setup_of(scenes[i], options, progress);
    const std::string which = std::to_string(i + 1) + " of " + std::to_string(scenes.size());
    const Progress measuring = progress.percent("measuring scene " + which, stop_on_interrupt());
    for (CalibrationSeries& series : calibrate(setup, measuring).series)
      all.series.push_back(std::move(series));
  }
  progress.clear();
  write_result(options.output, to_json(joined(std::move(all), other)));
}

}  // namespace

Command add_calibrate_command(CLI::App& program) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App* parser = program.add_subcommand(
      "calibrate", "Measures, on this machine and given scenes, which accuracy takes which time");
  parser->add_option("SCENE", options->scenes, "scene files, NAME.sonde.json")->required();
  add_within(*parser, options->within);
  parser
      ->add_option("--count", options->count,
                   "poses to search at in each scene: of its path, or random ones; 0: none, only "
                   "the ticks of the paths")
      ->check(CLI::Range(std::size_t{0}, std::size_t{100'000}))
      ->capture_default_str();
  parser->add_option("--add", options->add,
                     "another calibration: what it holds and is not measured now is kept");
  parser->add_option("--seed", options->seed, "seed of the searches, and of random poses")
      ->check(check_whole)
      ->capture_default_str();
  parser
      ->add_option("--out", options->output.out,
                   "file to write, whole or not at all; -: standard output")
      ->capture_default_str();
  parser->add_flag("--quiet", options->output.quiet, "no progress and no notes on stderr");
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
