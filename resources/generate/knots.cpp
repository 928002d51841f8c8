// SPDX-License-Identifier: GPL-3.0-or-later
// Two interlocked trefoil knots and two linked tori: what no translation can take apart.
#include <cmath>

#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

constexpr double knot_major = 0.036;
constexpr double knot_minor = 0.016;
constexpr double knot_tube = 0.0065;

/// The (2, 3) torus knot: twice round the z axis, three times round the ring.
Vec3 trefoil(double u) {
  const double r = knot_major + knot_minor * std::cos(3 * u);
  return {r * std::cos(2 * u), r * std::sin(2 * u), knot_minor * std::sin(3 * u)};
}

Soup knot_mesh() {
  return wrapped_grid(360, 30, [](double u, double v) {
    const Vec3 c = trefoil(u);
    const Vec3 tangent = (trefoil(u + 1e-4) - trefoil(u - 1e-4)).normalized();
    const Vec3 radial = (c - knot_major * Vec3(std::cos(2 * u), std::sin(2 * u), 0)).normalized();
    const Vec3 side = tangent.cross(radial).normalized();
    const Vec3 up = side.cross(tangent);
    return Vec3(c + knot_tube * (std::cos(v) * up + std::sin(v) * side));
  });
}

}  // namespace

void write_torus_knots(const Output& out) {
  out.mesh("trefoil.ply", knot_mesh());
  // Interlocked, with 3 mm to spare all round: found by a search over poses.
  const Vec3 p(0.0696, 0.0049, 0.0191);
  const Vec3 turn(-20.7, 15.7, 61.8);
  Path path(p, turn);
  path.hold(0.2)
      .via(0.7, p + Vec3(0.008, 0, 0), turn)
      .via(0.7, p + Vec3(0.016, 0.004, 0.002), turn + Vec3(6, 0, 10))
      .via(0.8, p + Vec3(0.012, -0.006, 0.008), turn + Vec3(10, 12, -6))
      .via(0.8, p + Vec3(-0.010, -0.008, 0.012), turn + Vec3(-8, 20, -14))
      .via(0.9, p + Vec3(-0.018, 0.006, -0.004), turn + Vec3(-22, 4, 8))
      .via(0.8, p + Vec3(-0.004, 0.014, -0.014), turn + Vec3(-10, -14, 20))
      .via(0.8, p + Vec3(0.006, 0.006, -0.006), turn + Vec3(4, -6, 8))
      .home(0.9)
      .hold(0.2);
  SceneText text{"torus-knots", "trefoil.ply", "trefoil.ply", "auto"};
  text.k = 600;
  text.view = {0, -1, 0.6};
  out.scene(text, path);
}

void write_linked_tori(const Output& out) {
  out.mesh("torus.ply", torus(0.040, 0.012, 144, 72));
  // Each ring stands in the middle of the other's hole, 16 mm from it.
  const Vec3 p(0.040, 0, 0);
  const Vec3 turn(90, 0, 0);
  Path path(p, turn);
  path.hold(0.2)
      .via(0.6, p + Vec3(0.015, 0, 0), turn)
      .via(0.7, p + Vec3(0.024, 0.006, 0.002), turn + Vec3(15, 10, 0))
      .via(0.8, p + Vec3(0.020, 0.022, 0.006), turn + Vec3(30, 20, 25))
      .via(0.8, p + Vec3(0.002, 0.036, 0.010), turn + Vec3(20, -10, 60))
      .via(0.9, p + Vec3(-0.026, 0.020, 0.016), turn + Vec3(-20, -35, 40))
      .via(0.8, p + Vec3(-0.022, -0.010, -0.018), turn + Vec3(-45, -20, -10))
      .via(0.8, p + Vec3(-0.004, -0.008, -0.008), turn + Vec3(-10, 5, -10))
      .home(0.8)
      .hold(0.2);
  SceneText text{"linked-tori", "torus.ply", "torus.ply", "auto"};
  text.k = 500;
  text.view = {0.2, -1, 0.8};
  out.scene(text, path);
}

}  // namespace sonde::generate
