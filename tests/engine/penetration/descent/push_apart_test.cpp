// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/push_apart.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/geometry/random.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/conforming_scene.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

bool is_free(const Body& a, const Body& b, const Pose& X) {
  return !overlap(a, b, Transform(X), Doubt::exact);
}

// Reference: a ball is as deep in a plate as its lowest point.
TEST(PushApart, a_ball_comes_out_of_a_plate_by_the_side_it_is_near) {
  const auto ball = test::body(test::sphere(0.05, 20, 40));
  const auto plate = test::body(test::box({1, 1, 0.2}));
  for (const double depth : {1e-4, 0.01, 0.04}) {
    const Chart chart(ball->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.15 - depth}});
    for (const Method method : {Method::pdg, Method::pdt}) {
      const auto y = PushApart(*ball, *plate, method).from(chart, Vec6::Zero(), anywhere);
      ASSERT_TRUE(y) << depth;
      EXPECT_TRUE(is_free(*ball, *plate, chart.pose(*y))) << depth;
      EXPECT_LE(y->norm(), 1.5 * depth + 1e-3 * 0.05) << depth;
      EXPECT_TRUE(method == Method::pdg || y->head<3>().isZero(0)) << depth;
    }
  }
}

// Reference: the hole is wider than the rod by 1 % of its radius; a random pose would hardly be in.
TEST(PushApart, a_rod_goes_back_into_the_middle_of_its_hole) {
  const test::ConformingScene scene = test::cylinder_in_hole();
  for (const int n : {1, 5}) {
    const auto bodies = test::cut_bodies(scene, {n, test::Cutting::Kind::random}, test::askew());
    const Pose X = Pose{test::askew().world, Vec3::Zero()} * scene.path[60] *
                   Pose{test::askew().probe.conjugate(), Vec3::Zero()};
    const Chart chart(bodies.probe->mass, X);
    ASSERT_FALSE(is_free(*bodies.probe, *bodies.fixed, X));
    const auto y =
        PushApart(*bodies.probe, *bodies.fixed, Method::pdg).from(chart, Vec6::Zero(), anywhere);
    ASSERT_TRUE(y) << n;
    EXPECT_TRUE(is_free(*bodies.probe, *bodies.fixed, chart.pose(*y))) << n;
    EXPECT_LE(y->norm(), 2e-3) << n << ": it is pressed 0.5 mm, the way out along it is 25 mm";
  }
}

// References: exact predicates, and |y| itself. A toothed plug is 2 mm too low in its sleeve and
// turned by 6 degrees; the ball reaches 1.3 times as far as the way back. Triangles push most
// overlaps out of the ball first: before they were moved back into it, 3 of 100 became free.
TEST(PushApart, what_is_pushed_out_of_the_ball_comes_back_and_finds_the_fit) {
  const test::Section toothed = test::toothed_section(7, 0.012, 0.018);
  const auto plug = test::body(test::fitted_plug(toothed, 0.009, {}));
  const auto sleeve = test::body(test::fitted_socket(test::grown(toothed, 0.0012), 1.7, 0.013, {}));
  const Pose device{Quat(Eigen::AngleAxisd(0.1, Vec3(0.4, 0.3, 1).normalized())),
                    {0.002, 0.001, -0.002}};
  const Chart chart(plug->mass, device);
  const double back = chart.coordinates({Quat::Identity(), {0, 0, -0.002}}).norm();
  PushApart push(*plug, *sleeve, Method::pdg);
  int freed = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const auto y = push.from(chart, random.in_ball(1.2 * back), 1.3 * back);
    if (!y) continue;
    ++freed;
    EXPECT_LT(y->norm(), 1.3 * back) << seed;
    EXPECT_TRUE(is_free(*plug, *sleeve, chart.pose(*y))) << seed;
  }
  EXPECT_GE(freed, 20);
}

// References: exact predicates, and the pose in the fit. The walls are two triangles each, and
// where these cross at an edge, the way out that the edge allows may be as long as the plug.
TEST(PushApart, large_triangles_do_not_push_a_plug_out_lengthwise) {
  const double room = 0.0002;
  const test::Section sections[] = {test::dovetail_section(0.014, 0.012, 0.003),
                                    test::dovetail_section(0.02, 0.008, 0.004),
                                    test::keyed_section(5, 0.01, 0.014, 0.003)};
  for (const test::Section& section : sections) {
    const auto plug = test::body(test::fitted_plug(section, 0.009, {}));
    const auto socket = test::body(test::fitted_socket(test::grown(section, room), 1.8, 0.02, {}));
    PushApart push(*plug, *socket, Method::pdg);
    int freed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      Random random(seed);
      const Chart home(plug->mass, Pose{Quat::Identity(), Vec3::Zero()});
      const Chart chart(plug->mass, home.pose(5 * room * random.in_ball(1)));
      const double back = chart.coordinates(home.device()).norm();
      const auto y = push.from(chart, Vec6::Zero(), anywhere);
      freed += y && y->norm() < 2 * back + 2 * room;
    }
    EXPECT_GE(freed, 30) << "with the long ways 2, 0 and 100";
  }
}

// References: exact predicates, and the pose in the fit. The walls are as long as the shaft, and
// the shaft is longer than the bore: when the points of the rows were corners of the shaft even
// where a corner of the bore touches its wall, they turned the shaft about the wrong place.
TEST(PushApart, a_long_tilted_shaft_is_turned_back_into_its_bore) {
  const double room = 1e-4;
  test::Section flattened = test::regular_section(24, 0.006);
  std::erase_if(flattened, [](const auto& corner) { return corner.x() > 0.0045; });
  const test::Section sections[] = {flattened, test::regular_section(6, 0.005),
                                    test::toothed_section(7, 0.005, 0.0062)};
  for (const test::Section& section : sections) {
    const auto shaft = test::body(test::fitted_plug(section, 0.014, {}));
    const auto bore = test::body(test::fitted_socket(test::grown(section, room), 1.8, 0.006, {}));
    PushApart push(*shaft, *bore, Method::pdg);
    const Chart home(shaft->mass, Pose{Quat::Identity(), Vec3::Zero()});
    int freed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      Random random(seed);
      const Chart chart(shaft->mass, home.pose(0.001 * random.in_ball(1)));
      const double back = chart.coordinates(home.device()).norm();
      const auto y = push.from(chart, Vec6::Zero(), anywhere);
      if (!y) continue;
      EXPECT_TRUE(is_free(*shaft, *bore, chart.pose(*y))) << seed;
      freed += y->norm() < 2 * back + 2 * room;
    }
    EXPECT_GE(freed, 50) << "about corners of the shaft 8, 17 and 8";
  }
}

TEST(PushApart, it_is_given_up_too_far_out_or_where_no_triangles_meet) {
  const auto small = test::body(test::box({0.1, 0.1, 0.1})), big = test::body(test::box({1, 1, 1}));
  PushApart push(*small, *big, Method::pdg);
  const Chart inside(small->mass, Pose{Quat::Identity(), Vec3::Zero()});
  EXPECT_FALSE(push.from(inside, Vec6::Zero(), anywhere));
  const Chart half_out(small->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.5}});
  EXPECT_TRUE(push.from(half_out, Vec6::Zero(), anywhere));
  EXPECT_FALSE(push.from(half_out, Vec6::Zero(), 0.04)) << "it is 0.05 deep";
  const Deadline over{.microseconds = 1e-3, .started = now_us() - 1};
  EXPECT_FALSE(push.from(half_out, Vec6::Zero(), anywhere, over));
}

}  // namespace
}  // namespace sonde
