// SPDX-License-Identifier: GPL-3.0-or-later
// References: a box pressed flat on a wall, whose stiffness is known by hand; turned frames.
#include "engine/penetration/sensitivity/principal_stiffness.hpp"

#include <gtest/gtest.h>

#include "engine/penetration/descent/result.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(PrincipalStiffness, of_a_box_pressed_flat_is_k_across_the_wall_and_its_inertia_in_turns) {
  const Vec3 size(0.06, 0.04, 0.02);
  const Pair pair(test::body(test::box(size)), test::body(test::box({1, 1, 0.2})));
  const Chart chart(pair.probe().mass, {Quat::Identity(), {0.013, 0.021, 0.11 - 1e-3}});
  Descent descent(pair.probe(), pair.fixed(), Method::pdg);
  const Vec6 free = chart.coordinates({Quat::Identity(), {0.013, 0.021, 0.11 + 1e-6}});
  const Separation s = make_separation(chart, descent.run(chart, free, {}, 0, Deadline{}));
  const double k = 480;
  const auto got = principal_stiffnesses(wrench_derivative(pair, s), k);
  EXPECT_NEAR(got.translation[0].value, k, 1e-6 * k);
  EXPECT_NEAR(std::abs(got.translation[0].direction.z()), 1, 1e-9);
  EXPECT_NEAR(got.translation[1].value, 0, 1e-6 * k);
  EXPECT_NEAR(got.translation[2].value, 0, 1e-6 * k);
  const double about_y = k * (0.06 * 0.06 + 0.02 * 0.02) / 12;
  const double about_x = k * (0.04 * 0.04 + 0.02 * 0.02) / 12;
  EXPECT_NEAR(got.rotation[0].value, about_y, 1e-6 * about_y);
  EXPECT_NEAR(std::abs(got.rotation[0].direction.y()), 1, 1e-6);
  EXPECT_NEAR(got.rotation[1].value, about_x, 1e-6 * about_x);
  EXPECT_NEAR(std::abs(got.rotation[1].direction.x()), 1, 1e-6);
  EXPECT_NEAR(got.rotation[2].value, 0, 1e-6 * about_x);
}

TEST(PrincipalStiffness, turns_with_the_frame_and_leaves_out_what_couples_both) {
  std::mt19937_64 random(4);
  const Quat q = test::random_rotation(random);
  const Vec3 stiff(3, 20, 100), turns(0.1, 0.7, 0.2);
  const Mat3 R = q.toRotationMatrix();
  WrenchDerivative d;
  d.d_wrench.topLeftCorner<3, 3>() = -R * stiff.asDiagonal() * R.transpose();
  d.d_wrench.bottomRightCorner<3, 3>() = -R * turns.asDiagonal() * R.transpose();
  d.d_wrench.topRightCorner<3, 3>().setConstant(5);
  const auto got = principal_stiffnesses(d, 2);
  for (int i = 0; i < 3; ++i) {
    const auto& along = got.translation[static_cast<std::size_t>(2 - i)];
    EXPECT_NEAR(along.value, 2 * stiff[i], 1e-12 * 200);
    EXPECT_NEAR(std::abs(along.direction.dot(R.col(i))), 1, 1e-12);
  }
  EXPECT_NEAR(got.rotation[0].value, 1.4, 1e-12);
  EXPECT_NEAR(std::abs(got.rotation[0].direction.dot(R.col(1))), 1, 1e-12);
}

}  // namespace
}  // namespace sonde
