// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/analytic_wrench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

RenderSetup setup_of(const PolygonSoup& probe, const PolygonSoup& fixed) {
  RenderSetup out{.pair = {test::body(probe), test::body(fixed)}};
  out.coupling.k = 400;
  return out;
}

/// Askew, down to 4 mm below the top of a block whose top is z = 0.2, and up again.
std::vector<TimedPose> press(const Body& probe) {
  const Quat q(Eigen::AngleAxisd(0.3, Vec3(1, 0.5, 0.2).normalized()));
  double lowest = 0;
  for (const Vec3& x : probe.soup.vertices) lowest = std::min(lowest, (q * x).z());
  std::vector<TimedPose> out;
  for (int i = 0; i <= 60; ++i)
    out.push_back({0.001 * i, {q, Vec3(0, 0, 0.196 - lowest + 0.0003 * std::abs(30 - i))}});
  return out;
}

// Reference of the rendering: the search over rotations. It was compared with the solver on many
// poses elsewhere (exact_cases_test.cpp); here the two meet as wrenches.
TEST(AnalyticWrench, on_a_large_box_the_rendering_of_pdg_agrees) {
  const RenderSetup s = setup_of(test::box({0.03, 0.05, 0.07}), test::box({0.8, 0.8, 0.4}));
  const auto path = press(s.pair.probe());
  const AnalyticWrenches known = analytic_wrenches(s, path, 1, 8, never);
  ASSERT_EQ(known.kind, AnalyticKind::half_space);
  ASSERT_EQ(known.ticks.size(), 8u);
  const double radius = s.pair.probe().mass.radius;
  const TorqueRealism pdg = torque_realism(render(s, Method::pdg, path, never), known, radius);
  EXPECT_EQ(pdg.ticks, 8u);
  EXPECT_LT(pdg.worst_force_error, 0.01);
  EXPECT_LT(pdg.worst_torque_error, 0.01);
  const TorqueRealism pdt = torque_realism(render(s, Method::pdt, path, never), known, radius);
  EXPECT_GT(pdt.force_error, 0.1) << "askew, it pays to turn";
}

// Reference: symmetry. A facet spans 7.5° by 7.5°, so its normal is at most 5.4° off the radius to
// any of its points, and the force has at most that much of an arm.
TEST(AnalyticWrench, nothing_turns_a_ball) {
  const RenderSetup s = setup_of(test::sphere(0.03, 24, 48), test::torus(0.08, 0.03, 40, 20));
  std::vector<TimedPose> path;
  for (int i = 0; i <= 30; ++i)
    path.push_back({0.001 * i, {Quat::Identity(), Vec3(0.13 - 0.0005 * i, 0.013, 0.02)}});
  const AnalyticWrenches known = analytic_wrenches(s, path, 1, 8, never);
  EXPECT_EQ(known.kind, AnalyticKind::ball);
  const TorqueRealism pdg = torque_realism(render(s, Method::pdg, path, never), known, 0.03);
  EXPECT_GT(pdg.ticks, 5u);
  EXPECT_LT(pdg.worst_torque_error, std::sin(5.4 * std::numbers::pi / 180));
}

TEST(AnalyticWrench, of_other_pairs_none_is_known) {
  const RenderSetup s = setup_of(test::box({0.03, 0.05, 0.07}), test::torus(0.08, 0.03, 40, 20));
  const AnalyticWrenches known = analytic_wrenches(s, press(s.pair.probe()), 1, 8, never);
  EXPECT_EQ(known.kind, AnalyticKind::none);
  EXPECT_EQ(torque_realism(render(s, Method::pdg, press(s.pair.probe()), never), known, 0.04).ticks,
            0u);
}

TEST(AnalyticWrench, the_same_after_being_written_and_read) {
  AnalyticWrenches out{AnalyticKind::half_space, {{7, {0.1, -2, 1.0 / 3}, {0, 1e-17, 5}}}};
  const AnalyticWrenches back = analytic_wrenches_of(to_json(out), "part");
  EXPECT_EQ(back.kind, out.kind);
  ASSERT_EQ(back.ticks.size(), 1u);
  EXPECT_EQ(back.ticks[0].tick, 7u);
  EXPECT_EQ(back.ticks[0].force, out.ticks[0].force);
  EXPECT_EQ(back.ticks[0].torque, out.ticks[0].torque);
  for (const char* wrong : {"", "{}", R"({"kind": "ellipsoid", "ticks": []})"})
    EXPECT_THROW(analytic_wrenches_of(wrong, "part"), InputError) << wrong;
}

}  // namespace
}  // namespace sonde
