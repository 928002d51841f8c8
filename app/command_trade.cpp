// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/study_run.hpp"
#include "app/trade_folder.hpp"
#include "engine/base/error.hpp"
#include "engine/calibration/calibration_file.hpp"
#include "engine/penetration/search/search_variation.hpp"
#include "engine/study/parts/overlapping_poses.hpp"
#include "engine/study/trade/calibrate.hpp"
#include "engine/study/trade/trade.hpp"
#include "engine/study/trade/trade_chart.hpp"
#include "engine/study/trade/trade_report.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct TradeOptions {
  BodyOptions bodies;
  StudyOptions study;
  bool json = false;
  bool calibrate = false;
  std::string poses;
  std::string trajectory;
  std::vector<std::string> variations;
  std::string series;
  std::optional<std::size_t> count;
  std::uint64_t seed = 1;
};

/// Where neither a file of poses nor the flag says how many.
constexpr std::size_t default_count = 24;

/// Poses in contact: of the file, of the path, or random ones.
std::vector<Pose> choose_poses(const TradeOptions& options, const TradeSetup& setup,
                               const std::string& trajectory) {
  const Stop stop = stop_on_interrupt();
  const bool from_file = !options.poses.empty();
  const std::size_t count = options.count.value_or(from_file ? 0 : default_count);
  if (!from_file && setup.path.empty())
    return random_overlapping_poses(setup.pair.probe(), setup.pair.fixed(), count, options.seed,
                                    stop);
  std::vector<Pose> all;
  if (from_file) all = read_poses(options.poses);
  if (!from_file)
    for (const TimedPose& at : setup.path) all.push_back(at.pose);
  std::vector<Pose> chosen =
      overlapping_poses(setup.pair.probe(), setup.pair.fixed(), all, count, stop);
  if (chosen.empty())
    throw InputError::in(from_file ? options.poses : trajectory,
                         "the probe overlaps the fixed body at no pose of it");
  return chosen;
}

void write_calibration(const TradeOptions& options, const TradeSetup& setup) {
  ProgressLine line(options.study.quiet, ProgressLine::Elsewhere::lines);
  const Calibration measured =
      calibrate(setup, line.percent("trade, calibration", stop_on_interrupt()));
  line.clear();
  write_whole(std::filesystem::path(options.study.out) / "calibration.json", to_json(measured));
}

/// The picture again, with the answers of others in it.
void draw_series(const TradeOptions& options, const std::vector<TradeAnswer>& answers) {
  const std::string& folder = options.study.out;
  const TradeResults results = read_trade(folder, read_study(folder));
  write_whole(std::filesystem::path(folder) / "trade.svg",
              trade_picture(results, trade_figures(results), trade_series(answers, results)));
}

void run_pair(const TradeOptions& options) {
  refuse_other_things(options.study.out);
  Scene scene = scene_of(options.bodies);
  take_trajectory(scene, options.trajectory);
  std::vector<TimedPose> path;
  if (scene.trajectory) path = path_to_study(scene);
  ProgressLine progress(options.study.quiet, ProgressLine::Elsewhere::lines);
  TradeSetup setup{.pair = load_bodies(scene, options.study.quiet, progress)};
  setup.scene = utf8_text(scene.name.empty() ? scene.probe.mesh.stem().string() + " on " +
                                                   scene.fixed.mesh.stem().string()
                                             : scene.name);
  setup.seed = options.seed;
  setup.path = std::move(path);
  nlohmann::ordered_json inputs = study_inputs(scene, setup.pair);
  if (!options.poses.empty()) inputs["poses"] = fingerprint_of(options.poses);
  for (const std::string& one : options.variations) vary(setup.tuning, one);
  if (!options.variations.empty()) inputs["vary"] = options.variations;
  setup.inputs = inputs.dump();
  progress.show("trade, looking for poses in contact", 0, 1);
  setup.poses = choose_poses(options, setup, scene.trajectory.value_or("").string());
  std::vector<TradeAnswer> answers;  // what is wrong in them is said before the study begins
  if (!options.series.empty()) answers = read_trade_answers(options.series, setup.poses.size());
  const Study study = trade_study(setup);
  progress.clear();
  run_study(study, options.study, trade_files);
  if (options.calibrate) write_calibration(options, setup);
  if (!options.series.empty()) draw_series(options, answers);
}

/// Each scene of a folder into a folder of its own, and the front over all of them.
void run_folder(const TradeOptions& options) {
  if (!options.poses.empty() || !options.trajectory.empty() || !options.series.empty())
    throw UsageError("--poses, --trajectory and --series are of one pair: give a scene");
  const std::filesystem::path out(options.study.out);
  std::vector<std::string> names;
  for (const auto& scene : scenes_in(options.bodies.scene)) {
    names.push_back(folder_name(scene));
    TradeOptions one = options;
    one.bodies.scene = scene.string();
    one.study.out = (out / names.back()).string();
    run_pair(one);
  }
  if (options.study.shard.empty()) write_front(out, names);
}

void run(const TradeOptions& options) {
  if (!options.study.shard.empty() && (options.calibrate || !options.series.empty()))
    throw UsageError("--calibrate and --series are for a whole study: leave out --shard");
  check_output(options.study);
  if (std::filesystem::is_directory(options.bodies.scene))
    run_folder(options);
  else
    run_pair(options);
  print_summary(options.study, options.json);
}

std::string check_count(const std::string& text) {
  return text == "0" ? "there must be one pose at least" : check_whole(text);
}

std::string check_variation(const std::string& text) {
  try {
    SearchTuning tuning;
    vary(tuning, text);
    return "";
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
}

}  // namespace

Command add_trade_command(CLI::App& program) {
  const auto options = std::make_shared<TradeOptions>();
  CLI::App* parser = program.add_subcommand(
      "trade", "Measures accuracy against time: searches, bounds and ticks with budgets");
  add_scene_or_meshes(*parser, options->bodies);
  parser->add_option(
      "--poses", options->poses,
      "search at those of these poses (CSV px,py,pz,qw,qx,qy,qz) that overlap; without "
      "it at poses of the trajectory, or at random ones");
  parser->add_option("--trajectory", options->trajectory,
                     "follow this path (CSV t,px,py,pz,qw,qx,qy,qz) instead of the scene's");
  parser
      ->add_option("--count", options->count,
                   "poses to search at, evenly chosen; without it 24, or all of --poses")
      ->check(check_count);
  parser->get_option("SCENE")->description(
      "scene file, NAME.sonde.json; or a folder of them, for the front over all");
  add_flags(*parser, options->study);
  parser->add_option("--series", options->series,
                     "draw another program's answers too (CSV series,pose,depth,time_us)");
  parser->add_flag("--calibrate", options->calibrate,
                   "also measure which accuracy takes which time here: calibration.json");
  parser
      ->add_option("--vary", options->variations,
                   "another value for a number of the search, NAME=VALUE; again for others")
      ->check(check_variation);
  parser->add_flag("--json", options->json, "the summary on standard output as JSON");
  parser->add_option("--seed", options->seed, "seed of the searches, and of random poses")
      ->check(check_whole)
      ->capture_default_str();
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
