// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/background_search.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>
#include <utility>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;

class BackgroundSearchTest : public testing::Test {
 protected:
  std::shared_ptr<const Body> probe = test::body(test::box({0.02, 0.03, 0.05}));
  std::shared_ptr<const Body> fixed = test::body(test::box({0.3, 0.3, 0.1}));
  BackgroundSearch search{{probe, fixed}};

  static Pose at_depth(double depth, double x = 0) {
    return {Quat::Identity(), Vec3(x, 0, 0.075 - depth)};
  }
  /// The answer about this pose; for a minute, which only a hung search takes.
  std::optional<BackgroundResult> answer(const Pose& X) {
    for (const auto end = std::chrono::steady_clock::now() + 60s;
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(1ms))
      if (const auto r = search.latest(); r && r->device.p == X.p) return r;
    return std::nullopt;
  }
};

TEST_F(BackgroundSearchTest, has_nothing_to_say_before_it_is_asked) {
  std::this_thread::sleep_for(5ms);
  EXPECT_FALSE(search.latest());
}

TEST_F(BackgroundSearchTest, computes_the_translational_depth_and_a_lower_bound) {
  search.request(at_depth(0.002));
  const auto r = answer(at_depth(0.002));
  ASSERT_TRUE(r);
  ASSERT_TRUE(r->pdt);
  EXPECT_NEAR(r->pdt->depth, 0.002, 1e-5);  // a box flat in a block: straight up
  ASSERT_TRUE(r->lower_bound);
  EXPECT_GE(*r->lower_bound, 0);
  EXPECT_LE(*r->lower_bound, r->nearest->depth);
  EXPECT_GT(r->time_us, 0);
}

TEST_F(BackgroundSearchTest, is_as_sure_as_is_wanted_from_then_on) {
  search.request(at_depth(0.002));
  const auto usual = answer(at_depth(0.002));
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->sure, StaticOptions{}.sure);
  EXPECT_GT(usual->budget_us, 0);
  search.set_sure(0.99);
  const auto surer = answer(at_depth(0.002));  // searched again by itself
  ASSERT_TRUE(surer);
  EXPECT_EQ(surer->sure, 0.99);
  EXPECT_FALSE(surer->far_out) << "straight up is as long as the overlap is deep";
}

TEST_F(BackgroundSearchTest, says_where_the_time_went_where_that_is_asked) {
  search.request(at_depth(0.002));
  const auto untimed = answer(at_depth(0.002));
  ASSERT_TRUE(untimed);
  EXPECT_EQ(untimed->phases.sum(), 0);
  search.set_time_phases(true);
  search.request(at_depth(0.003));
  const auto timed = answer(at_depth(0.003));
  ASSERT_TRUE(timed);
  for (const Phase phase : {Phase::sketch, Phase::look, Phase::verify, Phase::bound})
    EXPECT_GT(timed->phases[phase], 0) << phase_names[static_cast<std::size_t>(phase)];
}

/// With a tilt, a turn is the shorter way: one vertex of the box is below the block's face, at r
/// from the centre, and d²/(1 + (r×n)ᵀ Î⁻¹ (r×n)) holds until another vertex touches.
TEST_F(BackgroundSearchTest, the_nearest_way_out_turns_where_that_is_shorter) {
  const Quat tilt(Eigen::AngleAxisd(0.3, Vec3(1, 0.5, 0).normalized()));
  double lowest = 0;
  Vec3 r = Vec3::Zero();
  for (const Vec3& vertex : probe->soup.vertices)
    if (const Vec3 turned = tilt * vertex; turned.z() < lowest) lowest = turned.z(), r = turned;
  constexpr double d = 2e-4;
  const Pose pose{tilt, Vec3(0, 0, 0.05 - lowest - d)};
  search.request(pose);
  const auto found = answer(pose);
  ASSERT_TRUE(found && found->pdt && found->nearest);
  const Vec3 arm = tilt.inverse() * r.cross(Vec3::UnitZ());
  const Vec3 sides(0.02, 0.03, 0.05);
  const Vec3 squares = sides.cwiseAbs2() / 12;
  const Vec3 inertia(squares.y() + squares.z(), squares.x() + squares.z(),
                     squares.x() + squares.y());
  const double expected = d / std::sqrt(1 + arm.cwiseAbs2().cwiseQuotient(inertia).sum());
  EXPECT_NEAR(found->pdt->depth, d, 0.01 * d);
  EXPECT_NEAR(found->nearest->depth, expected, 0.02 * expected);
  const MassProperties& mass = probe->mass;
  const SeparationMotion motion = separation_motion(mass, pose, found->nearest->separated);
  EXPECT_GT(motion.theta.norm(), 1e-4) << "the pose is the one that goes with the depth";
}

/// A shaft upside down in its bore: its collar, 8 mm long and 4 mm thick, is in the bore's lower
/// end, and the only short way is straight down. Known is that way with a turn too small to matter.
/// Reference: the closed form; the collar's upper face is 6 mm above the bore's lower one.
TEST(BackgroundSearchKnown, a_way_counts_without_its_turn) {
  const auto shaft = test::body(test::lathed({{0, 0},
                                              {0.00795, 0},
                                              {0.00795, 0.03},
                                              {0.01, 0.03},
                                              {0.01, 0.034},
                                              {0.005, 0.034},
                                              {0.004, 0.044},
                                              {0, 0.044}},
                                             37));
  const auto bore =
      test::body(test::lathed({{0.008, 0}, {0.02, 0}, {0.02, 0.035}, {0.008, 0.035}}, 64));
  const Quat turned_over(0, 1, 0, 0);
  const Pose device{turned_over, Vec3(0, 0, 0.036)};
  const Pose known{Quat(Eigen::AngleAxisd(1e-7, Vec3::UnitZ())) * turned_over,
                   Vec3(0, 0, 0.036 - 0.0060001)};
  BackgroundSearch search{{shaft, bore}};
  search.request(device, known);
  while (!search.latest()) std::this_thread::sleep_for(1ms);
  const auto r = search.latest();
  ASSERT_TRUE(r->pdt && r->nearest);
  EXPECT_LE(r->pdt->depth, 0.0060001 * (1 + 2e-4));
  EXPECT_GE(r->pdt->depth, 0.006 * (1 - 1e-9));
  EXPECT_EQ((r->pdt->separated.q.coeffs() - device.q.coeffs()).norm(), 0) << "no turn";
  EXPECT_LE(r->nearest->depth, r->pdt->depth);
}

TEST_F(BackgroundSearchTest, is_zero_where_the_probe_is_free) {
  search.request(at_depth(-0.01));
  const auto r = answer(at_depth(-0.01));
  ASSERT_TRUE(r);
  ASSERT_TRUE(r->pdt);
  EXPECT_EQ(r->pdt->depth, 0);
  EXPECT_EQ(r->nearest->depth, 0);
}

TEST_F(BackgroundSearchTest, answers_the_newest_of_many_requests_and_goes_on_after_a_rest) {
  for (int round = 0; round < 3; ++round) {
    for (int i = 1; i <= 1000; ++i) search.request(at_depth(0.001, 1e-5 * i + 0.01 * round));
    EXPECT_TRUE(answer(at_depth(0.001, 1e-2 + 0.01 * round))) << round;
    std::this_thread::sleep_for(5ms);
  }
}

TEST_F(BackgroundSearchTest, a_pose_that_is_no_pose_has_no_answer) {
  Pose bad = at_depth(0.001);
  bad.q.w() = std::numeric_limits<double>::quiet_NaN();
  search.request(bad);
  const auto r = answer(bad);
  ASSERT_TRUE(r);
  EXPECT_FALSE(r->pdt);
  EXPECT_FALSE(r->nearest);
  EXPECT_FALSE(r->lower_bound);
  search.request(at_depth(0.002));
  EXPECT_TRUE(answer(at_depth(0.002)));
}

/// A slab thinner than the probe: whoever goes down through it is free again below. The followed
/// pose stays above, by construction as far as the device is below the slab's upper face.
class ThroughAWall : public BackgroundSearchTest {
 protected:
  std::shared_ptr<const Body> slab = test::body(test::box({0.3, 0.3, 0.01}));
  CoherentSolver follower{{probe, slab}, Method::pdg};
  BackgroundSearch search{{probe, slab}};

  /// The device goes straight down to this height of the probe's centre.
  std::pair<Separation, BackgroundResult> down_to(double z) {
    Separation followed = follower.reset({Quat::Identity(), Vec3(0, 0, 0.04)}, {});
    for (double at = 0.04; at > z; at -= 5e-4)
      followed = follower.tick({Quat::Identity(), Vec3(0, 0, at)}, Budget{});
    followed = follower.tick({Quat::Identity(), Vec3(0, 0, z)}, Budget{});
    search.request(followed.device);
    for (;; std::this_thread::sleep_for(1ms))
      if (const auto r = search.latest(); r && r->device.p == followed.device.p)
        return {followed, *r};
  }
};

TEST_F(ThroughAWall, what_is_followed_and_what_is_found_are_told_apart) {
  const auto [shallow, near] = down_to(0.028);
  EXPECT_NEAR(shallow.depth, 0.002, 1e-5);
  EXPECT_EQ(way_out(shallow, near), WayOut::nearest);
  EXPECT_STREQ(words(WayOut::nearest), "");
  const auto [deep, beyond] = down_to(-0.02);
  EXPECT_NEAR(beyond.pdt->depth, 0.01, 1e-5) << "down";
  ASSERT_GT(deep.depth, 0.02) << "held back above";
  EXPECT_EQ(way_out(deep, beyond), WayOut::nearer_blocked);
  const auto [through, free] = down_to(-0.035);
  EXPECT_EQ(free.pdt->depth, 0) << "free there";
  ASSERT_GT(through.depth, 0.02);
  EXPECT_EQ(way_out(through, free), WayOut::free_blocked);
  EXPECT_EQ(way_out(through, beyond), WayOut::unknown) << "an answer for another pose";
}

TEST_F(BackgroundSearchTest, ends_with_requests_waiting) {
  for (int i = 0; i < 20; ++i) {
    BackgroundSearch brief({probe, fixed});
    brief.request(at_depth(0.002));
    brief.request(at_depth(0.003));
  }
}

}  // namespace
}  // namespace sonde
