// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/snap_control.hpp"

#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <numbers>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/seeing_control.hpp"

namespace sonde::ui {
namespace {

/// The probe hangs askew over the fixed body, and one looks at three of its sides.
class SnapTest : public test::WindowTest {
 protected:
  void open_askew(const char* mesh, const char* pose) {
    const auto askew =
        folder.write("askew.sonde.json", R"({"unit": "m", "probe": {"mesh": ")" +
                                             std::string(mesh) + R"(", "pose": )" + pose +
                                             R"(}, "fixed": {"mesh": ")" + mesh + R"("}})");
    open({QString::fromStdString(askew.string())});
    ASSERT_EQ(failed, 0);
    find<QDockWidget>("pose_panel")->show();
    window->seeing().look_from(Vec3(-0.4, -1, 0.6).normalized(), Vec3::UnitZ());
    picture();
  }
  void click(const Vec3& x) { drag(Qt::LeftButton, window->viewport().on_screen(x), {0, 0}); }
  Pose here() const { return window->session()->device_pose(); }
  QString words() const { return find<QLabel>("snap_words")->text(); }
  /// A rod about z, of radius 20 mm and height 0.1 m from z = 0.
  static std::string rod() {
    constexpr int sides = 24;
    std::string corners, faces, low = std::to_string(sides), high = low;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      for (const char* z : {"0", "0.1"})
        corners += std::to_string(0.02 * std::cos(angle)) + ' ' +
                   std::to_string(0.02 * std::sin(angle)) + ' ' + z + '\n';
      const int next = 2 * ((i + 1) % sides);
      faces += "4 " + std::to_string(2 * i) + ' ' + std::to_string(next) + ' ' +
               std::to_string(next + 1) + ' ' + std::to_string(2 * i + 1) + '\n';
      low += ' ' + std::to_string(2 * (sides - 1 - i));
      high += ' ' + std::to_string(2 * i + 1);
    }
    return "OFF\n" + std::to_string(2 * sides) + ' ' + std::to_string(sides + 2) + " 0\n" +
           corners + faces + low + '\n' + high + '\n';
  }
  static constexpr const char* turned = "[0.02, 0.01, 0.17, 0.98, 0.1, 0.05, 0.16]";
};

// Reference: the faces' planes, by hand.
TEST_F(SnapTest, a_face_lies_on_a_face) {
  open_askew("cube.off", turned);
  find<QPushButton>("snap_face")->click();
  EXPECT_TRUE(words().contains("a face of the probe")) << words().toStdString();
  click(here() * Vec3(0.05, 0, 0.05));
  EXPECT_TRUE(words().contains("of the fixed body")) << words().toStdString();
  click({0.05, 0.0, 0.05});
  EXPECT_LT((here().q * -Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-6) << "they look at each other";
  EXPECT_NEAR((here() * Vec3(0.05, 0, 0.05)).y(), 0, 1e-7);
  EXPECT_FALSE(find<QPushButton>("snap_face")->isChecked());
  act("undo");
  EXPECT_NEAR(here().p.z(), 0.17, 1e-9);
}

TEST_F(SnapTest, an_edge_lies_along_an_edge_in_whichever_order_they_are_clicked) {
  open_askew("cube.off", turned);
  find<QPushButton>("snap_edge")->click();
  click({0.05, 0, 0.098});
  EXPECT_TRUE(words().contains("of the probe")) << words().toStdString();
  click(here() * Vec3(0.05, 0, 0.098));
  for (const double x : {0.0, 0.1}) {
    const Vec3 at = here() * Vec3(x, 0, 0.1);
    EXPECT_LT(std::hypot(at.y(), at.z() - 0.1), 1e-6);
  }
}

// Reference: rods about z.
TEST_F(SnapTest, the_axis_of_a_round_face_lies_on_the_other) {
  folder.write("rod.off", rod());
  open_askew("rod.off", turned);
  find<QPushButton>("snap_axis")->click();
  click(here() * Vec3(0.0, 0, 0.1));
  EXPECT_TRUE(words().contains("not round")) << words().toStdString();
  EXPECT_TRUE(find<QPushButton>("snap_axis")->isChecked()) << "the next click may be";
  const Vec3 near_eye(0.02 * std::cos(-1.9), 0.0199 * std::sin(-1.9), 0.05);
  click(here() * near_eye);
  click(near_eye);
  // The rods' corners are written to a micrometre.
  for (const double z : {0.0, 0.1}) {
    const Vec3 at = here() * Vec3(0, 0, z);
    EXPECT_LT(std::hypot(at.x(), at.y()), 2e-6) << z;
  }
}

TEST_F(SnapTest, it_is_given_up_by_its_button_and_by_another_scene) {
  open_askew("cube.off", turned);
  const Pose before = here();
  find<QPushButton>("snap_face")->click();
  click(here() * Vec3(0.05, 0, 0.05));
  find<QPushButton>("snap_face")->click();
  EXPECT_TRUE(words().isEmpty());
  click({0.05, 0.0, 0.05});
  EXPECT_EQ(here().p, before.p);
  find<QPushButton>("snap_edge")->click();
  open_cubes();
  EXPECT_FALSE(find<QPushButton>("snap_edge")->isChecked());
}

}  // namespace
}  // namespace sonde::ui
