// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that fit with far less room than the distance to which pushes separate triangles at first.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace sonde
