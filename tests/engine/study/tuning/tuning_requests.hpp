// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of tuning study.
#pragma once

#include <algorithm>
#include <string>

#include "engine/scene/scene.hpp"
#include "engine/study/tuning/tuning_results.hpp"
#include "engine/study/tuning/tuning_study.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {

inline DeviceProfile profile(const std::string& id = "sigma.7") {
  return read_device_profile(std::string(SONDE_RESOURCES "/devices/") + id + ".json");
}

/// A small box pressed on a large one, in one situation; of the assumed values only the mass: there
/// is little to do.
inline TuningRequest pressed_boxes() {
  TuningRequest request{.pair = {body(box({0.06, 0.05, 0.04})), body(box({0.2, 0.2, 0.1}))}};
  request.X_FM = {Quat::Identity(), {0, 0, 0.1}};
  request.device = profile();
  for (const ProfileKey& key : profile_keys()) (request.device.*key.value).assumed = false;
  request.device.mass.assumed = true;
  request.ratio = 1.5;
  for (int i = 0; i < 30; ++i)
    request.path.push_back({i * 1e-3, {Quat::Identity(), {0.01, 0.005, 0.075 - i * 2e-4}}});
  return request;
}

// Scenes that ship, on devices that do.

inline TuningRequest in_scene(const std::string& name, const std::string& device = "sigma.7") {
  const Scene scene = read_scene(SONDE_RESOURCES "/scenes/" + name + ".sonde.json");
  TuningRequest request{.pair = {load(scene.probe, scene.unit), load(scene.fixed, scene.unit)}};
  request.X_FM = relative_pose(scene);
  request.coupling = scene.coupling;
  request.device = profile(device);
  for (const ProfileKey& key : profile_keys()) (request.device.*key.value).assumed = false;
  return request;
}
inline TuningRequest spoon_in_cup() { return in_scene("spoon-in-cup"); }

/// Of what is recommended alone, without what each axis could do by itself.
inline TuningResults tuned(const TuningRequest& request) {
  const TempFolder folder;
  Study study = plan_tuning(request, 1, never);
  std::erase_if(study.parts, [](const StudyPart& part) {
    return part.name.ends_with(".translation") || part.name.ends_with(".rotation");
  });
  compute_parts(folder.path(), study, {}, 2, never);
  return read_tuning("", read_study(folder.path()));
}

}  // namespace sonde::test
