// SPDX-License-Identifier: GPL-3.0-or-later
// The scene one starts with: a teaspoon in a cup.
#include <algorithm>
#include <cmath>
#include <utility>

#include "resources/generate/cup.hpp"
#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

// The spoon: the bowl about the origin, open towards +y, the handle up along +z.

constexpr double bowl_low = -0.026;   ///< z of the tip of the bowl
constexpr double handle_end = 0.112;  ///< z of the end of the handle

/// Half the width of the spoon seen from the front.
double half_width(double z) {
  const double s = (z - bowl_low) / 0.052;  // 0 to 1 along the bowl
  const double egg =
      s < 1 ? 0.0165 * std::pow(std::sin(std::numbers::pi * std::pow(s, 0.82)), 0.6) : 0.0;
  const double neck = 0.0024 + 0.0036 * smooth_step(0.035, handle_end - 0.008, z);
  const double tip = std::sqrt(std::max(0.0, 1 - std::pow(std::max(0.0, (z - 0.104) / 0.008), 2)));
  const double handle = neck * tip * smooth_step(0.006, 0.024, z);
  return std::max(1e-5, std::pow(std::pow(egg, 4) + std::pow(handle, 4), 0.25));
}

/// Depth of the bowl's middle below its edge.
double dish(double z) {
  const double s = std::min(1.0, std::max(0.0, (z - bowl_low) / 0.054));
  return 0.0075 * std::pow(std::sin(std::numbers::pi * s), 1.2);
}

/// The y of the spoon's edge line: level along the bowl, then a curved handle.
double edge_line(double z) {
  const double s = std::max(0.0, (z - 0.016) / (handle_end - 0.016));
  return 0.010 * s * s * (3 - 2 * s) - 0.006 * std::sin(two_pi * s) * smooth_step(0, 0.25, s);
}

Vec3 spoon_point(double z, double angle) {
  const double half_thickness = 0.5 * (0.0014 + 0.0010 * smooth_step(0.015, 0.035, z)) *
                                std::sqrt(std::min(1.0, half_width(z) / 0.0012));
  const double across = std::cos(angle);
  const double depth = dish(z) * (1 - across * across);
  return {-half_width(z) * across, edge_line(z) - depth + half_thickness * std::sin(angle), z};
}

Soup spoon_mesh() {
  const int rings = 104;
  const int sides = 48;
  std::vector<Ring> skin;
  for (int i = 1; i < rings; ++i) {
    // Closer together towards both ends, where the outline turns.
    const double s = 0.5 - 0.5 * std::cos(std::numbers::pi * i / rings);
    const double z = bowl_low + (handle_end - bowl_low) * (0.6 * s + 0.4 * i / rings);
    Ring ring;
    for (int j = 0; j < sides; ++j) ring.push_back(spoon_point(z, -two_pi * j / sides));
    skin.push_back(std::move(ring));
  }
  return loft(skin, Ends::capped, Vec3(0, edge_line(bowl_low), bowl_low),
              Vec3(0, edge_line(handle_end), handle_end));
}

}  // namespace

void write_spoon_in_cup(const Output& out) {
  out.mesh("cup.ply", cup_mesh());
  out.mesh("spoon.ply", spoon_mesh());
  Path path({0.000, 0.000, 0.135}, {-10, 0, 0});
  path.hold(0.2)
      .via(0.8, {0.004, 0.000, 0.080}, {-14, 0, 10})
      .via(0.5, {0.004, 0.002, 0.038}, {-12, 4, 25})
      .via(0.6, {0.002, 0.004, 0.020}, {-6, 6, 40})  // through the floor
      .via(0.5, {0.010, 0.006, 0.034}, {-8, 8, 60})
      .via(0.6, {0.032, 0.004, 0.036}, {-6, 16, 90})  // into the wall
      .via(0.6, {0.026, 0.026, 0.034}, {-12, 12, 130})
      .via(0.6, {-0.006, 0.038, 0.036}, {-24, -4, 170})  // and along it
      .via(0.6, {-0.032, 0.014, 0.042}, {-8, -24, 210})
      .via(0.6, {-0.010, -0.004, 0.048}, {0, -8, 190})
      .via(0.7, {0.000, 0.000, 0.085}, {-6, 0, 100})
      .home(0.9)
      .hold(0.2);
  SceneText text{"spoon-in-cup", "spoon.ply", "cup.ply", "auto"};
  text.k = 500;
  text.view = {0.35, -1, 0.65};
  out.scene(text, path);
}

}  // namespace sonde::generate
