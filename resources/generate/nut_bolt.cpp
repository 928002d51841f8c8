// SPDX-License-Identifier: GPL-3.0-or-later
// A hexagon bolt and its nut, with a thread that meshes.
#include <algorithm>
#include <cmath>

#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

constexpr int sides = 72;         ///< a multiple of six, so that the hexagons have their corners
constexpr double pitch = 0.0050;  ///< right-handed
constexpr double mean_radius = 0.0100;  ///< of the bolt's thread
constexpr double amplitude = 0.0011;    ///< half the thread's depth
constexpr double clearance = 0.0003;    ///< radial, of the nut
constexpr int rows_per_pitch = 14;

/// Radius of the thread at an angle and a height: a rounded trapezium along z.
double thread_radius(double angle, double z) {
  const double phase = std::sin(two_pi * z / pitch - angle);
  return mean_radius + amplitude * std::tanh(1.6 * phase) / std::tanh(1.6);
}

double hexagon_radius(double across_flats, double angle) {
  const double sector = two_pi / 6;
  const double off = angle - sector * std::floor(angle / sector) - sector / 2;
  return across_flats / 2 / std::cos(off);
}

template <typename Radius>
Ring ring_at(double z, const Radius& radius) {
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const double a = two_pi * i / sides;
    const double r = radius(a);
    ring.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return ring;
}

Ring circle(double z, double r) {
  return ring_at(z, [r](double) { return r; });
}

Ring hexagon(double z, double across_flats, double at_most) {
  return ring_at(z, [=](double a) { return std::min(at_most, hexagon_radius(across_flats, a)); });
}

/// Head from z = -9 mm to 0, shank 4 mm, thread to 36 mm, bevelled end.
Soup bolt_mesh() {
  constexpr double head = 0.009, flats = 0.032, shank = 0.004, end = 0.036;
  std::vector<Ring> rings = {circle(-head, 0.008), hexagon(-head, flats, 0.0158)};
  for (const double z : {-0.0080, -0.0055, -0.0030, -0.0005}) rings.push_back(hexagon(z, flats, 1));
  rings.push_back(circle(0, 0.0155));
  rings.push_back(circle(0, 0.0125));
  for (const double z : {0.0, 0.0013, 0.0026}) rings.push_back(circle(z, mean_radius + amplitude));
  const int rows = static_cast<int>(std::lround((end - shank) / pitch * rows_per_pitch));
  for (int i = 0; i <= rows; ++i) {
    const double z = shank + (end - shank) * i / rows;
    const double bevel = mean_radius - 1.3 * amplitude + 0.8 * (end - z);
    rings.push_back(ring_at(z, [=](double a) { return std::min(bevel, thread_radius(a, z)); }));
  }
  rings.push_back(circle(end, 0.5 * mean_radius));
  return loft(rings, Ends::capped, Vec3(0, 0, -head), Vec3(0, 0, end));
}

/// The nut from z = 0 to 13 mm. Its thread is in phase with the bolt's at the pose zero.
Soup nut_mesh() {
  constexpr double height = 0.013, flats = 0.030;
  std::vector<Ring> rings = {hexagon(0, flats, 0.0152)};
  for (const double z : {0.0012, 0.0040, 0.0065, 0.0090, 0.0118})
    rings.push_back(hexagon(z, flats, 1));
  rings.push_back(hexagon(height, flats, 0.0152));
  const int rows = static_cast<int>(std::lround(height / pitch * rows_per_pitch));
  for (int i = 0; i <= rows; ++i) {
    const double z = height * (1 - static_cast<double>(i) / rows);
    const double depth = std::min(z, height - z);
    const double bevel = mean_radius + amplitude + 0.0008 - depth;
    rings.push_back(
        ring_at(z, [=](double a) { return std::max(bevel, thread_radius(a, z) + clearance); }));
  }
  return loft(rings, Ends::joined);
}

/// Turn about z, in degrees, that keeps the threads in phase at a height of the nut.
double turn_at(double z) { return 360 * z / pitch; }

}  // namespace

void write_nut_on_bolt(const Output& out) {
  out.mesh("bolt.ply", bolt_mesh());
  out.mesh("nut.ply", nut_mesh());
  const auto in_phase = [](double z) { return Vec3(0, 0, turn_at(z)); };
  const double begin = 0.0365;  // the nut's lower face just above the bolt's end
  const double end = 0.0255;    // and two turns further down
  Path path({0.003, 0.002, 0.048}, in_phase(begin) + Vec3(12, -8, 20));
  path.hold(0.2)
      .via(0.7, {0.002, 0.001, 0.0340}, in_phase(begin) + Vec3(7, -5, 15))  // crossed, pressed on
      .via(0.5, {0.0005, 0, 0.0330}, in_phase(begin) + Vec3(2, -3, -20))
      .rest(0.6, {0, 0, begin}, in_phase(begin))  // lifted, square and in phase
      .via(0.8, {0, 0, 0.0345}, in_phase(0.0345))
      .via(0.8, {0.0001, 0, 0.0320}, in_phase(0.0320) + Vec3(0.2, 0.2, 15))  // onto the flanks
      .via(0.8, {0, 0.0001, 0.0295}, in_phase(0.0295) + Vec3(0.2, -0.2, -18))
      .via(0.8, {0, 0, 0.0270}, in_phase(0.0270))
      .rest(0.8, {0, 0, end}, in_phase(end))
      .via(0.6, {0.0006, 0, end + 0.0027}, in_phase(end) + Vec3(3, 2, 0))  // pulled, not turned
      .via(0.6, {0, 0.0008, end - 0.0010}, in_phase(end) + Vec3(-3, 1, 10))
      .rest(0.6, {0, 0, end}, in_phase(end))
      .hold(0.2);
  SceneText text{"nut-on-bolt", "nut.ply", "bolt.ply", "auto"};
  text.k = 800;
  text.view = {-0.3, -1, 0.45};
  out.scene(text, path);
}

}  // namespace sonde::generate
