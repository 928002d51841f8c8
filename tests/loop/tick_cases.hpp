// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/scene/poses.hpp"

namespace sonde::ticks {

/// Two bodies, and the path of a device that brings them together: what the solver is timed on.
struct TickCase {
  std::string name;
  std::shared_ptr<const Body> probe, fixed;
  std::vector<TimedPose> path;
  double k = 500;             ///< N/m, object norm
  Vec3 up = Vec3::UnitZ();    ///< unit: away from the fixed body, where the probe comes from
  bool flat_contact = false;  ///< all contact is with a plane across `up`: no force along the plane
};

/// A scene file and the trajectory that it names. Where `knots` is positive, its bodies are the
/// knots of the scene torus-knots with about so many triangles.
TickCase scene_case(const std::string& file, int knots);

/// A block that comes down on a slab, is pressed 3 mm into it, slid about without a turn, and
/// lifted off. The block's faces are cut into cuts × cuts squares of two triangles, the slab's into
/// some 1.3 times as many each way, so that few of their edges coincide. How finely they are cut
/// changes nothing about the two shapes, and so must not change the answer.
TickCase slab_case(int cuts);

/// Parts that fit into each other, pressed, wedged and jammed: those of fitted_parts.hpp and of
/// joints.hpp, 3000 ticks each. Their names hold `only`.
std::vector<TickCase> fitted_cases(const std::string& only);

}  // namespace sonde::ticks
