// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/drawn_session.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include "engine/base/threads.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui::test {
namespace {

LoadedScene free_probe(const std::shared_ptr<const Body>& probe) {
  LoadedScene out{.pair = Pair(probe, sonde::test::body(sonde::test::box({0.1, 0.1, 0.1})))};
  out.start.p = Vec3(0, 0, 0.5);
  out.coupling.k = 321;
  return out;
}

/// In one thread or in two: by the probe's size.
TEST(DrawnSession, a_session_and_its_picture_are_of_the_same_bodies_at_the_same_place) {
  const auto small = sonde::test::body(sonde::test::box({0.1, 0.1, 0.1}));
  const auto large = sonde::test::body(sonde::test::torus(0.05, 0.02, 200, 60));
  ASSERT_LT(small->soup.triangles.size(), worth_a_thread);
  ASSERT_GE(large->soup.triangles.size(), worth_a_thread);
  for (const auto& probe : {small, large}) {
    const DrawnSession drawn = draw_session(free_probe(probe));
    ASSERT_TRUE(drawn.session);
    ASSERT_TRUE(drawn.bodies.pair);
    EXPECT_EQ(&drawn.session->probe(), probe.get());
    EXPECT_EQ(&drawn.bodies.pair->probe(), probe.get());
    EXPECT_EQ(&drawn.session->fixed(), &drawn.bodies.pair->fixed());
    EXPECT_EQ(drawn.session->device_pose().p, drawn.bodies.first.p);
    EXPECT_EQ(drawn.session->coupling().k, 321);
    EXPECT_EQ(std::size_t(drawn.bodies.probe_surface->GetNumberOfPolys()),
              probe->soup.triangles.size());
  }
}

}  // namespace
}  // namespace sonde::ui::test
