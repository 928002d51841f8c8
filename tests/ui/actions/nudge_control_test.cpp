// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/nudge_control.hpp"

#include <QComboBox>
#include <QLabel>
#include <QStatusBar>
#include <numbers>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/devices/nudge.hpp"

namespace sonde::ui::test {
namespace {

/// The fixed cube is turned by 90° about x in the scene, and the probe hangs beside it.
class NudgeTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    const double half = std::sqrt(0.5);
    folder.write("turned.sonde.json", R"({"unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0]},
        "fixed": {"mesh": "cube.off", "pose": [0, 0, 0, )" +
                                          std::to_string(half) + ", " + std::to_string(half) +
                                          R"(, 0, 0]}})");
    open({path("turned.sonde.json")});
    ASSERT_EQ(failed, 0);
    find<QDockWidget>("pose_panel")->show();
    window->seeing().look_from(Vec3(-0.4, -1, 0.6).normalized(), Vec3::UnitZ());
    settle();
    start = window->session()->device_pose();
  }
  void choose(Nudge::Axes axes) {
    find<QComboBox>("nudge_axes")->setCurrentIndex(static_cast<int>(axes));
  }
  void click(const Vec3& x) { drag(Qt::LeftButton, window->viewport().on_screen(x), {0, 0}); }
  Vec3 moved() const { return window->session()->device_pose().p - start.p; }
  QString words() const { return find<QLabel>("nudge_face")->text(); }
  Pose start;
};

TEST_F(NudgeTest, keys_go_out_of_the_face_that_was_clicked_last) {
  choose(Nudge::Axes::face);
  EXPECT_TRUE(find<QLabel>("nudge_face")->isVisible());
  EXPECT_TRUE(words().contains("None was clicked yet")) << words().toStdString();
  key(Qt::Key_PageUp);
  EXPECT_EQ(moved().norm(), 0);
  EXPECT_TRUE(window->statusBar()->currentMessage().contains("click on one first"));

  click({0.05, 0, 0.05});
  EXPECT_EQ(words(), QStringLiteral("The face clicked last, of the fixed body: its normal is "
                                    "(0, -1.00, 0)."));
  key(Qt::Key_PageUp);
  EXPECT_LT(moved().y(), -1e-5);
  EXPECT_NEAR(std::hypot(moved().x(), moved().z()), 0, 1e-12);
  key(Qt::Key_PageDown);
  key(Qt::Key_Up);
  EXPECT_GT(moved().z(), 1e-5);
  EXPECT_NEAR(std::hypot(moved().x(), moved().y()), 0, 1e-12);

  click(window->session()->device_pose() * Vec3(0.05, 0, 0.05));
  EXPECT_TRUE(words().contains("of the probe: its normal is (0, -1.00, 0)"))
      << "in its own axes: " << words().toStdString();
  click({-0.3, 0, 0});
  EXPECT_TRUE(words().contains("of the probe")) << "a click beside the bodies changes nothing";
  open_cubes();
  EXPECT_TRUE(words().contains("None was clicked yet")) << "of other bodies";
}

TEST_F(NudgeTest, keys_go_along_the_scenes_axes_where_these_are_others) {
  auto* axes = find<QComboBox>("nudge_axes");
  ASSERT_EQ(axes->count(), 5);
  choose(Nudge::Axes::world);
  key(Qt::Key_PageUp);
  const double step = moved().norm();
  EXPECT_GT(step, 1e-5);
  EXPECT_NEAR((moved() - Vec3(0, step, 0)).norm(), 0, 1e-6 * step)
      << "up in the scene is y of the mesh";
  open_cubes();
  EXPECT_EQ(axes->count(), 4) << "there they are the fixed body's";
  EXPECT_EQ(axes->currentIndex(), static_cast<int>(Nudge::Axes::fixed));
}

}  // namespace
}  // namespace sonde::ui::test
