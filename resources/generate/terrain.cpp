// SPDX-License-Identifier: GPL-3.0-or-later
// A boulder on rough ground.
#include <cmath>

#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

constexpr int cells = 120;
constexpr double side = 0.200;
constexpr double base = -0.040;
constexpr std::uint64_t seed = 1969;

double height(double x, double y) {
  const Vec3 at(x / 0.070, y / 0.070, 0.5);
  const double hills = 0.022 * fractal_noise(at, 6, 0.48, seed);
  const double ridges = 0.012 * (0.4 - std::abs(noise(1.3 * at, seed + 100)));
  return hills + ridges;
}

/// A closed solid: the ground above, four walls, and a floor fanned from its middle.
Soup ground_mesh() {
  Soup ground;
  const auto coordinate = [](int i) { return side * (static_cast<double>(i) / cells - 0.5); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double x = coordinate(i), y = coordinate(j);
      ground.vertices.emplace_back(x, y, height(x, y));
    }
  const auto index = [](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      ground.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      ground.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  std::vector<std::uint32_t> rim;  // anticlockwise seen from above
  rim.reserve(4 * cells);
  for (int i = 0; i < cells; ++i) rim.push_back(index(i, 0));
  for (int j = 0; j < cells; ++j) rim.push_back(index(cells, j));
  for (int i = cells; i > 0; --i) rim.push_back(index(i, cells));
  for (int j = cells; j > 0; --j) rim.push_back(index(0, j));
  const auto count = static_cast<std::uint32_t>(rim.size());
  const auto below = static_cast<std::uint32_t>(ground.vertices.size());
  for (const std::uint32_t v : rim) {
    const Vec3 x = ground.vertices[v];
    ground.vertices.emplace_back(x.x(), x.y(), base);
  }
  ground.vertices.emplace_back(0, 0, base);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    ground.triangles.push_back({rim[k], below + k, below + next});
    ground.triangles.push_back({rim[k], below + next, rim[next]});
    ground.triangles.push_back({below + count, below + next, below + k});
  }
  return ground;
}

Soup boulder_mesh() {
  Soup boulder = icosphere(4);
  for (Vec3& x : boulder.vertices) {
    const double rough = 1 + 0.30 * fractal_noise(1.6 * x + Vec3(7, 3, 5), 4, 0.45, seed + 200);
    x = 0.017 * rough * x.cwiseProduct(Vec3(1.25, 1.0, 0.8));
  }
  return boulder;
}

}  // namespace

void write_terrain(const Output& out) {
  out.mesh("ground.ply", ground_mesh());
  out.mesh("boulder.ply", boulder_mesh());
  const auto on_ground = [](double x, double y, double above) {
    return Vec3(x, y, height(x, y) + above);
  };
  Path path(on_ground(-0.060, -0.040, 0.060), {0, 0, 0});
  path.hold(0.2)
      .via(0.7, on_ground(-0.056, -0.036, 0.022), {20, 10, 10})
      .via(0.7, on_ground(-0.036, -0.026, 0.013), {10, 80, 20})  // rolled along the ground
      .via(0.8, on_ground(-0.008, -0.004, 0.014), {-30, 170, 30})
      .via(0.8, on_ground(0.022, 0.016, 0.013), {-60, 250, 10})
      .via(0.8, on_ground(0.050, 0.000, 0.011), {-20, 330, -20})  // pushed in
      .via(0.8, on_ground(0.040, -0.030, 0.015), {40, 300, -60})
      .via(0.8, on_ground(0.010, -0.040, 0.017), {60, 200, -40})
      .via(0.7, on_ground(-0.030, -0.040, 0.040), {30, 80, -10})
      .home(0.7)
      .hold(0.2);
  SceneText text{"terrain", "boulder.ply", "ground.ply", "auto"};
  text.k = 400;
  out.scene(text, path);
}

}  // namespace sonde::generate
