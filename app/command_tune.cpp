// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/profiles.hpp"
#include "app/study_run.hpp"
#include "engine/study/tuning/tuning.hpp"
#include "engine/study/tuning/tuning_inputs.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

using Json = nlohmann::ordered_json;

struct TuneOptions {
  BodyOptions bodies;
  StudyOptions study;
  std::string device;
  std::string trajectory;
  std::string coupling_mode;
  std::string method = "pdg";
  double ratio = 1.02;
  double low = 1, high = 1e5;
  std::uint64_t seed = 1;
  bool trusts_friction = false;
};

TuningRequest request_of(const Scene& scene, const TuneOptions& options, const Pair& pair,
                         const DeviceProfile& device) {
  TuningRequest request{.pair = pair};
  request.X_FM = relative_pose(scene);
  request.coupling = scene.coupling;
  if (const auto mode = coupling_mode(options.coupling_mode)) request.coupling.mode = *mode;
  request.method = method_named(options.method).value();
  request.sample_time = 1 / scene.servo.rate_hz;
  if (scene.servo.budget.steps > 0) request.budget.steps = scene.servo.budget.steps;
  request.device = device;
  if (!options.trajectory.empty()) request.path = path_to_study(options.trajectory);
  request.seed = options.seed;
  request.ratio = options.ratio;
  request.trusts_friction = options.trusts_friction;
  request.low = options.low;
  request.high = options.high;
  request.inputs =
      tuning_inputs(SONDE_VERSION, {scene.probe.mesh, scene.fixed.mesh, options.trajectory},
                    pair.probe(), pair.fixed());
  return request;
}

/// The contacts that the study is not about.
void note_skipped(const Study& study) {
  const Json about = Json::parse(study.about);
  for (const Json& each : about.at("skipped"))
    std::cerr << "sonde: left out: " << each.at("kind").get<std::string>()
              << " contact: " << each.at("reason").get<std::string>() << "\n";
}

void run(const TuneOptions& options) {
  check_output(options.study);
  if (!(options.low < options.high)) throw UsageError("--from must be below --to");
  const Scene scene = scene_of(options.bodies);
  const DeviceProfile device = device_named(options.device);
  ProgressLine progress(options.study.quiet);
  const Pair pair = load_bodies(scene, options.study.quiet, progress);
  const Study study = plan_tuning(request_of(scene, options, pair, device), stop_on_interrupt(),
                                  progress.percent("tune, looking for contacts"));
  progress.clear();
  if (!options.study.quiet) note_skipped(study);
  run_study(study, options.study, tuning_files);
}

std::string check_ratio(const std::string& text) {
  const auto ratio = parse_number(text);
  return ratio && *ratio >= 1.0001 && *ratio <= 2 ? ""
                                                  : "\"" + text + "\" must be from 1.0001 to 2";
}

}  // namespace

Command add_tune_command(CLI::App& program) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* parser = program.add_subcommand(
      "tune", "Measures how stiff a coupling on a device may be in a scene; recommends gains");
  add_scene(*parser, options->bodies);
  parser
      ->add_option("--device", options->device,
                   "profile to simulate: its id (sigma.7), or the path of its file")
      ->required();
  add_flags(*parser, options->study);
  parser->add_option("--trajectory", options->trajectory,
                     "take the contacts from this path (CSV t,px,py,pz,qw,qx,qy,qz)");
  parser->add_option("--coupling", options->coupling_mode, "mode to study; without it the scene's")
      ->check(CLI::IsMember({"object", "classic"}));
  parser->add_option("--method", options->method, "pdg: all six degrees; pdt: translation only")
      ->check(CLI::IsMember(method_names))
      ->capture_default_str();
  parser
      ->add_option(
          "--ratio", options->ratio,
          "search limits until the failing stiffness is at most this many times the holding one")
      ->check(check_ratio)
      ->capture_default_str();
  parser->add_option("--from", options->low, "least stiffness studied, N/m")
      ->check(check_positive)
      ->capture_default_str();
  parser->add_option("--to", options->high, "largest stiffness studied, N/m")
      ->check(check_positive)
      ->capture_default_str();
  parser->add_flag("--trust-friction", options->trusts_friction,
                   "recommend gains that are stable only thanks to the profile's friction");
  parser->add_option("--seed", options->seed, "seed of the search for contacts")
      ->check(check_whole)
      ->capture_default_str();
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
