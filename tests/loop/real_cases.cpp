// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/loop/real_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/loop/device_path.hpp"
#include "tests/reference/meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ticks {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double probe_radius = 0.05, fixed_radius = 0.1;

struct RealPair {
  const char* name;
  const char* probe;
  const char* fixed;
  bool finer;  ///< each of the probe's triangles cut into four
  std::uint64_t seed;
};

constexpr std::array<RealPair, 4> pairs{{
    {"bunny on armadillo", "bunny00.off", "armadillo.off", false, 1},
    {"dragon on elephant", "ChineseDragon-10kv.off", "refined_elephant.off", false, 2},
    {"fandisk on diplodocus", "fandisk_large.off", "diplodocus.off", false, 3},
    {"man, cut in four, on bear", "man.off", "bear.off", true, 4},
}};

/// The same shape in four times as many triangles: none of libcgal-demo's has more than 100 000.
std::shared_ptr<const Body> cut_in_four(const Body& body) {
  PolygonSoup out;
  const auto& x = body.soup.vertices;
  for (const Triangle& t : body.soup.triangles) {
    const std::size_t first = out.points.size();
    const Vec3 a = x[t[0]], b = x[t[1]], c = x[t[2]];
    // A sum is the same in either order: the neighbour computes the same points.
    for (const Vec3& p : {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)})
      out.points.push_back(p);
    for (const auto& [i, j, k] : {std::array{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
      out.polygons.push_back({first + i, first + j, first + k});
  }
  return make_body(out, body.solid ? Model::solid : Model::surface, body.name + ", cut in four");
}

/// Where the probe, turned and moved aside, first comes on the fixed body on its way down: its
/// height above the middle, m; `lowest` where it passes by. No step is longer than the distance.
double touching_height(const Body& probe, const Body& fixed, const Quat& turn, const Vec3& aside,
                       const Vec3& up, double lowest) {
  double height = 1.5 * (probe_radius + fixed_radius);
  std::optional<DistanceHint> hint;
  for (int i = 0; i < 200 && height > lowest; ++i) {
    const Distance d =
        triangle_distance(probe, fixed, Transform(Pose{turn, aside + height * up}), hint);
    if (d.distance < 1e-3 * probe_radius) break;
    hint = DistanceHint{d.triangle_a, d.triangle_b};
    height -= d.distance;
  }
  return std::max(height, lowest);
}

Vec3 phases(std::mt19937_64& random) {
  const double x = test::uniform(random, 0, two_pi), y = test::uniform(random, 0, two_pi);
  return {x, y, test::uniform(random, 0, two_pi)};
}

/// Down, about and off again. The surface that the path follows is that on which the turned probe
/// touches, so that the pressing is what is asked for wherever the surface goes.
generate::Path press_and_slide(const Body& probe, const Body& fixed, const Vec3& up,
                               std::mt19937_64& random) {
  constexpr int keys = 240;
  const Vec3 along = up.unitOrthogonal(), across = up.cross(along);
  const Vec3 about = phases(random), turning = phases(random), pressing = phases(random);
  const auto wave = [](double turns, double phase) { return std::sin(two_pi * turns + phase); };
  struct Key {
    Vec3 turn, at;
    double speed;
  };
  const auto key = [&](double u) {
    const Vec3 turn(25 * wave(u, turning.x()), 25 * wave(2 * u, turning.y()),
                    40 * wave(u, turning.z()));
    const Vec3 aside =
        0.35 * fixed_radius * (wave(2 * u, about.x()) * along + wave(3 * u, about.y()) * across);
    const Vec3 rad = turn * (std::numbers::pi / 180);
    const Quat q(Eigen::AngleAxisd(rad.norm(), rad.stableNormalized()));
    const double pressed = probe_radius * (0.03 + 0.02 * wave(7 * u, pressing.x()));
    const double height = touching_height(probe, fixed, q, aside, up, -0.3 * fixed_radius);
    return Key{turn, aside + (height - pressed) * up, 0.09 + 0.04 * wave(5 * u, pressing.y())};
  };
  Key last = key(0);
  generate::Path path(last.at + 0.3 * probe_radius * up, last.turn);
  path.hold(0.05).via(0.25, last.at, last.turn);
  for (int i = 1; i <= keys; ++i) {
    const Key next = key(static_cast<double>(i) / keys);
    const double turned = (next.turn - last.turn).norm() * (std::numbers::pi / 180);
    const double way = std::hypot((next.at - last.at).norm(), 0.5 * probe_radius * turned);
    path.via(way / next.speed, next.at, next.turn);
    last = next;
  }
  path.rest(0.25, last.at + 0.3 * probe_radius * up, last.turn).hold(0.05);
  return path;
}

}  // namespace

std::vector<std::string> real_pairs() {
  std::vector<std::string> out;
  out.reserve(pairs.size());
  for (const RealPair& pair : pairs) out.emplace_back(pair.name);
  return out;
}

TickCase real_case(const std::string& name) {
  const auto* const pair =
      std::find_if(pairs.begin(), pairs.end(), [&](const RealPair& p) { return p.name == name; });
  if (pair == pairs.end()) throw std::invalid_argument("no pair is called " + name);
  TickCase out;
  out.name = name;
  out.probe = reference::real(pair->probe, probe_radius);
  if (pair->finer) out.probe = cut_in_four(*out.probe);
  out.fixed = reference::real(pair->fixed, fixed_radius);
  std::mt19937_64 random(pair->seed);
  out.up = test::random_in_ball(random, 1).normalized();
  out.path = sampled(press_and_slide(*out.probe, *out.fixed, out.up, random));
  if (overlap(*out.probe, *out.fixed, Transform(out.path.front().pose), Doubt::exact))
    throw std::runtime_error(name + ": the path does not start free");
  return out;
}

}  // namespace sonde::ticks
