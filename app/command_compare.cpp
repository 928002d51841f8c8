// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/profiles.hpp"
#include "app/study_run.hpp"
#include "engine/study/comparison/compare_report.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct CompareOptions {
  BodyOptions bodies;
  StudyOptions study;
  bool json = false;
  std::string trajectory;
  std::string device;
  std::string coupling_mode;
  SettingValues coupling;
  int budget_steps = 0;
  std::uint64_t seed = 1;
};

Scene scene_for(const CompareOptions& options) {
  Scene scene = scene_of(options.bodies);
  take_trajectory(scene, options.trajectory);
  if (!scene.trajectory) throw UsageError("the scene names no trajectory: give --trajectory");
  if (const auto mode = coupling_mode(options.coupling_mode)) scene.coupling.mode = *mode;
  for (const auto& [key, value] : options.coupling) set(scene.coupling, key, value);
  return scene;
}

std::string inputs_text(const Scene& scene, const Pair& pair, const DeviceProfile* device) {
  nlohmann::ordered_json json = study_inputs(scene, pair);
  if (device) json["device"] = {{"id", device->id}, {"rate_hz", scene.servo.rate_hz}};
  if (device)
    for (const ProfileKey& key : profile_keys())
      json["device"][key.key] = (device->*key.value).value;
  return json.dump();
}

void run(const CompareOptions& options) {
  check_output(options.study);
  refuse_other_things(options.study.out);
  const Scene scene = scene_for(options);
  std::vector<TimedPose> path = path_to_study(scene);
  std::optional<DeviceProfile> device;
  if (!options.device.empty()) device = device_named(options.device);
  CompareSetup setup{.render = {.pair = load_bodies(scene, options.study.quiet)}};
  setup.path = std::move(path);
  setup.scene = utf8_text(scene.name);
  if (device) setup.device = simulated(*device);
  setup.sample_time = 1 / scene.servo.rate_hz;
  setup.inputs = inputs_text(scene, setup.render.pair, device ? &*device : nullptr);
  setup.render.coupling = scene.coupling;
  setup.render.budget.steps =
      options.budget_steps > 0 ? options.budget_steps : scene.servo.budget.steps;
  setup.render.search.seed = options.seed;
  run_study(compare_study(setup), options.study, compare_files);
  print_summary(options.study, options.json);
}

}  // namespace

Command add_compare_command(CLI::App& program) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* parser = program.add_subcommand(
      "compare", "Renders one device path with PD_t and with PD_g: which is smoother, which truer");
  add_scene(*parser, options->bodies);
  parser->add_option("--trajectory", options->trajectory,
                     "CSV t,px,py,pz,qw,qx,qy,qz in SI units; without it the scene's own");
  parser->add_option("--device", options->device,
                     "also the largest stable stiffness of both on this device: a profile's id "
                     "(sigma.7), or the path of its file");
  add_flags(*parser, options->study);
  parser->add_flag("--json", options->json, "the summary on standard output as JSON");
  parser
      ->add_option("--budget-steps", options->budget_steps,
                   "limit on counted iterations for each tick; 0: the scene's, or until converged")
      ->check(check_whole)
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "seed of the searches' random starts")
      ->check(check_whole)
      ->capture_default_str();
  parser
      ->add_option("--coupling", options->coupling_mode,
                   "object: one stiffness k; classic; damped: object with b_t")
      ->check(CLI::IsMember({"object", "classic", "damped"}))
      ->group("Settings that replace the scene's");
  add_setting_flags(*parser, coupling_settings(), options->coupling);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
