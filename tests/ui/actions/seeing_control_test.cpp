// SPDX-License-Identifier: GPL-3.0-or-later
// Seeing inside: by the keys, the mouse and the docks of the window.
#include "ui/actions/seeing_control.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeWidget>
#include <cstdlib>

#include "engine/proximity/queries/point_distance.hpp"
#include "tests/ui/actions/seeing_fixture.hpp"
#include "tests/ui/actions/session_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/saved_views.hpp"
#include "ui/views/body_look.hpp"
#include "ui/views/gap_view.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(SeeingTest, the_probe_is_seen_through_the_fixed_body) {
  hide_overlays();
  act("from_left");  // the fixed body covers the probe
  const int before = pixels_of_hue(picture(), colour::probe);
  key(Qt::Key_X);
  EXPECT_TRUE(find<QAction>("xray_fixed")->isChecked());
  EXPECT_GT(pixels_of_hue(picture(), colour::probe), before + 5000);
  key(Qt::Key_X);
  EXPECT_NEAR(pixels_of_hue(picture(), colour::probe), before, 50);
}

TEST_F(SeeingTest, the_probe_can_be_seen_through_or_hidden_or_made_of_wires) {
  hide_overlays();
  const int before = pixels_of_hue(picture(), colour::probe);
  ASSERT_GT(before, 5000);
  auto* looks = window->findChild<QComboBox*>("probe_look");
  looks->setCurrentIndex(static_cast<int>(Look::hidden));
  EXPECT_TRUE(find<QAction>("hide_probe")->isChecked()) << "the menu says what the dock does";
  EXPECT_EQ(pixels_of_hue(picture(), colour::probe), 0);
  looks->setCurrentIndex(static_cast<int>(Look::wireframe));
  const int wires = pixels_of_hue(picture(), colour::probe);
  EXPECT_GT(wires, 50);
  EXPECT_LT(wires, before / 4);
  looks->setCurrentIndex(static_cast<int>(Look::xray));
  EXPECT_LT(pixels_of_hue(picture(), colour::probe), before - 1000) << "its colour is mixed";
  looks->setCurrentIndex(static_cast<int>(Look::opaque));
  EXPECT_NEAR(pixels_of_hue(picture(), colour::probe), before, 50);
}

TEST_F(SeeingTest, a_contact_is_chosen_in_the_list_and_in_the_view) {
  auto* rows = window->findChild<QTreeWidget*>("contact_rows");
  ASSERT_TRUE(rows);
  auto* panel = window->findChild<QDockWidget*>("contacts_panel");
  panel->show();
  panel->raise();
  ASSERT_TRUE(wait_until([&] { return rows->topLevelItemCount() > 0; }));
  EXPECT_EQ(rows->topLevelItemCount(), shown().separation.clusters.size);
  double shares = 0;
  for (int i = 0; i < rows->topLevelItemCount(); ++i)
    shares += rows->topLevelItem(i)->text(3).section(' ', 0, 0).toDouble();
  EXPECT_NEAR(shares, 100, 3);
  // The dock slides in: the view has its size once it keeps it.
  for (QSize size; picture().size() != size; wait(300)) size = picture().size();
  const QImage before = picture();
  rows->topLevelItem(0)->setSelected(true);
  EXPECT_GT(pixels_between(before, picture()), 30) << "marked in the view";
  rows->clearSelection();
  EXPECT_LT(pixels_between(before, picture()), 20);
  // The other way: a click beside the contact's point.
  const ContactCluster& c = shown().separation.clusters[0];
  click(window->viewport().on_screen(c.contact.on_fixed) + QPointF(3, 2));
  ASSERT_EQ(rows->selectedItems().size(), 1);
  EXPECT_EQ(rows->selectedItems()[0]->text(0).toULongLong(), c.id);
  EXPECT_GT(pixels_between(before, picture()), 30);
}

/// Seen along its normal, where the arrows of force and screw lie over the contact's point: its own
/// colour is what is seen there.
TEST_F(SeeingTest, no_arrow_and_no_body_covers_a_contact) {
  const ContactCluster& c = shown().separation.clusters[0];
  const Vec3 normal = c.contact.normal;
  for (const Vec3& from : {Vec3(normal), Vec3(-normal), Vec3(Vec3(1, 2, 3).normalized())}) {
    window->viewport().camera().look_at(c.contact.on_fixed, from, Vec3(0.1, 0.2, 0.9), 0.5);
    const QImage image = picture();
    EXPECT_GT(
        pixels_of_hue(image.copy(QRect(
                          window->viewport().on_screen(c.contact.on_fixed).toPoint() - QPoint(4, 4),
                          QSize(9, 9))),
                      colour::contact) +
            pixels_of_hue(
                image.copy(
                    QRect(window->viewport().on_screen(c.contact.on_fixed).toPoint() - QPoint(4, 4),
                          QSize(9, 9))),
                colour::probe),
        30);
  }
}

TEST_F(SeeingTest, two_clicks_measure_the_side_of_a_cube) {
  act("hide_probe");
  act("from_front");
  key(Qt::Key_M);
  const Pose before = window->session()->device_pose();
  // On the face y = 0, well inside it: the reference is the mesh.
  const Vec3 one(0.01, 0, 0.02), other(0.04, 0, 0.06);
  picture();
  click(window->viewport().on_screen(one));
  ASSERT_EQ(window->viewport().measured().size(), 1u);
  EXPECT_NEAR((window->viewport().measured()[0].x - one).norm(), 0, 1e-6);
  const Vec3 in_probe = inverse(before) * one;
  EXPECT_NEAR(window->viewport().measured()[0].gap,
              point_distance(window->session()->probe(), in_probe), 1e-6);
  click(window->viewport().on_screen(other));
  ASSERT_EQ(window->viewport().measured().size(), 2u);
  const auto& points = window->viewport().measured();
  EXPECT_NEAR((points[0].x - points[1].x).norm(), 0.05, 1e-5);
  click({3, 3});
  EXPECT_EQ(window->viewport().measured().size(), 2u) << "beside the bodies: nothing";
  EXPECT_EQ(window->session()->device_pose().p, before.p) << "measuring moves nothing";
  key(Qt::Key_M);
  EXPECT_TRUE(window->viewport().measured().empty());
}

TEST_F(SeeingTest, what_is_cut_away_or_hidden_is_not_measured) {
  act("hide_probe");
  act("from_front");
  window->findChild<QPushButton*>("cut_y")->click();
  window->findChild<QPushButton*>("cut_flip")->click();  // what is near the eye goes
  picture();
  const auto pick = window->viewport().pick(window->viewport().on_screen(Vec3(0.03, 0.05, 0.03)));
  ASSERT_TRUE(pick);
  EXPECT_NEAR(pick->x.y(), 0.1, 1e-9) << "the far face, seen from inside";
  act("hide_fixed");
  EXPECT_FALSE(window->viewport().pick(window->viewport().on_screen(Vec3(0.03, 0.05, 0.03))));
}

TEST_F(SeeingTest, gaps_are_painted_with_a_legend) {
  hide_overlays();
  act("hide_probe");
  act("from_right");
  const QImage before = picture();
  const QColor touch = gap_colour(0);
  const int yellow = pixels_of_hue(before, touch);
  const QImage sheet = window->viewport().grab().toImage();
  key(Qt::Key_K);
  ASSERT_TRUE(wait_until(
      [&] { return pixels_of_hue(window->viewport().picture(), touch) > yellow + 500; }));
  EXPECT_GT(pixels_between(sheet, window->viewport().grab().toImage()), 1000);
  key(Qt::Key_K);
  EXPECT_LT(pixels_between(before, picture()), 50);
}

TEST_F(SeeingTest, the_camera_follows_the_contact) {
  key(Qt::Key_V);
  const auto off = [this] {
    const ContactCluster& c = shown().separation.clusters[0];
    return (window->viewport().camera().target() - c.contact.on_fixed).norm();
  };
  EXPECT_TRUE(wait_until([&] { return shown().separation.clusters.size > 0 && off() < 0.08; }));
  const Vec3 target = window->viewport().camera().target();
  window->set_paused(false);
  Pose pose = window->session()->device_pose();
  pose.p.y() += 0.05;
  window->set_device_pose(pose);
  EXPECT_TRUE(
      wait_until([&] { return (window->viewport().camera().target() - target).y() > 0.01; }));
}

TEST_F(SeeingTest, axis_views_look_along_the_axes) {
  for (const auto& [name, towards] :
       {std::pair{"from_right", Vec3(1, 0, 0)}, std::pair{"from_front", Vec3(0, -1, 0)},
        std::pair{"from_above", Vec3(0, 0, 1)}}) {
    act(name);
    EXPECT_NEAR((window->viewport().camera().axes().towards - towards).norm(), 0, 1e-9) << name;
  }
}

/// Turned with the fixed body, whose frame the window shows.
TEST_F(SeeingTest, a_scene_says_from_where_it_is_looked_at) {
  const auto file = folder.write("looked.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off", "pose": [0, 0, 0, 0, 0, 0, 1]},
      "view": {"direction": [3, 0, 4], "up": [0, 1, 0]}})");
  open({QString::fromStdString(file.string())});
  const ViewAxes axes = window->viewport().camera().axes();
  EXPECT_LT((axes.towards - Vec3(-0.6, 0, 0.8)).norm(), 1e-9);
  EXPECT_NEAR(axes.up.dot(Vec3(0, -1, 0)), 1, 1e-9);
}

TEST_F(SeeingTest, a_view_is_saved_with_the_scene_and_undone) {
  act("from_above");
  const CameraPlace above = window->viewport().place();
  window->findChild<QPushButton*>("view_save")->click();
  auto* list = window->findChild<QListWidget*>("saved_views");
  ASSERT_EQ(list->count(), 1);
  ASSERT_TRUE(window->documents().save());
  act("from_front");
  open({QString::fromStdString(scene.string())});
  list = window->findChild<QListWidget*>("saved_views");
  ASSERT_EQ(list->count(), 1) << "it came back with the file";
  emit list->itemClicked(list->item(0));
  EXPECT_NEAR((window->viewport().place().position - above.position).norm(), 0, 1e-9);
  EXPECT_NEAR((window->viewport().place().target - above.target).norm(), 0, 1e-9);
  list->setCurrentRow(0);
  window->findChild<QPushButton*>("view_forget")->click();
  EXPECT_EQ(list->count(), 0);
  act("undo");
  EXPECT_EQ(list->count(), 1);
}

/// Two cubes in one mesh, one through the other, and a cube that is sound.
TEST_F(SeeingTest, self_intersections_are_looked_for_when_asked_and_shown) {
  std::string twice = "OFF\n16 24 0\n";
  const std::string one = cube(0.1);
  const auto lines = QString::fromStdString(one).split('\n', Qt::SkipEmptyParts);
  for (const double shift : {0.0, 0.05})
    for (int i = 2; i < 10; ++i) {
      for (const QString& x : lines[i].split(' ', Qt::SkipEmptyParts))
        twice += std::to_string(x.toDouble() + shift) + ' ';
      twice += '\n';
    }
  for (const int shift : {0, 8})
    for (int i = 10; i < 22; ++i) {
      const QStringList corner = lines[i].split(' ', Qt::SkipEmptyParts);
      twice += '3';
      for (int k = 1; k < 4; ++k) twice += ' ' + std::to_string(corner[k].toInt() + shift);
      twice += '\n';
    }
  folder.write("twice.off", twice);
  folder.write("twice.sonde.json",
               R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "twice.off"}})");
  open({path("twice.sonde.json")});
  window->set_paused(true);
  hide_overlays();
  const QImage without = picture();
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_TRUE(find<QAction>("show_crossings")->isChecked());
  auto* log = window->findChild<QPlainTextEdit*>("log_lines");
  ASSERT_TRUE(wait_until([&] { return log->toPlainText().contains("Self-intersections"); }));
  EXPECT_TRUE(log->toPlainText().contains("probe: none")) << log->toPlainText().toStdString();
  // Of each cube the six triangles that meet at the corner in the other, at least.
  EXPECT_TRUE(
      log->toPlainText().contains(QRegularExpression("fixed body: (1[2-9]|2[0-4]) triangles")))
      << log->toPlainText().toStdString();
  EXPECT_GT(pixels_between(without, picture()), 1000);
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_LT(pixels_between(without, picture()), 50);
}

}  // namespace
}  // namespace sonde::ui::test
