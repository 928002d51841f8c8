// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a tune study that nobody ran: two situations of the object norm, stable up to
// 1500 and 900 N/m, so that 900/1.5 = 600 N/m are recommended. At half the mass assumed it is
// 450/1.5 = 300 N/m.
#pragma once

#include <filesystem>
#include <string>

#include "engine/study/parts/study_parts.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::ui::test {

inline std::string run_json(double stiffness, bool stable) {
  return R"({"stiffness": )" + std::to_string(stiffness) + R"(, "stable": )" +
         (stable ? "true" : "false") + R"(, "chattering": false, "saturated": false, "growth": 0,
      "work": 0, "chatter": 0, "saturation": 0, "force_error": 0.01, "torque_error": 0.01,
      "depth": 0.001, "contact": 1, "force": 3, "torque": 0.1, "jumps": 0, "pop_throughs": 0, "failures": 0})";
}

inline StudyPart canned_part(int situation, double stable, const std::string& assumed = "null",
                             double times = 1, const std::string& second = "edge") {
  const std::string kind = situation == 0 ? "flat" : second;
  const std::string text =
      R"({"situation": )" + std::to_string(situation) + R"(, "kind": ")" + kind +
      R"(", "hand": "light", "axis": "object", "assumed": )" + assumed + R"(, "times": )" +
      std::to_string(times) + R"(, "columns": [{"damping": 0, "theory_stable": )" +
      std::to_string(0.9 * stable) + R"(, "theory_passive": )" + std::to_string(0.4 * stable) +
      R"(, "stable": )" + std::to_string(stable) + R"(, "stable_ends_by": "stability", "good": )" +
      std::to_string(stable) + R"(, "good_ends_by": "stability", "runs": [)" +
      run_json(stable / 4, true) + "," + run_json(stable, true) + "," +
      run_json(1.02 * stable, false) + "," + run_json(4 * stable, false) + "]}]}";
  return {kind + std::to_string(situation) + "." + std::to_string(int(100 * times)),
          [text](const Stop&) { return text; }};
}

/// Of two bodies made of these files.
inline void write_canned_study(const std::filesystem::path& folder,
                               const std::filesystem::path& probe,
                               const std::filesystem::path& fixed,
                               const std::string& device = "sigma.7",
                               const std::string& second = "edge") {
  const auto file = [](const std::filesystem::path& path) {
    return R"({"file": ")" + path.filename().string() + R"(", "fingerprint": ")" +
           fingerprint(read_text(path, 1 << 20)) + "\"}";
  };
  Study study{"tune", "", {}};
  study.about = R"({"inputs": {"probe": )" + file(probe) + R"(, "fixed": )" + file(fixed) +
                R"(}, "mode": "object", "sample_time": 0.001, "max_force": 8, "max_torque": 0.2,
      "device": {"id": ")" +
                device + R"(", "mass": {"value": 0.3, "assumed": "a guess"},
      "inertia": {"value": 2e-4}, "max_stiffness": {"value": 1e5}, "max_force": {"value": 12},
      "max_torque": {"value": 0.2}, "max_rotational_stiffness": {"value": 100},
      "friction": {"value": 0.4}, "rotational_friction": {"value": 0.005},
      "resolution": {"value": 0}, "rotational_resolution": {"value": 0}},
      "rotational_stiffness_per_translational": 0, "rotational_damping_per_translational": 0,
      "situations": [{"largest_translational_stiffness": 1, "largest_rotational_stiffness": 1e-3},
      {"largest_translational_stiffness": 1, "largest_rotational_stiffness": 1e-3}]})";
  study.parts = {canned_part(0, 1500), canned_part(1, 900, "null", 1, second),
                 canned_part(1, 450, "\"mass\"", 0.5, second),
                 canned_part(1, 1000, "\"mass\"", 2, second)};
  compute_parts(folder, study, {}, 1, [] { return false; });
}

}  // namespace sonde::ui::test
