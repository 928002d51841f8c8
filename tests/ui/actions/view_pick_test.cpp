// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/view_pick.hpp"

#include <gtest/gtest.h>

#include <QMouseEvent>

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// What moves the probe would see of the mouse.
class Behind : public QObject {
 public:
  int seen = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    const auto type = event->type();
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove &&
        type != QEvent::MouseButtonRelease)
      return false;
    ++seen;
    return true;
  }
};

class ViewPickTest : public ViewportAloneTest {
 protected:
  void SetUp() override {
    ViewportAloneTest::SetUp();
    if (HasFatalFailure()) return;
    view->canvas()->installEventFilter(&behind);
    pick = std::make_unique<ViewPick>(*view, nullptr);
    QObject::connect(pick.get(), &ViewPick::picked, [this](QPointF at) { picked.push_back(at); });
    QObject::connect(pick.get(), &ViewPick::clicked, [this](QPointF at) { clicked.push_back(at); });
    QObject::connect(pick.get(), &ViewPick::cut_moved, [this](double by) { moved += by; });
    QObject::connect(pick.get(), &ViewPick::cut_turned, [this](const Vec3& by) { turned += by; });
  }
  void TearDown() override {
    pick.reset();
    view->canvas()->removeEventFilter(&behind);
  }
  void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
            Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QMouseEvent event(type, at, button, held, keys);
    QApplication::sendEvent(view->canvas(), &event);
  }
  void drag(QPointF from, QPointF by, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers keys = Qt::NoModifier) {
    send(QEvent::MouseButtonPress, from, button, button, keys);
    for (int i = 1; i <= 4; ++i)
      send(QEvent::MouseMove, from + by * (i / 4.0), Qt::NoButton, button, keys);
    send(QEvent::MouseButtonRelease, from + by, button, Qt::NoButton, keys);
  }
  /// A plane across x through the fixed body's middle, looked at from the front.
  Handles show_cut() {
    Seeing seeing;
    seeing.cut.on = true;
    view->set_seeing(seeing);
    look_from({0, -0.6, 0.1});
    const auto handles = view->cut_handles();
    EXPECT_TRUE(handles);
    return handles ? *handles : Handles{Vec3::Zero(), Mat3::Identity(), 1};
  }
  Behind behind;
  std::unique_ptr<ViewPick> pick;
  std::vector<QPointF> picked, clicked;
  double moved = 0;
  Vec3 turned = Vec3::Zero();
};

TEST_F(ViewPickTest, a_click_is_told_and_seen_by_what_moves_the_probe_too) {
  drag({300, 200}, {2, 1});
  EXPECT_EQ(clicked, std::vector<QPointF>{QPointF(300, 200)}) << "a hand is never quite still";
  EXPECT_EQ(behind.seen, 6);
  EXPECT_TRUE(picked.empty());
}

TEST_F(ViewPickTest, a_drag_is_no_click) {
  drag({300, 200}, {30, 0});
  EXPECT_TRUE(clicked.empty());
  EXPECT_EQ(behind.seen, 6);
}

TEST_F(ViewPickTest, other_buttons_and_clicks_with_a_key_are_not_its_own) {
  drag({300, 200}, {0, 0}, Qt::RightButton);
  drag({300, 200}, {0, 0}, Qt::LeftButton, Qt::ShiftModifier);
  pick->set_measuring(true);
  drag({300, 200}, {0, 0}, Qt::MiddleButton);
  EXPECT_TRUE(clicked.empty());
  EXPECT_TRUE(picked.empty());
  EXPECT_EQ(behind.seen, 18);
}

TEST_F(ViewPickTest, while_measuring_clicks_pick_and_the_probe_stays) {
  pick->set_measuring(true);
  EXPECT_TRUE(pick->measuring());
  drag({310, 220}, {0, 0});
  drag({310, 220}, {50, 0});
  EXPECT_EQ(picked, std::vector<QPointF>{QPointF(310, 220)}) << "a drag picks nothing";
  EXPECT_TRUE(clicked.empty());
  EXPECT_EQ(behind.seen, 0);
  pick->set_measuring(false);
  drag({310, 220}, {0, 0});
  EXPECT_EQ(clicked.size(), 1u);
}

TEST_F(ViewPickTest, the_arrow_of_the_cut_moves_it_along_its_normal_and_the_probe_stays) {
  const Handles handles = show_cut();
  const QPointF from = view->on_screen(handles.centre);
  const QPointF tip = view->on_screen(handles.centre + handles.axes.col(2) * handles.length);
  drag(from + 0.9 * (tip - from), 0.5 * (tip - from));
  EXPECT_NEAR(moved, 0.5 * handles.length, 0.05 * handles.length);
  EXPECT_EQ(turned, Vec3::Zero());
  EXPECT_EQ(behind.seen, 0);
  EXPECT_TRUE(clicked.empty());
}

TEST_F(ViewPickTest, a_click_on_the_arrow_moves_nothing_and_is_no_click_in_the_view) {
  const Handles handles = show_cut();
  const QPointF tip = view->on_screen(handles.centre + 0.9 * handles.axes.col(2) * handles.length);
  drag(tip, {0, 0});
  EXPECT_EQ(moved, 0);
  EXPECT_TRUE(clicked.empty());
}

TEST_F(ViewPickTest, a_ring_of_the_cut_turns_it_about_an_axis_in_its_plane) {
  const Handles handles = show_cut();
  // Where a ring about the axis that points most to the eye is grabbed.
  const Eigen::Index axis =
      std::abs(handles.axes.col(0).y()) > std::abs(handles.axes.col(1).y()) ? 0 : 1;
  const Vec3 out = (handles.axes.col(1 - axis) + handles.axes.col(2)).normalized();
  const Vec3 along = handles.axes.col(axis).cross(out);
  const double radius = ring_part * handles.length;
  const QPointF grip = view->on_screen(handles.centre + radius * out);
  const QPointF next = view->on_screen(handles.centre + radius * (out + 0.2 * along));
  drag(grip, next - grip);
  EXPECT_NEAR(turned.dot(handles.axes.col(axis)), 0.2, 0.05);
  EXPECT_LT(turned.cross(Vec3(handles.axes.col(axis))).norm(), 1e-9);
  EXPECT_EQ(moved, 0);
  EXPECT_EQ(behind.seen, 0);
}

TEST_F(ViewPickTest, beside_the_handles_the_mouse_is_as_ever) {
  show_cut();
  drag({20, 400}, {40, 0});
  EXPECT_EQ(moved, 0);
  EXPECT_EQ(turned, Vec3::Zero());
  EXPECT_EQ(behind.seen, 6);
}

}  // namespace
}  // namespace sonde::ui::test
