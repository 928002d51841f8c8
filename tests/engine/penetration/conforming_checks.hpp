// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of what the hand feels where faces lie on each other. Each check reports the worst
// tick of a path, not all of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/conforming_scene.hpp"

namespace sonde::test {

/// Beside forces of nothing: what the promised clearance and rounding leave, N.
constexpr double least_force = 1e-5;

/// The largest of many values, and where it was.
struct Worst {
  double value = 0;
  std::size_t tick = 0;
  void see(double x, std::size_t i) {
    if (!(x <= value)) value = x, tick = i;  // not a number is the worst of all
  }
};

inline double largest_force(const std::vector<Felt>& felt) {
  double out = 0;
  for (const Felt& f : felt) out = std::max(out, f.force.norm());
  return out;
}

/// No tick failed, at most the given share stopped short of an answer, and none jumped, but for so
/// many that the geometry forces.
inline void expect_followed(const std::vector<Felt>& felt, double not_converged,
                            const std::string& what, std::size_t forced_jumps = 0) {
  std::size_t contacts = 0, open = 0, failed = 0, jumps = 0, first = 0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    failed += felt[i].status == Status::failed;
    jumps += felt[i].jumped;
    contacts += felt[i].status == Status::penetrating;
    if (felt[i].status != Status::penetrating || felt[i].converged) continue;
    if (open++ == 0) first = i;
  }
  EXPECT_EQ(failed, 0u) << what;
  EXPECT_LE(jumps, forced_jumps) << what << ": jumps";
  EXPECT_GT(contacts, felt.size() / 4) << what << ": or nothing was tested";
  EXPECT_LE(double(open), not_converged * double(contacts))
      << what << ": ticks in contact that have not converged, the first at tick " << first;
}

/// Free at both ends, where the hand feels nothing at all.
inline void expect_free_at_the_ends(const std::vector<Felt>& felt, const std::string& what) {
  for (const Felt& f : {felt.front(), felt.back()}) {
    EXPECT_EQ(f.status, Status::separated) << what;
    EXPECT_EQ(f.force, Vec3(Vec3::Zero())) << what;
    EXPECT_EQ(f.torque, Vec3(Vec3::Zero())) << what;
    EXPECT_EQ(f.depth, 0) << what;
  }
}

/// Force and torque as in `want`, to the given share of the force and of force × arm.
inline void expect_felt_as(const std::vector<Felt>& got, const std::vector<Felt>& want, double arm,
                           double share, const std::string& what) {
  ASSERT_EQ(got.size(), want.size()) << what;
  Worst force, torque;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double scale = want[i].force.norm() + least_force / share;
    force.see((got[i].force - want[i].force).norm() / scale, i);
    torque.see((got[i].torque - want[i].torque).norm() / (want[i].torque.norm() + arm * scale), i);
  }
  EXPECT_LE(force.value, share) << what << ": force, worst at tick " << force.tick;
  EXPECT_LE(torque.value, share) << what << ": torque, worst at tick " << torque.tick;
}

/// The part of the force across the normal, of the part along it; and that along it never pulls.
inline void expect_no_friction_and_no_glue(const std::vector<Felt>& felt, const Vec3& normal,
                                           const std::string& what) {
  Worst across, pull;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const double along = felt[i].force.dot(normal);
    pull.see(-along, i);
    across.see((felt[i].force - along * normal).norm() / (std::max(along, 0.0) + 100 * least_force),
               i);
  }
  EXPECT_LE(across.value, 0.01) << what << ": tangential/normal, worst at tick " << across.tick;
  EXPECT_EQ(pull.value, 0) << what << ": N, pulls hardest at tick " << pull.tick;
}

}  // namespace sonde::test
