// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that fit with far less room than the distance to which pushes separate triangles at first.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: a flat wall that is passed by d, with the room c on either side: back by d − c. A turn
// is no help, since the walls are as long as the plug.
TEST(FineFits, a_plug_goes_back_into_its_socket_however_little_room_it_has) {
  for (const int sides : {4, 6, 10})
    for (const double part : {1e-3, 1e-4, 1e-5}) {
      const double radius = 0.012, c = part * radius, d = 12 * c;
      const test::Section section = test::regular_section(sides, radius);
      const Pair pair(test::body(test::fitted_plug(section, 0.02, {})),
                      test::body(test::fitted_socket(test::grown(section, c), 2, 0.02, {})));
      const Eigen::Vector2d across = (section[0] + section[1]).normalized();
      const Pose device{Quat::Identity(), d * Vec3(across.x(), across.y(), 0)};
      for (const Method method : {Method::pdg, Method::pdt}) {
        const Separation got = separate_static(pair, device, {.method = method});
        ASSERT_EQ(got.status, Status::penetrating) << sides << ' ' << part;
        EXPECT_NEAR(got.depth, d - c, 1e-3 * d) << sides << ' ' << part;
      }
    }
}

// Reference: the pose in the bore is free, so its distance is an upper bound of the depth; its play
// of some degrees may save a part of that. From 178 to 180 degrees this plug is answered 1.5 times
// as deep (measurements.md, "Fine fits").
TEST(FineFits, a_keyed_plug_turns_back_into_its_bore_from_nearly_half_a_turn) {
  const test::Section section = test::keyed_section(24, 0.01, 0.013, 0.002);
  const Pair pair(test::body(test::fitted_plug(section, 0.012, {})),
                  test::body(test::fitted_socket(test::grown(section, 3e-4), 2, 0.012, {})));
  for (const double degrees : {150.0, 165.0, 172.0}) {
    const double half = degrees * std::numbers::pi / 360;
    const Pose device{Quat(std::cos(half), 0, 0, std::sin(half)), Vec3::Zero()};
    const double back = Chart(pair.probe().mass, device).coordinates(Pose{}).norm();
    const Separation got = separate_static(pair, device);
    EXPECT_LE(got.depth, back) << degrees;
    EXPECT_GE(got.depth, 0.9 * back) << degrees;
  }
}

}  // namespace
}  // namespace sonde
