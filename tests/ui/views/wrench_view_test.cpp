// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/wrench_view.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// 2 mm for each newton, and a quarter turn for 0.1 N·m. The centre of mass is at x = 0.1 m.
class WrenchViewTest : public testing::Test {
 protected:
  void SetUp() override {
    stage.mass.com = Vec3(0.1, 0, 0);
    view.set_scale({.metres_per_newton = 0.002, .newton_metres_per_quarter = 0.1});
  }
  Stage stage;
  WrenchView view{*stage.renderer, stage.shapes};
};

/// 1.3 · 50 mm / 10 N is 6.5 mm, and 0.5 N·m / 1.4 is 0.357: rounded down to 1, 2 or 5.
TEST_F(WrenchViewTest, scales_are_round_and_their_legend_says_them) {
  Coupling coupling;
  coupling.max_force = 10;
  coupling.max_torque = 0.5;
  const WrenchScale scale = wrench_scale(0.05, coupling);
  EXPECT_DOUBLE_EQ(scale.metres_per_newton, 0.005);
  EXPECT_DOUBLE_EQ(scale.newton_metres_per_quarter, 0.2);
  view.set_scale(scale);
  EXPECT_EQ(view.force_legend(LengthUnit(0.05)), "force, 1 N is 5 mm");
  EXPECT_EQ(view.torque_legend(), "torque, a quarter turn is 0.2 N·m");
}

TEST_F(WrenchViewTest, a_force_is_an_arrow_as_long_as_its_scale_says) {
  stage.snapshot.wrench.force = Vec3(0, 3, -4);
  stage.snapshot.hand.asked = stage.snapshot.wrench;
  view.set_note({.text = "stable", .now = {}, .course = {}});
  view.show(stage.frame());
  ASSERT_EQ(texts_of(view), QStringList{"5.00 N"});
  EXPECT_EQ(view.labels()[0].note.text, "stable");
  EXPECT_NEAR((view.labels()[0].at - Vec3(0.1, 0.006, -0.008)).norm(), 0, 1e-12);
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 2u) << "a shaft and a head";
  EXPECT_NEAR(bounds_of(*seen[0]).center().x(), 0.1, 1e-6);
  EXPECT_LE(bounds_of(*seen[1]).min().z(), -0.008 + 1e-6);
  stage.snapshot.coupling.max_force = 5;
  view.show(stage.frame());
  EXPECT_EQ(texts_of(view), QStringList{"5.00 N (limit)"});
  EXPECT_EQ(lessened_text(Lessened::coming_in, 0.4), "coming in, 40 %");
  EXPECT_EQ(lessened_text(Lessened::nothing, 0.4), "");
}

/// 0.1 N·m about z is a quarter turn: from where the arc begins, it ends at a right angle.
TEST_F(WrenchViewTest, a_torque_turns_about_its_axis_as_far_as_its_scale_says) {
  const Vec3 com(0.1, 0, 0);
  const auto ends = [&](double torque) {
    stage.snapshot.wrench.torque = Vec3(0, 0, torque);
    stage.snapshot.hand.asked = stage.snapshot.wrench;
    view.show(stage.frame());
    const std::vector<Vec3>& stroke = view.labels().at(0).stroke;
    return std::pair<Vec3, Vec3>(stroke.front() - com, stroke.back() - com);
  };
  auto [from, to] = ends(0.1);
  EXPECT_NEAR(from.dot(to), 0, 1e-12);
  EXPECT_GT(from.cross(to).z(), 0) << "by the right hand";
  EXPECT_EQ(texts_of(view), QStringList{"0.100 N·m"});
  std::tie(from, to) = ends(-0.1);
  EXPECT_LT(from.cross(to).z(), 0);
  std::tie(from, to) = ends(0.2);
  EXPECT_NEAR((from + to).norm(), 0, 1e-12) << "half a turn";
  std::tie(from, to) = ends(5);
  EXPECT_GT((from - to).norm(), 0.1 * from.norm()) << "never a whole turn, whose end says nothing";
}

TEST_F(WrenchViewTest, without_a_force_there_is_no_arrow) {
  stage.snapshot.wrench.force = Vec3(1, 0, 0);
  stage.snapshot.wrench.torque = Vec3(0, 0.1, 0);
  view.show(stage.frame());
  EXPECT_EQ(stage.seen().size(), 4u);
  stage.snapshot.wrench = {};
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
