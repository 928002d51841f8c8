// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/study/comparison/analytic_wrench.hpp"
#include "engine/study/rendering/discontinuities.hpp"
#include "engine/study/rendering/smoothness.hpp"
#include "engine/study/stability/stable_stiffness.hpp"

namespace sonde {

/// The input of `sonde compare`: one device path rendered with PD_t (clustered contacts) and with
/// PD_g, by the same loop and the same coupling.
struct CompareSetup {
  RenderSetup render;
  std::vector<TimedPose> path = {};
  std::string scene = {};  ///< its name, for titles
  /// With a device, the study also computes the largest stable stiffness of both.
  std::optional<SimulatedDeviceParameters> device = {};
  double sample_time = 1e-3;  ///< of the device's loop, s
  std::string inputs = "{}";  ///< JSON object that identifies the input files and the program
};

/// The study: a part for each rendering, one for the analytic wrenches, and with a device one for
/// the largest stable stiffness of each.
Study compare_study(const CompareSetup& setup);

/// The measures of one rendering.
struct MethodMeasures {
  double peak_force = 0, peak_torque = 0;            ///< N, N·m
  double force_variation = 0, torque_variation = 0;  ///< total_variation, N and N·m
  /// Shares of the spectrum above 50 Hz; none if the path is not evenly sampled, is sampled too
  /// slowly, or no force was felt.
  std::optional<double> force_above_50, torque_above_50;
  Discontinuities discontinuities;
  TorqueRealism realism;
  StableStiffness stiffness;  ///< none without a device
  double deepest = 0;         ///< m
  int contact_ticks = 0;      ///< with a force
  int failed_ticks = 0;
  int unconverged_ticks = 0;  ///< blocked, or out of budget
  int saturated_ticks = 0;    ///< beyond a limit of the device
  /// Total variation over the peak, which removes the effect of a larger force. 0 if there is no
  /// force.
  double force_restlessness() const { return peak_force > 0 ? force_variation / peak_force : 0; }
  double torque_restlessness() const {
    return peak_torque > 0 ? torque_variation / peak_torque : 0;
  }
};

struct Comparison {
  std::string scene;
  double stiffness = 0;  ///< N/m, against translation
  double radius = 0;     ///< of the probe, m
  double max_force = 0, max_torque = 0;
  Rendering pdt, pdg;
  MethodMeasures of_pdt, of_pdg;
};

/// The result of a complete folder of the study; `folder` is for error messages. Throws InputError
/// if a part is missing or was not written by the study.
Comparison comparison_of(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
