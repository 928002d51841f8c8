// SPDX-License-Identifier: GPL-3.0-or-later
// Each claim about PD_g on bodies and paths of which plain geometry says how it must come out: for
// it, against it, and neither.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/settings/device_profile.hpp"
#include "engine/study/comparison/claims.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

constexpr double half_rod = 0.05, rod_height = 0.001;  // m, of its length and of its thickness
constexpr double step = 1e-3;                          // s

PolygonSoup moved(PolygonSoup soup, const Vec3& by) {
  for (Vec3& x : soup.points) x += by;
  return soup;
}

/// Whose lower side is below z = 0 by its thickness, and along x.
PolygonSoup rod() { return test::box({2 * half_rod, 0.004, 2 * rod_height}); }

/// An edge along y, at this x and z = 0, of a wedge that stands on the ground.
PolygonSoup ridge(double x, double half_width) {
  PolygonSoup out;
  for (const double y : {-0.05, 0.05})
    for (const Vec3& corner :
         {Vec3(x, y, 0), Vec3(x - half_width, y, -0.06), Vec3(x + half_width, y, -0.06)})
      out.points.push_back(corner);
  out.polygons = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {0, 2, 5, 3}, {1, 4, 5, 2}};
  return out;
}

/// A sheet of 2 mm with its upper side at z = 0, that reaches 5 mm below the rod's left end.
PolygonSoup ledge() { return moved(test::box({0.1, 0.1, 0.002}), {-0.095, 0, -0.001}); }

/// Where the device is, and how far the rod's left end is turned down.
struct Stop {
  double x, z, down;
};

/// Straight from each to the next, in so many ticks each.
std::vector<TimedPose> path_through(const std::vector<Stop>& stops, int ticks) {
  std::vector<TimedPose> out;
  const auto add = [&](const Stop& at) {
    out.push_back({step * double(out.size()),
                   {Quat(Eigen::AngleAxisd(-at.down, Vec3::UnitY())), Vec3(at.x, 0, at.z)}});
  };
  for (std::size_t leg = 1; leg < stops.size(); ++leg)
    for (int i = 0; i < ticks; ++i) {
      const Stop &a = stops[leg - 1], &b = stops[leg];
      const double s = double(i) / ticks;
      add({a.x + s * (b.x - a.x), a.z + s * (b.z - a.z), a.down + s * (b.down - a.down)});
    }
  add(stops.back());
  return out;
}

std::vector<Stop> repeated(const std::vector<Stop>& round, int times) {
  std::vector<Stop> out;
  for (int i = 0; i < times; ++i) out.insert(out.end(), round.begin(), round.end());
  out.push_back(round.front());
  return out;
}

CompareSetup setup_of(const PolygonSoup& probe, const PolygonSoup& fixed,
                      std::vector<TimedPose> path, const char* device = nullptr) {
  CompareSetup out{.render = {.pair = {test::body(probe), test::body(fixed)}}};
  out.render.coupling.k = 500;
  out.path = std::move(path);
  if (device)
    out.device =
        simulated(read_device_profile(std::string(SONDE_RESOURCES "/devices/") + device + ".json"));
  return out;
}

Comparison compared(const CompareSetup& setup) {
  const Study study = compare_study(setup);
  StudyFolder folder{study.kind, study.about, {}, {}};
  for (const StudyPart& part : study.parts) {
    folder.names.push_back(part.name);
    folder.results.push_back(part.compute(never));
  }
  return comparison_of("here", folder);
}

TestedClaim claim_named(const std::string& key, const Comparison& comparison) {
  for (const TestedClaim& claim : tested_claims(comparison))
    if (claim.key == key) return claim;
  ADD_FAILURE() << key;
  return {};
}

TestedClaim claim_named(const std::string& key, const CompareSetup& setup) {
  return claim_named(key, compared(setup));
}

// The sheet bears the rod by its last 5 mm of 50. A rod that may turn slips off once it is turned
// by acos(45/50) = 0.45, and so does it on the way back, from below; one that may not stays.
TEST(ClaimsOnScenes, a_rod_that_turns_off_a_ledge_pops_through) {
  const auto path = path_through(repeated({{0, 0.036, 0}, {0, -0.036, 0}}, 3), 720);
  const TestedClaim claim = claim_named("fewer_pop_throughs", setup_of(rod(), ledge(), path));
  EXPECT_EQ(claim.finding, Finding::refuted);
  EXPECT_EQ(claim.for_it, 0);
  EXPECT_EQ(claim.against_it, 6) << "once down and once up in each of three rounds";
}

// The device itself turns by more than acos(45/50), its left end lowered. So the rod that may not
// turn against it slips off; the other is turned back by the sheet, to 0.3, and stays. Above the
// sheet, the same the other way.
TEST(ClaimsOnScenes, a_rod_that_cannot_turn_back_pops_through) {
  const std::vector<Stop> round{{0, 0.035, 0.3}, {0, 0.012, 0.3}, {0, 0.012, 0.55},
                                {0, 0.012, 0.3}, {0, 0.035, 0.3}, {0, 0.035, 0.55}};
  const auto path = path_through(repeated(round, 4), 250);
  const TestedClaim claim = claim_named("fewer_pop_throughs", setup_of(rod(), ledge(), path));
  EXPECT_EQ(claim.finding, Finding::supported);
  EXPECT_EQ(claim.for_it, 8);
  EXPECT_EQ(claim.against_it, 0);
}

/// Of a rod that is pressed with `depth` on an edge `aside` of its middle, by least squares of how
/// it may give way: U/k as a function of where the edge is from the rod's middle, m².
double energy_of_model(double aside, double depth) {
  const double inertia = (half_rod * half_rod + rod_height * rod_height) / 3;
  const auto at = [&](double turn) {
    const double way = depth * std::cos(turn) - aside * std::sin(turn) + rod_height;
    const double chord = 2 * std::sin(turn / 2);
    return (way * way + inertia * chord * chord) / 2;
  };
  double low = 0, high = 1.4;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3;
    (at(low + third) < at(high - third) ? high : low) +=
        at(low + third) < at(high - third) ? -third : third;
  }
  return at(low);
}

/// The force of PD_g over that of PD_t, each at the stiffness that the contact bears on a device
/// that has no motors for torque: there the stiffest direction of the force against displacement
/// alone decides, which is k for PD_t, and the force k times the depth.
double force_ratio_of_model(double aside, double depth) {
  constexpr double h = 1e-5;
  const auto u = [&](int i, int j) { return energy_of_model(aside + i * h, depth + j * h); };
  const double fx = (u(1, 0) - u(-1, 0)) / (2 * h), fz = (u(0, 1) - u(0, -1)) / (2 * h);
  const double xx = (u(1, 0) - 2 * u(0, 0) + u(-1, 0)) / (h * h);
  const double zz = (u(0, 1) - 2 * u(0, 0) + u(0, -1)) / (h * h);
  const double xz = (u(1, 1) - u(1, -1) - u(-1, 1) + u(-1, -1)) / (4 * h * h);
  const double stiffest = (xx + zz) / 2 + std::hypot((xx - zz) / 2, xz);
  return std::hypot(fx, fz) / stiffest / (depth + rod_height);
}

Comparison rod_on_ridge(double aside, const char* device, double depth) {
  const auto path = path_through({{0, 0.002, 0}, {0, -depth, 0}}, 1500);
  return compared(setup_of(rod(), ridge(aside, 0.001), path, device));
}

// Near the middle of a rod, the further it has turned, the more easily it turns: its force grows
// less and less, and the contact bears a stiffer spring. By the model 3 to 6 % more force.
TEST(ClaimsOnScenes, a_rod_that_softens_is_more_stable_where_torque_has_no_motors) {
  const Comparison c = rod_on_ridge(0.01, "touch", 0.032);
  const TestedClaim claim = claim_named("more_stable", c);
  EXPECT_EQ(claim.finding, Finding::supported);
  EXPECT_EQ(claim.against_it, 0);
  ASSERT_EQ(c.of_pdt.stiffness.limits.size(), c.of_pdg.stiffness.limits.size());
  ASSERT_GT(c.of_pdg.stiffness.limits.size(), 30u);
  double largest = 0;
  for (std::size_t i = 0; i < c.of_pdg.stiffness.limits.size(); ++i) {
    const auto &pdt = c.of_pdt.stiffness.limits[i], &pdg = c.of_pdg.stiffness.limits[i];
    ASSERT_EQ(pdt.tick, pdg.tick);
    const double depth = 0.034 * double(pdt.tick) / 1500 - 0.002;
    const double model = force_ratio_of_model(0.01, depth);
    EXPECT_NEAR(pdg.force / pdt.force / model, 1, 0.01) << depth;
    largest = std::max(largest, model);
  }
  EXPECT_GT(largest, 1.03);
}

// With motors for torque, the handle's small inertia decides: m (1/m + lever²/I) of PD_t's k at
// three fifths of the rod's half, and the force is less by that.
TEST(ClaimsOnScenes, a_light_handle_that_is_turned_makes_it_less_stable) {
  const Comparison c = rod_on_ridge(0.03, "sigma.7", 0.01);
  const TestedClaim claim = claim_named("more_stable", c);
  EXPECT_EQ(claim.finding, Finding::refuted);
  EXPECT_EQ(claim.for_it, 0);
}

// Over the middle nothing turns, and both are one spring.
TEST(ClaimsOnScenes, what_does_not_turn_is_as_stable) {
  const auto path = path_through({{0, 0.002, 0}, {0, -0.02, 0}}, 1000);
  const CompareSetup setup = setup_of(
      test::sphere(0.03, 24, 48), moved(test::box({0.3, 0.3, 0.1}), {0, 0, -0.079}), path, "touch");
  const TestedClaim claim = claim_named("more_stable", setup);
  EXPECT_EQ(claim.finding, Finding::undecided);
  EXPECT_EQ(claim.for_it + claim.against_it, 0);
  EXPECT_GT(claim.alike, 20);
}

PolygonSoup ground() { return moved(test::box({1, 1, 1}), {0, 0, -0.5}); }
PolygonSoup brick() { return test::box({0.06, 0.04, 0.02}); }

// Pressed askew on the ground, a brick turns, and its torque is of that turn; one that may not turn
// has the torque of the force at its corner.
TEST(ClaimsOnScenes, an_askew_brick_has_its_torque_by_turning) {
  const auto path = path_through({{0, 0.03, 0.3}, {0, 0.005, 0.3}, {0.02, 0.005, 0.2}}, 500);
  EXPECT_EQ(claim_named("better_torque", setup_of(brick(), ground(), path)).finding,
            Finding::supported);
}

// Pressed flat it has none, whether it may turn or not.
TEST(ClaimsOnScenes, a_flat_brick_has_no_torque_either_way) {
  const auto path = path_through({{0, 0.02, 0}, {0, 0.002, 0}, {0.02, 0.002, 0}}, 500);
  const TestedClaim claim = claim_named("better_torque", setup_of(brick(), ground(), path));
  EXPECT_EQ(claim.finding, Finding::undecided);
  EXPECT_GT(claim.alike, 10);
}

// A flat brick that spins at 20 rad/s about the normal, with one step of work in a tick: PD_g is
// late by a turn, which is a torque that the ground does not give; PD_t turns with the device (but
// before it has caught up, at the first contact).
TEST(ClaimsOnScenes, a_solver_that_lags_has_the_worse_torque) {
  std::vector<TimedPose> path;
  for (int i = 0; i <= 2000; ++i)
    path.push_back({step * i,
                    {Quat(Eigen::AngleAxisd(0.02 * i, Vec3::UnitZ())),
                     Vec3(1e-5 * i, 0, 0.02 - 0.018 * std::min(1.0, i / 300.0))}});
  CompareSetup setup = setup_of(brick(), ground(), path);
  setup.render.budget.steps = 1;
  const TestedClaim claim = claim_named("better_torque", setup);
  EXPECT_EQ(claim.finding, Finding::refuted);
  EXPECT_LE(claim.for_it, 1);
  EXPECT_GT(claim.against_it, 15);
}

// A ball of facets rolled over a slab that is no box: what torque there is, is of its facets, with
// either method, and says nothing about them. Each facet spans 7.5° by 7.5°: half its diagonal is
// the most that a normal is off the radius.
TEST(ClaimsOnScenes, the_facets_of_a_ball_decide_nothing) {
  PolygonSoup slab = moved(test::box({0.4, 0.4, 0.1}), {0, 0, -0.05});
  for (Vec3& x : slab.points)
    if (x.x() > 0 && x.z() < -0.05) x.x() = 0.3;
  std::vector<TimedPose> path;
  for (int i = 0; i <= 6000; ++i)
    path.push_back({step * i,
                    {Quat(Eigen::AngleAxisd(1e-3 * i, Vec3(0.3, 1, 0.1).normalized())),
                     Vec3(1e-5 * i, 0, 0.033 - 0.009 * std::min(1.0, i / 500.0))}});
  const Comparison c = compared(setup_of(test::sphere(0.03, 24, 48), slab, path));
  ASSERT_EQ(c.of_pdg.realism.kind, AnalyticKind::ball);
  EXPECT_NEAR(c.of_pdg.realism.facets, std::sin(std::sqrt(2.0) * 3.75 * std::numbers::pi / 180),
              2e-3);
  const TestedClaim claim = claim_named("better_torque", c);
  EXPECT_EQ(claim.finding, Finding::undecided);
  EXPECT_EQ(claim.for_it + claim.against_it, 0);
  EXPECT_GT(claim.alike, 100);
}

}  // namespace
}  // namespace sonde
