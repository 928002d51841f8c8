// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tuning_options.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/study/tuning/tuning_inputs.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {

void add_flags(CLI::App& parser, TuningOptions& options) {
  add_scene(parser, options.bodies);
  parser
      .add_option("--device", options.device,
                  "profile to simulate: its id (sigma.7), or the path of its file")
      ->required();
  add_flags(parser, options.study);
  parser.add_option("--trajectory", options.trajectory,
                    "take the contacts from this path (CSV t,px,py,pz,qw,qx,qy,qz)");
  parser.add_option("--coupling", options.coupling_mode, "mode to study; without it the scene's")
      ->check(CLI::IsMember({"object", "classic", "damped"}));
  parser.add_option("--method", options.method, "pdg: all six degrees; pdt: translation only")
      ->check(CLI::IsMember(method_names))
      ->capture_default_str();
  parser.add_option("--seed", options.seed, "seed of the search for contacts")
      ->check(check_whole)
      ->capture_default_str();
}

TuningRequest request_of(const Scene& scene, const TuningOptions& options, const Pair& pair,
                         const DeviceProfile& device) {
  TuningRequest request{.pair = pair};
  request.X_FM = relative_pose(scene);
  request.coupling = scene.coupling;
  if (const auto mode = coupling_mode(options.coupling_mode)) request.coupling.mode = *mode;
  request.method = method_named(options.method).value();
  request.sample_time = 1 / scene.servo.rate_hz;
  request.budget = counted_budget(scene.servo);
  request.device = device;
  if (!options.trajectory.empty()) request.path = path_to_study(options.trajectory);
  request.seed = options.seed;
  request.inputs =
      tuning_inputs(SONDE_VERSION, {scene.probe.mesh, scene.fixed.mesh, options.trajectory},
                    pair.probe(), pair.fixed());
  return request;
}

void note_gains(const Coupling& gains, const DeviceProfile& device, const MassProperties& mass) {
  const Coupling taken = borne(gains,
                               {device.max_stiffness.value, device.max_rotational_stiffness.value,
                                device.max_damping.value, device.max_rotational_damping.value},
                               mass);
  const auto note = [&](const char* key, double wanted, double most, const char* unit) {
    if (most < wanted)
      std::cerr << "sonde: the scene's " << key << " of " << number_text(wanted, 3) << ' ' << unit
                << " is more than " << printable(device.name) << " bears: there it is rendered as "
                << number_text(most, 3) << ' ' << unit << "\n";
  };
  if (gains.mode != Coupling::Mode::object) note("b_t", gains.b_t, taken.b_t, "N·s/m");
  if (in_object_norm(gains.mode)) return note("k", gains.k, taken.k, "N/m");
  note("k_t", gains.k_t, taken.k_t, "N/m");
  note("k_r", gains.k_r, taken.k_r, "N·m/rad");
  note("b_r", gains.b_r, taken.b_r, "N·m·s/rad");
}

void note_skipped(const Study& study) {
  const auto about = nlohmann::json::parse(study.about);
  std::vector<std::pair<std::string, int>> notes;  // each once, in the order of the study
  for (const auto& each : about.at("skipped")) {
    const std::string note = printable(each.at("kind").get<std::string>()) +
                             " contact: " + printable(each.at("reason").get<std::string>());
    auto same = std::ranges::find(notes, note, &std::pair<std::string, int>::first);
    if (same == notes.end()) same = notes.insert(same, {note, 0});
    ++same->second;
  }
  for (const auto& [note, count] : notes)
    std::cerr << "sonde: left out: " << note
              << (count > 1 ? " (" + std::to_string(count) + " of these)" : std::string()) << "\n";
}

}  // namespace sonde::app
