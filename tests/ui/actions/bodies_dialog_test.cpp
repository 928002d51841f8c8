// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/bodies_dialog.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

MeshPair pair_of(double probe, double fixed) {
  MeshPair pair;
  pair.probe_size = Vec3(probe, probe / 2, probe / 4);
  pair.fixed_size = Vec3(fixed / 3, fixed, fixed / 2);
  pair.probe_edges.closed = true;
  pair.fixed_edges.open_edges = 34;
  pair.fixed_edges.misoriented_edges = 1;
  return pair;
}

class BodiesTest : public WindowTest {};

TEST_F(BodiesTest, each_body_has_a_unit_of_its_own) {
  const MeshPair pair = pair_of(120, 0.09);
  BodiesDialog dialog(pair, same_unit(pair, 1), window.get());
  dialog.findChild<QComboBox*>("probe_unit")->setCurrentIndex(2);  // mm
  dialog.findChild<QComboBox*>("fixed_up")->setCurrentIndex(1);
  dialog.findChild<QComboBox*>("probe_model")->setCurrentIndex(2);
  const PairSetup said = dialog.setup();
  EXPECT_EQ(said.probe.unit, 1e-3);
  EXPECT_EQ(said.fixed.unit, 1);
  EXPECT_EQ(said.fixed.up, UpAxis::y);
  EXPECT_EQ(said.probe.model, Model::surface);
  const Scene scene = scene_of(pair, said);
  EXPECT_EQ(scene.unit, 1);
  EXPECT_EQ(scene.probe.scale, 1e-3);
  EXPECT_LT((scene.fixed.pose.q * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15) << "y is up";
}

TEST_F(BodiesTest, the_probe_is_taken_smaller_or_larger) {
  const MeshPair pair = pair_of(1, 1);
  BodiesDialog dialog(pair, same_unit(pair, 1), window.get());
  auto* way = dialog.findChild<QComboBox*>("probe_offset_way");
  auto* length = dialog.findChild<QDoubleSpinBox*>("probe_offset");
  EXPECT_FALSE(length->isEnabled());
  EXPECT_EQ(dialog.setup().probe.offset, 0);
  way->setCurrentIndex(1);
  EXPECT_TRUE(length->isEnabled());
  length->setValue(0.01);
  EXPECT_EQ(length->text(), "0.01 mm");
  const PairSetup smaller = dialog.setup();
  EXPECT_EQ(smaller.probe.offset, -1e-5);
  EXPECT_EQ(smaller.fixed.offset, 0);
  EXPECT_EQ(scene_of(pair, smaller).probe.offset, -1e-5);
  way->setCurrentIndex(2);
  length->findChild<QLineEdit*>()->setText("2.5 mm");
  EXPECT_EQ(dialog.setup().probe.offset, 2.5e-3);
  BodiesDialog again(pair, smaller, window.get());
  EXPECT_EQ(again.findChild<QComboBox*>("probe_offset_way")->currentIndex(), 1);
  EXPECT_EQ(again.setup().probe.offset, -1e-5);
}

TEST_F(BodiesTest, beyond_thirty_times_it_offers_the_same_size) {
  const MeshPair near = pair_of(29, 1), far = pair_of(1200, 1);
  BodiesDialog calm(near, same_unit(near, 1), window.get());
  EXPECT_TRUE(calm.findChild<QPushButton*>("same_size")->isHidden());
  BodiesDialog dialog(far, same_unit(far, 1e-3), window.get());
  dialog.show();
  auto* same = dialog.findChild<QPushButton*>("same_size");
  ASSERT_TRUE(same->isVisible());
  EXPECT_TRUE(dialog.findChild<QLabel*>("size_warning")->text().contains("1200"));
  QTest::mouseClick(same, Qt::LeftButton);
  EXPECT_NEAR(dialog.setup().probe.scale, 1.0 / 1200, 1e-12);
  EXPECT_FALSE(same->isVisible());
}

TEST_F(BodiesTest, says_what_was_found) {
  const MeshPair pair = pair_of(1, 1);
  const BodiesDialog dialog(pair, same_unit(pair, 1), window.get());
  EXPECT_EQ(dialog.findChild<QLabel*>("probe_found")->text(), "closed: the inside counts");
  const QString found = dialog.findChild<QLabel*>("fixed_found")->text();
  EXPECT_TRUE(found.contains("34 open edges: there are holes")) << found.toStdString();
  EXPECT_TRUE(found.contains("1 edge between flipped faces")) << found.toStdString();
}

TEST_F(BodiesTest, and_shows_where_in_the_view) {
  answered_unit = 1e-3;
  open({path("large.off"), path("open.off")});
  ASSERT_EQ(opened, 1);
  window->set_paused(true);
  act("from_right");  // from elsewhere the body hides it
  settle();
  const QImage without = picture();
  act("show_defects");
  EXPECT_GT(pixels_between(without, picture()), 60) << "a triangle of the fixed cube is missing";
}

/// The reference is the files' own coordinates: both meshes with y up, read as such, lie as they do
/// with z up when the files have it so.
TEST_F(BodiesTest, what_is_up_in_the_file_is_up_in_the_scene) {
  folder.write("bar.off",
               "OFF\n4 4 0\n0 0 0\n0.01 0 0\n0 0.2 0\n0 0 0.01\n"
               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto file = folder / "bar.off";
  MeshPair pair = read_pair(file, file);
  PairSetup setup = same_unit(pair, 1);
  setup.probe.up = setup.fixed.up = UpAxis::y;
  const LoadedScene opened = build_pair(std::move(pair), setup);
  const Quat q_WF = opened.scene.fixed.pose.q;
  EXPECT_LT((q_WF * Vec3(0, 0.2, 0) - Vec3(0, 0, 0.2)).norm(), 1e-15);
  EXPECT_LT(opened.start.q.angularDistance(Quat::Identity()), 1e-12);
  const Vec3 away = q_WF * (opened.start.p);
  EXPECT_GT(away.dot(Vec3(-0.45, -1, 0.55)), 0) << "on the eye's side, in the scene's axes";
}

}  // namespace
}  // namespace sonde::ui::test
