// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde::reference {

/// Convex, with half axes of 1, 0.75 and 0.55 of the largest, m.
std::shared_ptr<const Body> egg(double half_length, int rings);

/// A J of round wire in the x–y plane: a straight shank from the top down to y = 0 at x = bow, then
/// five eighths of a circle about the origin. Closed, with flat ends; m.
std::shared_ptr<const Body> hook(double bow, double wire, double shank, int steps, int sides);

/// A wire wound about the z axis, its middle at the origin.
std::shared_ptr<const Body> coil(double radius, double pitch, double turns, double wire, int steps,
                                 int sides);
/// A section in the half plane (distance from the z axis > 0, z), counter-clockwise, turned about
/// the axis.
std::shared_ptr<const Body> lathe(const std::vector<Eigen::Vector2d>& section, int sides);
/// Teeth in a row on a back along x, pointing to +y; each of them a closed box of its own that
/// reaches into the back. A second one fits between the teeth with an eighth of a tooth to spare on
/// either side.
std::shared_ptr<const Body> comb(int teeth, double tooth, double length);

/// A rod along z with a thick knob at either end: a ring on it cannot be pulled off.
std::shared_ptr<const Body> dumbbell(double half_length, double rod, double knob);

std::shared_ptr<const Body> loose_triangles(int count, double size, std::uint64_t seed);

/// A mesh of libcgal-demo, moved and scaled so that no vertex lies further than `radius` from the
/// middle of its bounding box, m. Throws, saying what to install, where it is missing.
std::shared_ptr<const Body> real(const std::string& file, double radius);

/// A model of resources/models, as it is.
std::shared_ptr<const Body> model(const std::string& file);

}  // namespace sonde::reference
