// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QWheelEvent>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui::test {
namespace {

class MouseTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    start = window->session()->device_pose();
    com_before = com();
    view = window->viewport().camera().axes();
  }
  void wheel(int notches, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QWheelEvent event(middle, middle, {}, QPoint(0, 120 * notches), Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(window->viewport().canvas(), &event);
  }
  Pose now() const { return window->session()->device_pose(); }
  Vec3 moved() const { return com() - com_before; }
  double turned() const { return now().q.angularDistance(start.q); }

  Pose start;
  Vec3 com_before;
  ViewAxes view;
  QPointF middle{300, 300};
};

TEST_F(MouseTest, a_drag_takes_the_probe_along_with_the_cursor) {
  act("show_hint");  // else it fades after the drag, and the view is fitted
  const QPointF before = window->viewport().on_screen(com());
  drag(Qt::LeftButton, middle, {60, -40});
  const QPointF after = window->viewport().on_screen(com());
  EXPECT_NEAR(after.x() - before.x(), 60, 0.5);
  EXPECT_NEAR(after.y() - before.y(), -40, 0.5);
  EXPECT_NEAR(moved().dot(view.towards), 0, 1e-12);
  EXPECT_NEAR(turned(), 0, 1e-9);
  // It reaches the servo, and comes back as a picture.
  EXPECT_TRUE(wait_until([this] { return shown().separation.device.p == now().p; }));
}

TEST_F(MouseTest, the_wheel_moves_in_depth) {
  wheel(3);
  EXPECT_LT(moved().dot(view.towards), 0) << "forwards is away";
  EXPECT_NEAR((moved() - view.towards * moved().dot(view.towards)).norm(), 0, 1e-12);
}

TEST_F(MouseTest, shift_turns_about_the_centre_of_mass) {
  drag(Qt::LeftButton, middle, {50, 0}, Qt::ShiftModifier);
  EXPECT_NEAR(moved().norm(), 0, 1e-12);
  const Eigen::AngleAxisd turn(now().q * start.q.conjugate());
  EXPECT_GT(turn.angle(), 0.1);
  EXPECT_NEAR(turn.axis().dot(view.up), 1, 1e-6) << "to the right: about the picture's up";
}

TEST_F(MouseTest, ctrl_rolls_with_the_cursor) {
  const QPointF centre = window->viewport().on_screen(com());
  drag(Qt::LeftButton, centre + QPointF(80, 0), {0, -80}, Qt::ControlModifier);
  const Eigen::AngleAxisd turn(now().q * start.q.conjugate());
  EXPECT_NEAR(turn.angle(), std::atan(1.0), 1e-3);
  EXPECT_NEAR(turn.axis().dot(view.towards), 1, 1e-6) << "anticlockwise on screen";
  EXPECT_NEAR(moved().norm(), 0, 1e-12);
}

TEST_F(MouseTest, the_right_button_orbits_the_camera_only) {
  const double distance =
      (window->viewport().camera().eye() - window->viewport().camera().target()).norm();
  drag(Qt::RightButton, middle, {70, 20});
  const ViewAxes after = window->viewport().camera().axes();
  EXPECT_LT(after.towards.dot(view.towards), 0.99);
  EXPECT_NEAR((window->viewport().camera().eye() - window->viewport().camera().target()).norm(),
              distance, 1e-9);
  EXPECT_EQ(now().p, start.p);
}

TEST_F(MouseTest, ctrl_and_wheel_zoom) {
  const double before = window->viewport().metres_per_pixel(window->viewport().camera().target());
  wheel(2, Qt::ControlModifier);
  EXPECT_LT(window->viewport().metres_per_pixel(window->viewport().camera().target()), before);
  EXPECT_EQ(now().p, start.p);
}

TEST_F(MouseTest, the_middle_button_pans) {
  const Vec3 target = window->viewport().camera().target();
  drag(Qt::MiddleButton, middle, {30, 0});
  EXPECT_LT((window->viewport().camera().target() - target).dot(view.right), 0);
}

TEST_F(MouseTest, keys_nudge_and_turn) {
  const double step = round_down_125(0.01 * window->session()->probe().mass.radius);
  key(Qt::Key_Right);
  EXPECT_NEAR((moved() - step * view.right).norm(), 0, 1e-12);
  key(Qt::Key_Left);
  key(Qt::Key_PageUp);
  EXPECT_NEAR((moved() + step * view.towards).norm(), 0, 1e-12);
  key(Qt::Key_PageDown);
  EXPECT_NEAR(moved().norm(), 0, 1e-12);
  key(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(turned(), 2 * std::atan(1.0) / 45, 1e-6);
}

TEST_F(MouseTest, keys_go_along_the_axes_that_are_chosen_by_the_step_that_is_shown) {
  auto* dock = window->findChild<QDockWidget*>("pose_panel");
  dock->show();
  dock->raise();
  auto* axes = find<QComboBox>("nudge_axes");
  EXPECT_EQ(find<QLineEdit>("nudge_step")->text(), "0.5") << "of a cube of 100 mm, R 86.6 mm";
  axes->setCurrentIndex(1);
  type("nudge_step", "2.5");
  type("nudge_turn", "10");
  key(Qt::Key_Right);
  EXPECT_NEAR((moved() - Vec3(2.5e-3, 0, 0)).norm(), 0, 1e-12);
  key(Qt::Key_Left);
  key(Qt::Key_PageUp);
  EXPECT_NEAR((moved() - Vec3(0, 0, 2.5e-3)).norm(), 0, 1e-12);
  key(Qt::Key_PageDown);
  key(Qt::Key_Up, Qt::ShiftModifier);
  const Eigen::AngleAxisd turn(now().q * start.q.conjugate());
  EXPECT_NEAR(turn.angle(), std::atan(1.0) * 4 / 18, 1e-9);
  EXPECT_NEAR((turn.axis() - Vec3::UnitY()).norm(), 0, 1e-9);
  // Its own axes have turned with it.
  axes->setCurrentIndex(2);
  key(Qt::Key_Right);
  EXPECT_NEAR((moved() - turn * Vec3(2.5e-3, 0, 0)).norm(), 0, 1e-9);
  type("nudge_step", "-1");
  EXPECT_EQ(find<QLineEdit>("nudge_step")->text(), "2.5") << "no step";
}

TEST_F(MouseTest, reset_brings_the_probe_back) {
  drag(Qt::LeftButton, middle, {90, 10});
  wait(60);
  act("reset");
  EXPECT_EQ(now().p, start.p);
  EXPECT_TRUE(
      wait_until([this] { return window->shown() && shown().separation.device.p == start.p; }));
  drag(Qt::LeftButton, middle, {10, 0});
  EXPECT_LT(moved().norm(), 20 * window->viewport().metres_per_pixel(com_before))
      << "the mouse goes on from the start";
}

TEST_F(MouseTest, pause_stops_the_ticks) {
  auto* pause = window->findChild<QAction*>("pause");
  pause->trigger();
  EXPECT_TRUE(wait_until([this] { return shown().paused; }));
  wait(50);
  const std::uint64_t tick = shown().tick;
  wait(150);
  EXPECT_LE(shown().tick, tick + 1);
  pause->trigger();
  EXPECT_TRUE(wait_until([&] { return shown().tick > tick + 5; }));
}

}  // namespace
}  // namespace sonde::ui::test
