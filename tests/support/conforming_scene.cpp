// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/conforming_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde::test {
namespace {

// Block and slab.
constexpr double block_height = 0.03, slab_height = 0.02;
const Vec3 block_size(0.04, 0.06, block_height), slab_size(0.2, 0.2, slab_height);

// Cylinder and hole.
constexpr int sides = 24;
constexpr double rod_radius = 0.01, hole_radius = 0.0101;

Pose turned_about(const Vec3& turn, const Vec3& p) { return {rotation_by(turn), p}; }

/// 0 to 1 and back with level ends.
double swell(double x) { return 0.5 - 0.5 * std::cos(two_pi * x); }

Cutting finer(Cutting cutting) {
  if (cutting.n > 1) cutting.n += 3;
  cutting.seed += 1000;
  return cutting;
}

/// A path of three parts: in, x from 0 to 1; along; out, x from 1 to 0.
std::vector<Pose> there_and_back(int in, int along, const std::function<Pose(double)>& press,
                                 const std::function<Pose(double)>& slide,
                                 const std::function<Pose(double)>& lift) {
  std::vector<Pose> out;
  for (int i = 0; i < in; ++i) out.push_back(press(double(i) / in));
  for (int i = 0; i <= along; ++i) out.push_back(slide(double(i) / along));
  for (int i = in - 1; i >= 0; --i) out.push_back(lift(double(i) / in));
  return out;
}

std::vector<Pose> sampled(int ticks, const std::function<Pose(double)>& loop) {
  std::vector<Pose> out;
  for (int i = 0; i <= ticks; ++i) out.push_back(loop(double(i) / ticks));
  return out;
}

Pose block_at(double x, double y, double height, double yaw) {
  return turned_about({0, 0, yaw}, {x, y, (slab_height + block_height) / 2 + height});
}

}  // namespace

Skew askew() {
  return {Quat(0.4, -0.5, 0.3, 0.7).normalized(), Quat(0.8, 0.3, -0.4, 0.33).normalized()};
}

BodyPairCut cut_bodies(const ConformingScene& scene, const Cutting& cutting, const Skew& skew) {
  return {body(turned(scene.probe(cutting), skew.probe)),
          body(turned(scene.fixed(finer(cutting)), skew.world))};
}

std::vector<Felt> follow(const BodyPairCut& bodies, const std::vector<Pose>& path,
                         const Skew& skew) {
  CoherentSolver solver({bodies.probe, bodies.fixed});
  const Pose world{skew.world, Vec3::Zero()}, probe{skew.probe.conjugate(), Vec3::Zero()};
  std::vector<Felt> out;
  for (const Pose& X : path) {
    const Pose device = world * X * probe;
    const Separation& s = out.empty() ? solver.reset(device) : solver.tick(device);
    const Wrench w = object_norm_wrench(bodies.probe->mass, s.device, s.separated, felt_stiffness);
    const Quat back = skew.world.conjugate();
    out.push_back(
        {back * w.force, back * w.torque, s.depth, s.status, s.converged, s.jumped, s.separated});
  }
  return out;
}

ConformingScene block_on_slab() { return block_on_slab_off(0); }

ConformingScene block_on_slab_off(double angle) {
  constexpr double clear = 1.03e-3, pressed = 3e-3;
  const auto tilted = [angle](const Pose& X) {
    return X * turned_about(angle * Vec3(1, 0.4, 0).normalized(), Vec3::Zero());
  };
  const auto height = [](double x) { return clear - (clear + pressed) * x; };
  return {
      "block on slab", [](const Cutting& c) { return cut_block(block_size, c); },
      [](const Cutting& c) { return cut_block(slab_size, c); },
      there_and_back(
          40, 120, [&](double x) { return tilted(block_at(0, 0, height(x), 0)); },
          [&](double x) {
            return tilted(block_at(0.01 * std::sin(two_pi / 2 * x), 0.02 * x, -pressed, 0.2 * x));
          },
          [&](double x) { return tilted(block_at(0, 0.02, height(x), 0.2)); })};
}

double pressed_into_slab(const Pose& X) { return (slab_height + block_height) / 2 - X.p.z(); }

ConformingScene cylinder_in_hole() {
  constexpr double pressed = 6e-4;
  const Vec3 into = -hole_normal();
  return {"cylinder in hole", [](const Cutting& c) { return cut_rod(rod_radius, 0.05, sides, c); },
          [](const Cutting& c) { return cut_bored_block(0.025, 0.03, hole_radius, sides, c); },
          there_and_back(
              40, 120,
              [&](double x) {
                return turned_about({0, 0, 0}, pressed * x * into);
              },
              [&](double x) {
                const Vec3 along(0, 0, 0.005 * std::sin(two_pi * x));
                const double turn = x < 0.5 ? 0 : 0.07 * swell(2 * x - 1);
                return turned_about({0, 0, turn}, pressed * into + along);
              },
              [&](double x) {
                return turned_about({0, 0, 0}, pressed * x * into);
              })};
}

double pressed_into_hole(const Pose& X) {
  const double room = (hole_radius - rod_radius) * std::cos(std::numbers::pi / sides);
  return -hole_normal().dot(X.p) - room;
}

Vec3 hole_normal() {
  const double a = std::numbers::pi / sides;
  return {-std::cos(a), -std::sin(a), 0};
}

ConformingScene wedge_in_notch() {
  constexpr double clear = 1.03e-3, pressed = 2e-3;
  const auto at = [](double x, double y, double z) {
    return Pose{Quat::Identity(), Vec3(x, y, z)};
  };
  const auto height = [](double x) { return clear - (clear + pressed) * x; };
  return {"wedge in notch", cut_wedge, cut_notched_block,
          there_and_back(
              40, 120, [&](double x) { return at(0, 0, height(x)); },
              [&](double x) {
                return at(0.0015 * std::sin(two_pi * x), 0.008 * std::sin(two_pi * x), -pressed);
              },
              [&](double x) { return at(0, 0, height(x)); })};
}

ConformingScene peg_in_hole(double clearance, const PegPath& path) {
  const double above = 0.003, below = path.lowest - socket_depth;
  const int ticks = int(std::lround((above - below) / path.step));
  const double shift = path.shift, tilt = path.tilt;
  // The shares of `shift` and `tilt` wander by the depth of insertion, differently in and out.
  const auto at = [=](double x, double phase) {
    const double z = above + (below - above) * x, a = two_pi * 3 * x + phase;
    const Vec3 aside(0.7 * std::sin(a), 0.7 * std::cos(1.3 * a), 0);
    const Vec3 askew(0.6 * std::cos(0.9 * a), 0.6 * std::sin(1.1 * a), 0.5 * std::sin(0.7 * a));
    const double off = path.guided > 0 ? std::clamp(-z / path.guided - 1, 0.0, 1.0) : 1;
    const double share = off * off * (3 - 2 * off);
    return turned_about(share * tilt * askew, share * shift * aside + Vec3(0, 0, z));
  };
  return {"peg in hole", cut_peg,
          [clearance](const Cutting& c) { return cut_socket(clearance, c); },
          there_and_back(
              ticks, std::max(40, int(2e-3 / path.step)), [&](double x) { return at(x, 0); },
              [&](double x) { return at(1, x); }, [&](double x) { return at(x, 1); })};
}

Pose peg_on_axis(const Pose& X) {
  return {Quat::Identity(), Vec3(0, 0, std::max(X.p.z(), 1e-9 - socket_depth))};
}

double object_distance(const MassProperties& mass, const Pose& O, const Pose& Q) {
  const Vec3 v = mass.R_MP.transpose() * (O.q.conjugate() * Q.q).vec();
  const Vec3 t = Q * mass.com - O * mass.com;
  return std::sqrt(t.squaredNorm() + 4 * v.dot(mass.inertia.cwiseProduct(v)));
}

std::vector<Pose> block_loop(int ticks) {
  return sampled(ticks, [](double x) {
    const double a = two_pi * x;
    const Vec3 tilt(0.01 * std::sin(2 * a), 0.007 * std::sin(3 * a), 0.1 * std::sin(a));
    return block_at(0.004 * std::sin(a), 0.003 * std::sin(2 * a), 1e-3 - 4e-3 * swell(x), 0) *
           turned_about(tilt, Vec3::Zero());
  });
}

std::vector<Pose> cylinder_loop(int ticks) {
  return sampled(ticks, [](double x) {
    const double a = two_pi * x;
    const Vec3 aside = 6e-4 * swell(x) * Vec3(std::cos(0.3 * std::sin(a)), 0.5 * std::sin(a), 0);
    return turned_about({0.004 * std::sin(2 * a), 0.003 * std::sin(a), 0.05 * std::sin(a)},
                        aside + Vec3(0, 0, 0.002 * std::sin(a)));
  });
}

std::vector<Pose> wedge_loop(int ticks) {
  return sampled(ticks, [](double x) {
    const double a = two_pi * x;
    return turned_about({0.004 * std::sin(a), 0.004 * std::sin(2 * a), 0.006 * std::sin(3 * a)},
                        {0.0015 * std::sin(a), 0.002 * std::sin(a), 1e-3 - 3e-3 * swell(x)});
  });
}

}  // namespace sonde::test
