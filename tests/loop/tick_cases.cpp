// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/loop/tick_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/scene/scene.hpp"
#include "tests/loop/device_path.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/joints.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ticks {
namespace {

std::shared_ptr<const Body> knot(int triangles) {
  const int sides = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 24.0))));
  return test::body(test::torus_knot(2, 3, 0.036, 0.016, 0.0065, 12 * sides, sides));
}

/// A box with its middle at the origin, each face cut into cuts × cuts squares of two triangles.
/// Faces that meet compute the points of their edge in the same way, so that it closes.
PolygonSoup cut_box(const Vec3& size, int cuts) {
  PolygonSoup out;
  const auto point = [&](const std::array<int, 3>& step) {
    const Vec3 share(step[0], step[1], step[2]);
    return Vec3(size.cwiseProduct(share / cuts - Vec3::Constant(0.5)));
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, cuts}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::size_t first = out.points.size();
      for (int i = 0; i <= cuts; ++i)
        for (int j = 0; j <= cuts; ++j) {
          std::array<int, 3> step{};
          step[axis] = end;
          step[u] = i;
          step[v] = j;
          out.points.push_back(point(step));
        }
      const auto at = [&](int i, int j) {
        return first + static_cast<std::size_t>(i * (cuts + 1) + j);
      };
      for (int i = 0; i < cuts; ++i)
        for (int j = 0; j < cuts; ++j) {
          std::array<std::size_t, 4> c{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (end == 0) std::swap(c[1], c[3]);
          out.polygons.push_back({c[0], c[1], c[2]});
          out.polygons.push_back({c[0], c[2], c[3]});
        }
    }
  return out;
}

}  // namespace

TickCase scene_case(const std::string& file, int knots) {
  const Scene scene = read_scene(file);
  if (!scene.trajectory) throw InputError::in(file, "the scene names no trajectory");
  TickCase out;
  out.name = scene.name;
  out.path = read_trajectory(*scene.trajectory);
  out.k = scene.coupling.k;
  if (knots > 0) {
    out.probe = out.fixed = knot(knots);
    out.name = "knots";
  } else {
    out.probe = load(scene.probe, scene.unit);
    out.fixed = load(scene.fixed, scene.unit);
  }
  return out;
}

TickCase slab_case(int cuts) {
  constexpr double thickness = 0.02, pressed = 0.003, above = 0.004;
  TickCase out;
  out.name = "slab " + std::to_string(cuts);
  out.probe = test::body(cut_box({0.04, 0.04, thickness}, cuts));
  out.fixed =
      test::body(cut_box({0.12, 0.12, thickness}, static_cast<int>(std::lround(1.3 * cuts))));
  out.flat_contact = true;
  const auto at = [&](double x, double y, double height) { return Vec3(x, y, thickness + height); };
  const Vec3 none = Vec3::Zero();
  // Across the squares of either face, never beyond the slab's edges.
  generate::Path path(at(-0.011, -0.007, above), none);
  path.hold(0.02)
      .rest(0.15, at(-0.011, -0.007, -pressed), none)
      .via(0.25, at(0.005, 0.003, -pressed), none)
      .via(0.25, at(0.011, -0.009, -pressed), none)
      .rest(0.25, at(-0.004, 0.008, -pressed), none)
      .rest(0.15, at(-0.004, 0.008, above), none)
      .hold(0.02);
  out.path = sampled(path);
  return out;
}

std::vector<TickCase> fitted_cases(const std::string& only) {
  std::vector<test::FittedScene> scenes = test::fitted_scenes();
  for (test::FittedScene& joint : test::joint_scenes()) scenes.push_back(std::move(joint));
  std::vector<TickCase> out;
  for (const test::FittedScene& scene : scenes) {
    if (scene.name.find(only) == std::string::npos) continue;
    TickCase c;
    c.name = scene.name;
    c.probe = test::body(scene.probe);
    c.fixed = test::body(scene.fixed);
    const std::vector<Pose> poses = test::fitted_path(scene.path, 3000);
    for (std::size_t i = 0; i < poses.size(); ++i)
      c.path.push_back({1e-3 * static_cast<double>(i), poses[i]});
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace sonde::ticks
