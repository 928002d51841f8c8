// SPDX-License-Identifier: GPL-3.0-or-later
// The coherent solver where it is hard on it: a probe with an inertia of zero, bodies so far from
// the origin that rounding is larger than the clearance otherwise kept, and walls thinner than a
// stride.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

PolygonSoup shifted(PolygonSoup soup, const Vec3& by) {
  for (Vec3& x : soup.points) x += by;
  return soup;
}

// Reference: exact predicates. Turning about the needle's axis costs nothing, but it moves the
// needle's points by more than the clearance that is kept where the contact is shallow.
TEST(CoherentExtremes, a_needle_that_spins_freely_is_handed_out_free) {
  const auto needle =
      test::body({{{-0.5, 0, 0}, {0.5, 0, 0}, {0, 6e-8, 0}}, {{0, 1, 2}}}, Model::surface);
  ASSERT_EQ(needle->mass.inertia[0], 0);
  const auto block = test::body(test::box({2, 2, 2}));
  const Quat upright(Eigen::AngleAxisd(std::numbers::pi / 2, -Vec3::UnitY()));
  const auto device = [&](int i) {
    const double x = 1.0001 - 1e-4 * (1 - std::cos(2 * std::numbers::pi * i / 2000.0));
    return Pose{upright * Quat(Eigen::AngleAxisd(0.1 * i, Vec3::UnitX())), Vec3(x, 0.1, 0.1)};
  };
  CoherentSolver solver({needle, block});
  ASSERT_EQ(solver.reset(device(0)).status, Status::separated);
  int in_contact = 0;
  for (int i = 1; i <= 2000; ++i) {
    const Separation& s = solver.tick(device(i));
    ASSERT_NE(s.status, Status::failed);
    in_contact += s.status == Status::penetrating;
    ASSERT_FALSE(overlap(*needle, *block, Transform(s.separated), Doubt::exact)) << i;
  }
  EXPECT_GT(in_contact, 500);
  EXPECT_EQ(solver.last().status, Status::separated);
}

// By hand: the path ends where it began, a probe's width clear of the face.
TEST(CoherentExtremes, far_from_the_origin_the_probe_still_comes_free) {
  for (const double away : {0.0, 1e5, 4e6, 1e7}) {
    const Vec3 origin(away, 0, 0);
    const auto block = test::body(shifted(test::box({2, 2, 2}), origin));
    const auto probe = test::body(test::box({0.1, 0.1, 0.1}));
    const auto device = [&](int i) {
      const double phase = 2 * std::numbers::pi * i / 300.0;
      return Pose{Quat(Eigen::AngleAxisd(0.3 * std::sin(phase), Vec3::UnitZ())),
                  origin + Vec3(1.2 - 0.15 * (1 - std::cos(phase)), 0.2 * std::sin(phase), 0.1)};
    };
    CoherentSolver solver({probe, block});
    ASSERT_EQ(solver.reset(device(0)).status, Status::separated) << away;
    int in_contact = 0;
    for (int i = 1; i <= 300; ++i) {
      const Separation& s = solver.tick(device(i));
      in_contact += s.status == Status::penetrating;
      ASSERT_FALSE(overlap(*probe, *block, Transform(s.separated), Doubt::exact))
          << away << " " << i;
    }
    EXPECT_GT(in_contact, 100) << away;
    EXPECT_EQ(solver.last().status, Status::separated) << away;
  }
}

// Reference: exact predicates. Next to a half turn from the probe the device's coordinates lose its
// turn to rounding, 1e-8 rad, which is more than a shallow contact leaves.
TEST(CoherentExtremes, a_device_half_a_turn_away_leaves_the_probe_free) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto probe = test::body(test::box({0.5, 0.3, 0.2})),
             block = test::body(test::box({2, 2, 2}));
  int kept = 0;
  for (const double short_of : {0.0, 1e-9, 1e-7, 1e-5, 1e-3})
    for (int i = 0; i < 10; ++i) {
      CoherentSolver solver({probe, block});
      const Pose device{Quat::Identity(), Vec3(0.1, 0.1, 1.1 - 1e-10)};
      ASSERT_EQ(solver.reset(device).status, Status::penetrating);
      const Pose from = solver.last().separated;
      const Vec3 axis = Vec3(any(random), any(random), any(random)).normalized();
      const Quat turn(Eigen::AngleAxisd(std::numbers::pi - short_of, axis));
      for (const Vec3& by : {Vec3(0, 0, 0), Vec3(1e-4, 0, -1e-3)}) {
        const Separation& s = solver.tick({(turn * from.q).normalized(), from.p + by});
        ASSERT_FALSE(overlap(*probe, *block, Transform(s.separated), Doubt::exact))
            << short_of << " " << axis.transpose();
        kept += s.status == Status::penetrating && s.limited > 0 && !s.converged;
      }
    }
  EXPECT_GT(kept, 0);
}

// Walls a hundredth as thick as the probe, and with no thickness at all, wide enough that there is
// no way round; 5 m/s at 1 kHz is 5 mm a tick. By hand: the probe's centre stays above the wall.
void press_through(const Body& probe_body, std::shared_ptr<const Body> probe,
                   const std::shared_ptr<const Body>& wall, double speed, bool turning) {
  CoherentSolver solver({std::move(probe), wall});
  Pose device{Quat(Eigen::AngleAxisd(0.3, Vec3(1, 1, 0).normalized())), Vec3(0.01, 0.02, 0.12)};
  const Quat turn = rotation_by({0.02, -0.03, 0.05});
  ASSERT_EQ(solver.reset(device).status, Status::separated);
  for (int tick = 0; tick * speed < 400; ++tick) {
    device.p.z() -= 1e-3 * speed;
    if (turning) device.q = (turn * device.q).normalized();
    const Separation& s = solver.tick(device);
    ASSERT_NE(s.status, Status::failed) << s.reason;
    EXPECT_GT((s.separated * probe_body.mass.com).z(), 0.0) << "tick " << tick;
  }
  EXPECT_EQ(solver.last().status, Status::penetrating);
  EXPECT_GT(solver.last().depth, 0.25);
}

TEST(CoherentExtremes, nothing_pops_through_a_thin_wall) {
  std::mt19937_64 random(4);
  const auto plate = test::body(test::box({4, 4, 0.001}));
  const auto sheet = test::body({{{-4, -4, 0}, {4, -4, 0}, {0, 6, 0}}, {{0, 1, 2}}});
  const std::vector<std::shared_ptr<const Body>> probes = {
      test::body(test::box({0.1, 0.1, 0.1})), test::body(test::torus(0.035, 0.015, 12, 8)),
      test::body(test::random_soup(random, 15, 0.07))};
  for (const auto& wall : {plate, sheet})
    for (const auto& probe : probes)
      for (const double speed : {0.5, 5.0, 80.0})
        for (const bool turning : {false, true}) press_through(*probe, probe, wall, speed, turning);
}

}  // namespace
}  // namespace sonde
