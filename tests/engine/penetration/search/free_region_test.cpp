// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/free_region.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

Vec3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> along(-size, size);
  const double x = along(random), y = along(random);
  return {x, y, along(random)};
}

// Reference: the exact test. Small and large moves are tried.
TEST(FreeRegion, what_is_covered_is_free) {
  std::mt19937_64 random(7);
  int covered = 0, refused = 0, overlapping = 0;
  for (const test::BodyPair& pair : test::body_pairs(3)) {
    const double radius = pair.a->mass.radius;
    FreeRegion far(*pair.a, *pair.b);
    for (int i = 0; i < 400; ++i) {
      Pose X;
      X.q = rotation_by(random_vector(random, 3));
      // The centres of mass are near each other wherever the meshes lie.
      X.p = pair.b->mass.com - X.q * pair.a->mass.com + random_vector(random, 4 * radius);
      if (overlap(*pair.a, *pair.b, Transform(X), Doubt::contact)) continue;
      Effort effort;
      far.forget();
      far.look(X, 0.02 * radius, effort);
      for (int k = 1; k <= 8; ++k) {
        const double size = k / 8.0;
        Pose to;
        to.q = (rotation_by(random_vector(random, 0.15 * size)) * X.q).normalized();
        to.p = X * pair.a->mass.com + random_vector(random, 0.3 * size * radius) -
               to.q * pair.a->mass.com;
        const bool overlaps = overlap(*pair.a, *pair.b, Transform(to), Doubt::contact);
        overlapping += overlaps;
        if (far.covers(to)) {
          ++covered;
          ASSERT_FALSE(overlaps) << pair.name << " " << i;
        } else {
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(covered, 100);
  EXPECT_GT(refused, 100);
  EXPECT_GT(overlapping, 20);
}

TEST(FreeRegion, nothing_is_covered_before_a_look_and_after_it_is_forgotten) {
  const auto cube = test::body(test::box({1, 1, 1}));
  Pose away;
  away.p.x() = 5;
  FreeRegion far(*cube, *cube);
  EXPECT_FALSE(far.covers(away));
  Effort effort;
  far.look(away, 0.001, effort);
  EXPECT_TRUE(far.covers(away));
  far.forget();
  EXPECT_FALSE(far.covers(away));
}

// Reference: the exact test at each device pose. In the free flight of a path that dips into a
// ring, all that is said is that the probe is where the device is, wherever that is free.
TEST(FreeRegion, a_tick_is_free_exactly_where_the_device_is) {
  const auto probe = test::body(test::box({0.05, 0.04, 0.03}));
  const auto ring = test::body(test::torus(0.2, 0.05, 40, 20));
  const auto device = [](int i) {
    const double phase = 0.004 * i;
    return Pose{rotation_by({0.3 * phase, phase, 0}),
                Vec3(0.2, 0, 0.35 - 0.29 * (1 - std::cos(phase)) / 2)};
  };
  for (const Method method : {Method::pdg, Method::pdt}) {
    CoherentSolver solver({probe, ring}, method);
    ASSERT_EQ(solver.reset(device(0)).status, Status::separated);
    int in_contact = 0, at_once = 0;
    for (int i = 1; i <= 1600; ++i) {
      const Separation& s = solver.tick(device(i));
      const bool free = !overlap(*probe, *ring, Transform(device(i)), Doubt::contact);
      in_contact += s.status == Status::penetrating;
      ASSERT_NE(s.status, Status::failed);
      if (!free) {
        ASSERT_EQ(s.status, Status::penetrating) << i;
      } else if (s.status == Status::separated) {
        ++at_once;
        ASSERT_EQ(s.separated.p, device(i).p) << i;
      }
      ASSERT_FALSE(overlap(*probe, *ring, Transform(s.separated), Doubt::exact)) << i;
    }
    EXPECT_GT(in_contact, 50);
    EXPECT_GT(at_once, 500);
  }
}

}  // namespace
}  // namespace sonde
