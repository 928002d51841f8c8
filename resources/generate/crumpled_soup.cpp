// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that make no solid: a crumpled sheet with holes, T-junctions, folds that cross, turned
// and repeated triangles and loose ones; and a star to feel it with.
#include <cmath>

#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

constexpr int cells = 96;
constexpr double side = 0.120;
constexpr std::uint64_t seed = 20160719;

/// The flat sheet's point (x, y) after crumpling: creases up and down, and folds that overtake each
/// other sideways.
Vec3 crumpled(double x, double y) {
  const Vec3 at(x / 0.030, y / 0.030, 0);
  double height = 0;
  double scale = 0.011;
  for (std::uint64_t octave = 0; octave < 4; ++octave) {
    const double frequency = std::pow(1.9, static_cast<double>(octave));
    height += scale * (0.45 - std::abs(noise(frequency * at, seed + octave)));
    scale *= 0.55;
  }
  const double shift_x = 0.016 * noise(0.9 * at, seed + 10) + 0.006 * noise(2.3 * at, seed + 11);
  const double shift_y = 0.016 * noise(0.9 * at, seed + 12) + 0.006 * noise(2.3 * at, seed + 13);
  return {x + shift_x, y + shift_y, height};
}

bool in_a_hole(double x, double y) {
  const auto within = [&](double cx, double cy, double r) {
    return std::hypot(x - cx, y - cy) < r;
  };
  return within(0.030, 0.022, 0.010) || within(-0.034, 0.012, 0.007) ||
         within(0.008, -0.038, 0.008) || within(-0.026, -0.034, 0.005);
}

/// The point of one side of a cell that only one of its two neighbours knows of: a T-junction.
void add_with_t_junction(Soup& sheet, const Triangle& t) {
  const auto middle = static_cast<std::uint32_t>(sheet.vertices.size());
  sheet.vertices.push_back(0.5 * (sheet.vertices[t[0]] + sheet.vertices[t[1]]) +
                           Vec3(0, 0, 0.0003));
  sheet.triangles.push_back({t[0], middle, t[2]});
  sheet.triangles.push_back({middle, t[1], t[2]});
}

void add_faulty(Soup& sheet, const Triangle& t, Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.03) {
    add_with_t_junction(sheet, t);
  } else if (kind < 0.05) {
    sheet.triangles.push_back({t[0], t[2], t[1]});  // turned over
  } else if (kind < 0.06) {
    sheet.triangles.insert(sheet.triangles.end(), {t, t});  // twice
  } else if (kind > 0.985) {
    return;  // missing
  } else {
    sheet.triangles.push_back(t);
  }
}

void add_loose(Soup& sheet, Random& random) {
  const auto first = static_cast<std::uint32_t>(sheet.vertices.size());
  const auto coordinate = [&](double reach) { return random.uniform(-reach, reach); };
  const Vec3 at(coordinate(side / 2), coordinate(side / 2), random.uniform(-0.012, 0.012));
  for (int k = 0; k < 3; ++k)
    sheet.vertices.emplace_back(at.x() + coordinate(0.003), at.y() + coordinate(0.003),
                                at.z() + coordinate(0.003));
  sheet.triangles.push_back({first, first + 1, first + 2});
}

Soup sheet_mesh() {
  Soup sheet;
  Random random(seed);
  const auto coordinate = [](int i) { return side * (static_cast<double>(i) / cells - 0.5); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      sheet.vertices.push_back(crumpled(coordinate(i), coordinate(j)));
  const auto index = [](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      if (in_a_hole(coordinate(i), coordinate(j))) continue;
      add_faulty(sheet, {index(i, j), index(i + 1, j), index(i + 1, j + 1)}, random);
      add_faulty(sheet, {index(i, j), index(i + 1, j + 1), index(i, j + 1)}, random);
    }
  for (int k = 0; k < 160; ++k) add_loose(sheet, random);
  return compacted(sheet);
}

/// A rounded star with six arms along the axes.
Soup star_mesh() {
  Soup star = icosphere(4);
  for (Vec3& x : star.vertices) {
    const double axial = x.array().pow(4).sum();  // 1 on the axes, a third between them
    x *= 0.0070 + 0.0060 * std::pow(axial, 3);
  }
  return star;
}

}  // namespace

void write_crumpled_soup(const Output& out) {
  out.mesh("crumpled.ply", sheet_mesh());
  out.mesh("star.ply", star_mesh());
  Path path({0.000, 0.000, 0.045}, {0, 0, 0});
  path.hold(0.2)
      .via(0.7, {0.002, -0.002, 0.018}, {20, 10, 15})
      .via(0.7, {0.008, -0.008, 0.007}, {30, 10, 30})   // pressed through
      .via(0.8, {0.022, -0.006, 0.008}, {40, -20, 50})  // and dragged along
      .via(0.8, {0.024, 0.014, 0.006}, {20, -40, 60})   // past a hole
      .via(0.8, {0.000, 0.026, 0.009}, {-20, -30, 70})
      .via(0.8, {-0.024, 0.014, 0.007}, {-40, 10, 60})
      .via(0.8, {-0.018, -0.012, 0.010}, {-20, 30, 40})
      .via(0.7, {-0.004, -0.004, 0.024}, {-10, 20, 20})
      .home(0.7)
      .hold(0.2);
  SceneText text{"crumpled-soup", "star.ply", "crumpled.ply", "surface"};
  text.k = 300;
  out.scene(text, path);
}

}  // namespace sonde::generate
