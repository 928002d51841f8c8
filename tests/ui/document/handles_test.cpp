// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/handles.hpp"

#include <gtest/gtest.h>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"

namespace sonde::ui::test {
namespace {

/// Seen from above, 1000 pixels a metre: the reference is plain arithmetic.
QPointF from_above(const Vec3& x) { return {1000 * x.x(), -1000 * x.y()}; }

const Handles at_origin{Vec3::Zero(), Mat3::Identity(), 0.1};

TEST(Handles, are_taken_where_they_are) {
  const auto along_x = grip_at(at_origin, from_above, {95, 3});
  ASSERT_TRUE(along_x);
  EXPECT_FALSE(along_x->turns);
  EXPECT_EQ(along_x->axis, 0);
  const auto about_z = grip_at(at_origin, from_above, {57, -57});
  ASSERT_TRUE(about_z);
  EXPECT_TRUE(about_z->turns);
  EXPECT_EQ(about_z->axis, 2);
  EXPECT_FALSE(grip_at(at_origin, from_above, {200, 200}));
}

TEST(Handles, an_arrow_follows_the_cursor_along_its_axis_alone) {
  EXPECT_NEAR(follow(at_origin, {false, 0, {}}, from_above, {20, 500}), 0.02, 1e-12);
  EXPECT_NEAR(follow(at_origin, {false, 1, {}}, from_above, {0, -30}), 0.03, 1e-12);
  EXPECT_EQ(follow(at_origin, {false, 2, {}}, from_above, {20, 20}), 0) << "it points at the eye";
}

TEST(Handles, a_ring_follows_the_cursor_round) {
  const Grip grip{true, 2, Vec3(0.08, 0, 0)};
  // Upwards on screen at its right: anticlockwise, by arc over radius.
  EXPECT_NEAR(follow(at_origin, grip, from_above, {0, -8}), 0.1, 1e-3);
  EXPECT_NEAR(follow(at_origin, grip, from_above, {0, 8}), -0.1, 1e-3);
}

class HandleTest : public WindowTest {
 protected:
  Pose pose() { return window->session()->device_pose(); }
  QPointF on_screen(const Vec3& x) { return window->viewport().on_screen(x); }
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    act("show_handles");
    ASSERT_TRUE(window->viewport().handles(pose()));
  }
};

TEST_F(HandleTest, an_arrow_moves_the_probe_along_its_axis_in_one_step) {
  const Pose before = pose();
  const Handles handles = *window->viewport().handles(before);
  const QPointF from = on_screen(handles.centre + handles.axes.col(0) * handles.length * 0.9);
  const QPointF to = on_screen(handles.centre + handles.axes.col(0) * handles.length * 1.4);
  drag(Qt::LeftButton, from, to - from);
  const Vec3 moved = pose().p - before.p;
  EXPECT_NEAR(moved.x(), 0.5 * handles.length, 0.05 * handles.length);
  EXPECT_LT(moved.tail<2>().norm(), 1e-12);
  EXPECT_EQ(pose().q.coeffs(), before.q.coeffs());
  EXPECT_EQ(window->documents().document().stack().count(), 1);
  act("undo");
  EXPECT_TRUE(wait_until([&] { return (pose().p - before.p).norm() < 1e-12; }));
}

TEST_F(HandleTest, a_ring_turns_it_about_its_axis_local_too) {
  Pose turned = pose();
  turned.q = Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()));
  window->set_device_pose(turned);
  settle();
  act("local_handles");
  const Vec3 com_before = com();
  const Handles handles = *window->viewport().handles(pose());
  EXPECT_LT((handles.axes - turned.q.toRotationMatrix()).norm(), 1e-12);
  const Vec3 arm = (handles.axes.col(0) + handles.axes.col(1)).normalized() * handles.length;
  const Vec3 there = Eigen::AngleAxisd(0.3, handles.axes.col(2)) * Vec3(arm * ring_part);
  const QPointF from = on_screen(handles.centre + arm * ring_part);
  drag(Qt::LeftButton, from, on_screen(handles.centre + there) - from);
  const Eigen::AngleAxisd turn(pose().q * turned.q.conjugate());
  EXPECT_GT(std::abs(turn.axis().dot(handles.axes.col(2))), 1 - 1e-9) << "about the probe's z";
  EXPECT_NEAR(turn.angle(), 0.3, 0.05);
  EXPECT_LT((com() - com_before).norm(), 1e-12);
}

TEST_F(HandleTest, beside_them_a_drag_is_as_ever) {
  const Pose before = pose();
  drag(Qt::LeftButton, on_screen(com()) + QPointF(160, 130), {20, 0});
  const Vec3 moved = pose().p - before.p;
  EXPECT_LT(std::abs(moved.dot(window->viewport().camera().axes().towards)), 1e-9);
  EXPECT_GT(moved.norm(), 1e-4);
}

}  // namespace
}  // namespace sonde::ui::test
