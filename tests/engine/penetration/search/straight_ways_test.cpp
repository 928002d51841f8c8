// SPDX-License-Identifier: GPL-3.0-or-later
// A row is a half-space, and a pair of triangles forbids less than that: ways past an edge or
// through a hole that no pair obstructs are taken.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "engine/penetration/search/coherent.hpp"
#include "engine/sonde.hpp"
#include "tests/engine/penetration/ways_down.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Three triangles of a link on two of another, met at a corner that is 10⁻⁵ of their size from an
// edge: the face below that corner and the edge beside it separate the same pair, and the edge
// forbids less. Reference: random straight motions, free by exact predicates (ways_down.hpp).
TEST(StraightWays, a_corner_beside_an_edge_is_held_by_the_axis_that_forbids_less) {
  PolygonSoup of_probe;
  of_probe.points = {
      {-0.25432245, -0.1303184, -0.35700159},  {-0.2337083, -0.15274692, -0.37851192},
      {-0.1997736, -0.1248777, -0.37127554},   {-0.27060869, -0.10841859, -0.33158836},
      {-0.21798086, -0.10506792, -0.35227674}, {0.11047643, -0.16873239, -0.41041111},
      {0.13652005, -0.17034693, -0.38376906},  {0.16959269, -0.17912016, -0.41222699}};
  of_probe.polygons = {{0, 1, 2}, {3, 0, 4}, {5, 6, 7}};
  PolygonSoup of_fixed;
  of_fixed.points = {
      {-0.31638193, -0.29679241, 0.19302121}, {-0.32801499, -0.27814008, 0.2296353},
      {-0.27476112, -0.25816021, 0.23228381}, {-0.14330257, -0.090037332, 0.44361931},
      {-0.12638249, -0.05124752, 0.43788428}, {-0.13093513, -0.035904911, 0.49252916}};
  of_fixed.polygons = {{0, 1, 2}, {3, 4, 5}};
  MassProperties mass;
  mass.measure = 1;
  mass.inertia = {0.065680533, 0.146089936, 0.206935521};
  mass.R_MP << 0.172046249316, 0.873895504686, 0.454650123706, 0.357678052627, -0.485451416599,
      0.797748915882, 0.917859738067, 0.0253686620002, -0.396093337767;
  const auto probe = with_mass(*test::body(of_probe, Model::surface), mass);
  const auto fixed = test::body(of_fixed, Model::surface);
  const Pose stops[] = {
      // quaternions w, x, y, z
      {{0.3573378, 0.3531963, -0.1195518, -0.8563115}, {-0.4323719, -0.3441321, 0.6238825}},
      {{0.4203681, 0.3722989, -0.1202898, -0.8186664}, {-0.4549595, -0.3421771, 0.638933}},
      {{0.480979, 0.3892586, -0.1203354, -0.7763094}, {-0.477547, -0.3402221, 0.6539835}},
      {{0.5388216, 0.4039781, -0.1196884, -0.7294845}, {-0.5001346, -0.3382671, 0.669034}},
      {{0.5643115, 0.4032067, -0.1226992, -0.7098745}, {-0.5069082, -0.3451676, 0.6715876}},
      {{0.5715039, 0.3977516, -0.1262417, -0.7065692}, {-0.5061132, -0.3531142, 0.6689957}},
      {{0.6020546, 0.3738961, -0.1414116, -0.6911835}, {-0.5026694, -0.3875347, 0.657769}}};
  const int ticks[] = {60, 60, 60, 40, 20, 80};
  CoherentSolver solver({probe, fixed});
  ASSERT_EQ(solver.reset(stops[0]).status, Status::separated);
  std::mt19937_64 random(5);
  int looked_at = 0;
  for (std::size_t k = 0; k + 1 < std::size(stops); ++k)
    for (int i = 1; i <= ticks[k]; ++i) {
      const double t = static_cast<double>(i) / ticks[k];
      const Separation& now = solver.tick({stops[k].q.slerp(t, stops[k + 1].q).normalized(),
                                           (1 - t) * stops[k].p + t * stops[k + 1].p});
      if (i % 4 != 0 || now.status != Status::penetrating || !now.converged) continue;
      ++looked_at;
      EXPECT_EQ(test::steepest_way_down(*probe, *fixed, now, 200, random), 0) << k << ' ' << i;
    }
  EXPECT_GT(looked_at, 10);
}

struct RodInPlates {
  std::shared_ptr<const Body> rod, plates;
  std::vector<Pose> path;
};

/// A rod of ten sides on the axis of round holes of fourteen in three plates: it is within them by
/// the room, m, so every device pose is free, and so is the straight way from one to the next.
RodInPlates rod_in_plates(double room, double scale, int ticks) {
  std::mt19937_64 random(11);
  const Quat of_probe = test::random_rotation(random), of_fixed = test::random_rotation(random);
  const double inscribed = std::cos(std::numbers::pi / 14);
  const test::Section hole = test::regular_section(14, (0.01 + room) / inscribed);
  PolygonSoup rod = test::fitted_plug(test::regular_section(10, 0.01), 1, {}), plates;
  for (const double z : {0.0, 0.4, 0.9}) {
    PolygonSoup plate = test::fitted_socket(hole, 8, 0.015, {});
    for (Vec3& v : plate.points) v.z() += z;
    for (Polygon& polygon : plate.polygons)
      for (std::size_t& corner : polygon) corner += plates.points.size();
    plates.points.insert(plates.points.end(), plate.points.begin(), plate.points.end());
    plates.polygons.insert(plates.polygons.end(), plate.polygons.begin(), plate.polygons.end());
  }
  for (Vec3& v : rod.points) v = scale * (of_probe * v);
  for (Vec3& v : plates.points) v = scale * (of_fixed * v);
  RodInPlates out{test::body(rod), test::body(plates), {}};
  const Quat q = (of_fixed * of_probe.conjugate()).normalized();
  for (int i = 0; i <= ticks; ++i)
    out.path.push_back({q, scale * (of_fixed * Vec3(0, 0, -1.2 + 1.9 * i / ticks))});
  return out;
}

int free_ticks(const RodInPlates& scene, Method method) {
  CoherentSolver solver({scene.rod, scene.plates}, method);
  solver.reset(scene.path[0]);
  int out = 0;
  for (std::size_t i = 1; i < scene.path.size(); ++i)
    out += solver.tick(scene.path[i]).status == Status::separated;
  return out;
}

TEST(StraightWays, a_rod_on_the_axis_of_holes_goes_through_them) {
  for (const double room : {5e-6, 1e-5, 2e-5, 4e-5})
    for (const double scale : {0.1, 1.0, 10.0})
      for (const int ticks : {100, 1600})
        for (const Method method : {Method::pdg, Method::pdt})
          EXPECT_EQ(free_ticks(rod_in_plates(room, scale, ticks), method), ticks)
              << room << ' ' << scale << (method == Method::pdt ? " by translation" : "");
}

// The straight way may take half of a tick's work; the rest is for a step.
TEST(StraightWays, with_little_work_no_tick_says_that_it_is_there) {
  const RodInPlates scene = rod_in_plates(2e-5, 1, 400);
  for (const std::int64_t work : {2000, 10'000, 50'000, 200'000}) {
    CoherentSolver solver({scene.rod, scene.plates});
    solver.reset(scene.path[0]);
    int deep_and_converged = 0;
    for (std::size_t i = 1; i < scene.path.size(); ++i) {
      const Separation& now = solver.tick(scene.path[i], {.work = work});
      deep_and_converged += now.status == Status::penetrating && now.converged;
    }
    EXPECT_EQ(deep_and_converged, 0) << work;
    // A probe that falls behind at a mouth may come to rest beside it: an optimum, not the device.
    if (work < 50'000) continue;
    EXPECT_EQ(solver.last().status, Status::separated) << work;
  }
}

}  // namespace
}  // namespace sonde
