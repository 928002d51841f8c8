// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fitted_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/base/numbers.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/geometry/rotation.hpp"
#include "tests/support/rings.hpp"

namespace sonde::test {
namespace {

using Vec2 = Eigen::Vector2d;
constexpr double mm = 1e-3;

Vec2 at_angle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// 0 to 1 with level ends.
double eased(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::vector<double> heights(double half, const std::vector<double>& cuts) {
  std::vector<double> z{-half};
  for (const double cut : cuts) z.push_back(half * (2 * cut - 1));
  z.push_back(half);
  return z;
}

void add_ring(PolygonSoup& soup, const Section& section, double z) {
  for (const Vec2& x : section) soup.points.emplace_back(x.x(), x.y(), z);
}

/// Closes the ring that begins at a corner, flat.
void flat_lid(PolygonSoup& soup, std::size_t n, std::size_t ring, bool upwards) {
  lid_on_ring(soup, n, ring, {0, 0, soup.points[ring].z()}, upwards);
}

FittedScene scene(const std::string& name, const Section& section, double room, double outer,
                  const std::vector<double>& cuts, double floor, const FittedPath& path) {
  return {name, fitted_plug(section, 12 * mm, cuts),
          fitted_socket(grown(section, room), outer, 12 * mm, cuts, floor), path};
}

}  // namespace

Section regular_section(int sides, double radius) {
  Section out;
  for (int i = 0; i < sides; ++i) out.push_back(at_angle(radius, two_pi * i / sides));
  return out;
}

Section keyed_section(int sides, double radius, double key_radius, double half_width) {
  const double first = std::asin(half_width / radius);
  Section out;
  for (int i = 0; i <= sides; ++i)
    out.push_back(at_angle(radius, first + (two_pi - 2 * first) * i / sides));
  out.emplace_back(key_radius, -half_width);
  out.emplace_back(key_radius, half_width);
  return out;
}

Section toothed_section(int teeth, double root, double tip) {
  Section out;
  for (int i = 0; i < teeth; ++i) {
    const auto corner = [&](double share, double radius) {
      out.push_back(at_angle(radius, two_pi * (i + share) / teeth));
    };
    corner(-0.34, root), corner(-0.16, tip), corner(0.16, tip), corner(0.34, root);
  }
  return out;
}

Section dovetail_section(double width, double height, double lean) {
  return {{-width / 2, -height / 2},
          {width / 2, -height / 2},
          {width / 2 + lean, height / 2},
          {-width / 2 - lean, height / 2}};
}

Section grown(const Section& section, double by) {
  Section out;
  const std::size_t n = section.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto side = [&](std::size_t k) {
      const Vec2 along = section[(k + 1) % n] - section[k % n];
      return Vec2(Vec2(along.y(), -along.x()).normalized());
    };
    Eigen::Matrix2d normals;
    normals << side(i + n - 1).transpose(), side(i).transpose();
    out.push_back(section[i] + normals.inverse() * Vec2(by, by));
  }
  return out;
}

PolygonSoup fitted_plug(const Section& section, double half, const std::vector<double>& cuts) {
  PolygonSoup out;
  const std::size_t n = section.size();
  const std::vector<double> z = heights(half, cuts);
  for (const double height : z) add_ring(out, section, height);
  for (std::size_t k = 0; k + 1 < z.size(); ++k)
    wall_between_rings(out, n, k * n, (k + 1) * n, true);
  flat_lid(out, n, 0, false);
  flat_lid(out, n, (z.size() - 1) * n, true);
  return out;
}

PolygonSoup fitted_socket(const Section& hole, double outer, double half,
                          const std::vector<double>& cuts, double floor) {
  PolygonSoup out;
  const std::size_t n = hole.size();
  const std::vector<double> z = heights(half, cuts);
  for (const double height : z) add_ring(out, hole, height);
  const std::size_t top = (z.size() - 1) * n, outside = z.size() * n;
  Section wide = hole;
  double radius = 0;
  for (const Vec2& x : hole) radius = std::max(radius, x.norm());
  for (Vec2& x : wide) x *= outer * radius / x.norm();
  add_ring(out, wide, -half - floor);
  add_ring(out, wide, half);
  for (std::size_t k = 0; k + 1 < z.size(); ++k)
    wall_between_rings(out, n, k * n, (k + 1) * n, false);
  wall_between_rings(out, n, outside, outside + n, true);
  wall_between_rings(out, n, outside + n, top, true);
  if (floor > 0) {
    flat_lid(out, n, 0, true);
    flat_lid(out, n, outside, false);
  } else {
    wall_between_rings(out, n, 0, outside, true);
  }
  return out;
}

std::vector<double> even_strips(int count) {
  std::vector<double> cuts;
  for (int i = 1; i < count; ++i) cuts.push_back(double(i) / count);
  return cuts;
}

std::vector<double> random_strips(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> cuts;
  for (int i = 1; i < count; ++i) cuts.push_back(uniform(random, 0.02, 0.98));
  std::ranges::sort(cuts);
  return cuts;
}

std::vector<Pose> fitted_path(const FittedPath& path, int ticks) {
  std::mt19937_64 random(path.seed);
  std::array<double, 6> phase, rate;
  for (double& x : phase) x = uniform(random, 0, two_pi);
  for (double& x : rate) x = uniform(random, 1, 2.5);
  std::vector<Pose> out;
  for (int i = 0; i <= ticks; ++i) {
    const double x = double(i) / ticks;
    const double in = std::min(eased((x - 0.02) / 0.3), eased((0.98 - x) / 0.3));
    const double share = std::min(eased((x - 0.15) / 0.3), eased((0.85 - x) / 0.3));
    Vec6 wave;
    for (int k = 0; k < 6; ++k) {
      const auto u = static_cast<std::size_t>(k);
      wave[k] = share * std::sin(two_pi * rate[u] * x + phase[u]);
    }
    const Vec3 aside = path.aside * Vec3(wave[0], wave[1], 0.5 * wave[2]);
    const double z = path.from + in * (path.to - path.from);
    const double turn = (path.lead > 0 ? two_pi * z / path.lead : 0) + share * path.over;
    out.push_back(
        {(rotation_by(path.tilt * wave.tail<3>()) * Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())))
             .normalized(),
         aside + Vec3(0, 0, z)});
  }
  return out;
}

std::vector<FittedScene> fitted_scenes_cut(const std::vector<double>& cuts) {
  const Section key = keyed_section(14, 8 * mm, 10.5 * mm, 1.7 * mm),
                hexagon = regular_section(6, 9 * mm), teeth = toothed_section(7, 7 * mm, 9 * mm),
                dovetail = dovetail_section(11 * mm, 8 * mm, 3 * mm);
  // Askew on the rim, so that they get in a little and hold there.
  const auto at_mouth = [&](const std::string& name, const Section& section, std::uint64_t seed) {
    return scene(name + " at the mouth", section, 0.1 * mm, 1.6, cuts, 0,
                 {25 * mm, 20 * mm, 0.6 * mm, 0.05, seed});
  };
  return {
      at_mouth("key", keyed_section(40, 10 * mm, 12.5 * mm, 3.4 * mm), 21),
      at_mouth("key of few sides", key, 22),
      at_mouth("spline", teeth, 23),
      at_mouth("hexagon", hexagon, 24),
      scene("key", key, 0.08 * mm, 1.6, cuts, 5 * mm, {25 * mm, 1 * mm, 0.9 * mm, 0.05, 3}),
      scene("hexagon", hexagon, 0.05 * mm, 2, cuts, 6 * mm, {25 * mm, 1.5 * mm, 1.2 * mm, 0.06, 4}),
      scene("spline", teeth, 0.09 * mm, 1.7, cuts, 0, {25 * mm, 1 * mm, 0.7 * mm, 0.04, 5}),
      scene("dovetail", dovetail, 0.1 * mm, 2, cuts, 0, {25 * mm, 0, 1 * mm, 0.06, 6})};
}

std::vector<FittedScene> fitted_scenes() {
  std::vector<FittedScene> out = fitted_scenes_cut(even_strips(3));
  const auto add = [&](const std::string& name, const Section& section, double room, double floor,
                       int strips, const FittedPath& path) {
    out.push_back(scene(name, section, room, 1.8, random_strips(strips, path.seed), floor, path));
  };
  add("key, wedged", keyed_section(25, 7 * mm, 8.5 * mm, 1.2 * mm), 0.04 * mm, 4 * mm, 5,
      {25 * mm, 0, 3 * mm, 0.15, 11});
  add("square, wedged", regular_section(4, 10 * mm), 0.1 * mm, 4 * mm, 4,
      {25 * mm, 0, 2.5 * mm, 0.2, 12});
  add("hexagon, wedged", regular_section(6, 10 * mm), 0.05 * mm, 5 * mm, 7,
      {25 * mm, -1 * mm, 3 * mm, 0.15, 13});
  add("disc of 31", regular_section(31, 9 * mm), 0.06 * mm, 5 * mm, 4,
      {25 * mm, 1 * mm, 1 * mm, 0.04, 14});
  add("spline of 5, wedged", toothed_section(5, 6 * mm, 9 * mm), 0.05 * mm, 0, 3,
      {25 * mm, 0, 2 * mm, 0.12, 15});
  add("dovetail, wedged", dovetail_section(9 * mm, 7 * mm, 4 * mm), 0.08 * mm, 0, 2,
      {25 * mm, 0, 2.5 * mm, 0.15, 16});
  add("triangle", regular_section(3, 11 * mm), 0.12 * mm, 5 * mm, 6,
      {25 * mm, 1 * mm, 1 * mm, 0.08, 17});
  add("spline of 11", toothed_section(11, 8 * mm, 9 * mm), 0.06 * mm, 6 * mm, 2,
      {25 * mm, 1.2 * mm, 0.6 * mm, 0.05, 18});
  return out;
}

}  // namespace sonde::test
