// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pose_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QFocusEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>
#include <numbers>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

enum Turn { roll_pitch_yaw_at, axis_angle_at, quaternion_at, matrix_at };

/// A quarter turn about z at (1/3, −0.02, 0.03) m, in millimetres.
class PosePanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<PosePanel>();
    QObject::connect(panel.get(), &PosePanel::placed,
                     [this](const Pose& pose) { placed.push_back(pose); });
    panel->show();
    panel->suggest_unit("mm");
    panel->show_pose(pose);
  }
  template <class T>
  T* find(const QString& name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name.toStdString();
    return found;
  }
  std::string number(int field) const {
    return find<QLineEdit>(QStringLiteral("pose_%1").arg(field))->text().toStdString();
  }
  void turn_as(Turn turn) { find<QComboBox>("pose_turn")->setCurrentIndex(turn); }
  void type(const QString& field, const char* text) {
    auto* edit = find<QLineEdit>(field);
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  const Pose pose{Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ())),
                  Vec3(1.0 / 3, -0.02, 0.03)};
  std::unique_ptr<PosePanel> panel;
  std::vector<Pose> placed;
};

TEST_F(PosePanelTest, shows_a_pose_in_the_chosen_unit_and_way_to_turn) {
  EXPECT_EQ(number(0), "333.3333");
  EXPECT_EQ(number(1), "-20");
  EXPECT_EQ(number(3) + ' ' + number(4) + ' ' + number(5), "0 0 90") << "roll, pitch, yaw";
  EXPECT_FALSE(find<QLineEdit>("pose_6")->isVisible());
  turn_as(axis_angle_at);
  EXPECT_EQ(number(3) + ' ' + number(4) + ' ' + number(5) + ' ' + number(6), "0 0 1 90");
  turn_as(quaternion_at);
  EXPECT_EQ(number(3) + ' ' + number(6), "0.7071068 0.7071068");
  panel->suggest_unit("µm");
  EXPECT_EQ(number(1), "-20000");
  panel->suggest_unit("furlong");
  EXPECT_EQ(number(1), "-20000") << "no unit that it knows";
  turn_as(matrix_at);
  EXPECT_FALSE(find<QLineEdit>("pose_3")->isVisible());
  EXPECT_TRUE(find<QPlainTextEdit>("pose_matrix")->isVisible());
}

TEST_F(PosePanelTest, a_typed_number_changes_that_one_and_no_bit_of_the_others) {
  type("pose_1", "12,5");
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_DOUBLE_EQ(placed[0].p.y(), 0.0125);
  EXPECT_EQ(placed[0].p.x(), pose.p.x());
  EXPECT_EQ(placed[0].q.coeffs(), pose.q.coeffs());
  type("pose_5", "-90");
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_NEAR((placed[1].q * Vec3::UnitX() + Vec3::UnitY()).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(placed[1].p.y(), 0.0125);
  turn_as(quaternion_at);
  type("pose_3", "2");  // (2, 0, 0, −0.707…), made of length 1
  ASSERT_EQ(placed.size(), 3u);
  EXPECT_NEAR(placed[2].q.norm(), 1, 1e-12);
  EXPECT_NEAR(placed[2].q.w(), 2 / std::sqrt(4.5), 1e-12);
}

TEST_F(PosePanelTest, what_is_no_pose_places_nothing) {
  type("pose_0", "1e");
  EXPECT_EQ(number(0), "333.3333") << "as it was";
  type("pose_0", "inf");
  turn_as(axis_angle_at);
  type("pose_5", "0");  // the axis would be of no length
  EXPECT_EQ(number(5), "1");
  turn_as(matrix_at);
  auto* matrix = find<QPlainTextEdit>("pose_matrix");
  const QString before = matrix->toPlainText();
  const auto leave_with = [&](const char* text) {
    matrix->setPlainText(text);
    matrix->document()->setModified(true);
    QFocusEvent away(QEvent::FocusOut);
    QApplication::sendEvent(matrix, &away);
  };
  leave_with("[[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]");
  EXPECT_EQ(matrix->toPlainText(), before) << "it is no turn";
  EXPECT_TRUE(placed.empty());
  leave_with("[[0, -1, 0, 0.5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]");
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].p, Vec3(0.5, 0, 0));
  EXPECT_NEAR((placed[0].q * Vec3::UnitX() - Vec3::UnitY()).norm(), 0, 1e-12);
}

TEST_F(PosePanelTest, a_button_of_snapping_is_down_while_clicks_are_waited_for) {
  std::vector<std::optional<SnapKind>> wanted;
  QObject::connect(panel.get(), &PosePanel::snap_wanted,
                   [&](std::optional<SnapKind> kind) { wanted.push_back(kind); });
  auto* edge = find<QPushButton>("snap_edge");
  edge->click();
  panel->show_snap(SnapKind::edge, "Click an edge of the probe.");
  EXPECT_TRUE(edge->isChecked());
  EXPECT_FALSE(find<QPushButton>("snap_face")->isChecked());
  EXPECT_EQ(find<QLabel>("snap_words")->text(), "Click an edge of the probe.");
  edge->click();
  EXPECT_EQ(wanted, (std::vector<std::optional<SnapKind>>{SnapKind::edge, std::nullopt}));
  panel->show_snap({}, {});
  EXPECT_FALSE(find<QLabel>("snap_words")->isVisible());
}

TEST_F(PosePanelTest, steps_of_the_arrow_keys_are_above_zero_and_in_its_unit) {
  Nudge nudge;
  QObject::connect(panel.get(), &PosePanel::nudge_changed, [&](const Nudge& now) { nudge = now; });
  panel->suggest_step(5e-4);
  EXPECT_EQ(find<QLineEdit>("nudge_step")->text(), "0.5");
  type("nudge_step", "0.25");
  EXPECT_DOUBLE_EQ(nudge.step, 2.5e-4);
  type("nudge_turn", "45");
  EXPECT_DOUBLE_EQ(nudge.turn, std::numbers::pi / 4);
  for (const char* none : {"0", "-3", "."}) type("nudge_step", none);
  EXPECT_DOUBLE_EQ(nudge.step, 2.5e-4);
  EXPECT_EQ(find<QLineEdit>("nudge_step")->text(), "0.25");
  find<QComboBox>("nudge_axes")->setCurrentIndex(2);
  EXPECT_EQ(nudge.axes, Nudge::Axes::probe);
}

TEST_F(PosePanelTest, says_which_face_the_arrow_keys_go_along) {
  Nudge nudge;
  QObject::connect(panel.get(), &PosePanel::nudge_changed, [&](const Nudge& now) { nudge = now; });
  auto* words = find<QLabel>("nudge_face");
  EXPECT_FALSE(words->isVisible()) << "of other axes there is nothing to say";
  find<QComboBox>("nudge_axes")->setCurrentIndex(static_cast<int>(Nudge::Axes::face));
  EXPECT_TRUE(words->isVisible());
  EXPECT_TRUE(words->text().contains("None was clicked"));
  panel->show_face(PickedFace{"nut", false, Vec3::UnitX()});
  EXPECT_TRUE(words->text().contains("of nut: its normal is (1.00, 0, 0)"));
  ASSERT_TRUE(nudge.face);
  EXPECT_EQ(nudge.face->normal, Vec3::UnitX());
}

TEST_F(PosePanelTest, the_scenes_axes_are_offered_where_they_are_not_the_fixed_bodys) {
  Nudge nudge;
  QObject::connect(panel.get(), &PosePanel::nudge_changed, [&](const Nudge& now) { nudge = now; });
  auto* axes = find<QComboBox>("nudge_axes");
  EXPECT_EQ(axes->count(), 4);
  for (int i = 0; i < 2; ++i) panel->set_scene_axes(pose.q);
  ASSERT_EQ(axes->count(), 5);
  axes->setCurrentIndex(4);
  EXPECT_EQ(nudge.axes, Nudge::Axes::world);
  EXPECT_EQ(nudge.q_FW.coeffs(), pose.q.coeffs());
  panel->set_scene_axes(Quat::Identity());
  EXPECT_EQ(axes->count(), 4);
  EXPECT_EQ(nudge.axes, Nudge::Axes::fixed);
}

TEST_F(PosePanelTest, micrometres_are_written_as_everywhere) {
  panel->suggest_unit(QStringLiteral("µm"));
  EXPECT_EQ(find<QComboBox>("pose_unit")->currentText(), QStringLiteral("µm"));
  EXPECT_EQ(number(1), "-20000");
  panel->suggest_step(5e-7);
  EXPECT_EQ(find<QLineEdit>("nudge_step")->text(), "0.5");
}

}  // namespace
}  // namespace sonde::ui::test
