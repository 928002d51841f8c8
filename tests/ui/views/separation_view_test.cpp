// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/separation_view.hpp"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QStringList>
#include <cstdint>
#include <random>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "tests/support/shapes.hpp"
#include "ui/base/format.hpp"
#include "ui/views/probe_view.hpp"

namespace sonde::ui {
namespace {

/// Turning about the axis and sliding along it takes the centre of mass where the motion does.
TEST(Screw, is_the_motion) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    SeparationMotion motion;
    motion.t = sonde::test::random_in_ball(random, 1);
    motion.theta = sonde::test::random_in_ball(random, 3);
    const Vec3 com = sonde::test::random_in_ball(random, 2);
    const Screw screw = screw_of(motion, com);
    const Vec3 moved = screw.point +
                       Eigen::AngleAxisd(screw.turn, screw.axis) * (com - screw.point) +
                       screw.slide * screw.axis;
    EXPECT_NEAR((moved - (com + motion.t)).norm(), 0, 1e-9);
    EXPECT_NEAR((screw.axis * screw.turn - motion.theta).norm(), 0, 1e-12);
  }
}

TEST(Screw, of_a_translation_is_its_direction) {
  SeparationMotion motion;
  motion.t = Vec3(0, 0.003, 0);
  const Screw screw = screw_of(motion, Vec3(1, 2, 3));
  EXPECT_EQ(screw.turn, 0);
  EXPECT_DOUBLE_EQ(screw.slide, 0.003);
  EXPECT_EQ(screw.axis, Vec3::UnitY());
}

/// In the picture as in the readout: what moves is the centre of mass. The screw's slide is less,
/// and says whose it is.
TEST(SeparationView, says_how_far_the_centre_of_mass_moves) {
  MassProperties mass;
  mass.radius = 0.05;
  Snapshot snapshot;
  Separation& separation = snapshot.separation;
  separation.status = Status::penetrating;
  separation.depth = 0.002;
  const Vec3 slide(0, 0, 0.0005), across(0.0019, 0, 0);
  separation.separated = {Quat(Eigen::AngleAxisd(0.2, Vec3::UnitZ())), slide + across};
  vtkNew<vtkRenderer> renderer;
  GlyphShapes shapes;
  SeparationView view(*renderer, shapes);
  const LengthUnit unit(mass.radius);
  const Frame frame{snapshot, mass, unit, 1e-5};
  view.show(frame);
  QStringList labels;
  for (const Label& label : view.labels()) labels << label.text;
  const QString moved = unit.text((slide + across).norm());
  EXPECT_EQ(labels.filter("moves " + moved).size(), 1) << labels.join("; ").toStdString();
  ASSERT_EQ(labels.filter(unit.text(slide.norm())).size(), 1) << labels.join("; ").toStdString();
  EXPECT_TRUE(labels.filter(unit.text(slide.norm()))[0].startsWith("screw's slide"));
}

TEST(Trail, leads_from_the_device_pose_to_the_separated_one) {
  MassProperties mass;
  mass.com = Vec3(0.1, -0.2, 0.3);
  const Pose from{Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX())), Vec3(1, 0, 0)};
  const Pose to{Quat(Eigen::AngleAxisd(1.1, Vec3::UnitX())), Vec3(1, 2, 0)};
  EXPECT_NEAR((on_the_way(mass, from, to, 0).p - from.p).norm(), 0, 1e-12);
  EXPECT_NEAR((on_the_way(mass, from, to, 1).p - to.p).norm(), 0, 1e-12);
  const Pose half = on_the_way(mass, from, to, 0.5);
  const Vec3 centre = half * mass.com;
  EXPECT_NEAR((centre - 0.5 * (from * mass.com + to * mass.com)).norm(), 0, 1e-12);
}

TEST(Format, lengths_read_well) {
  EXPECT_EQ(LengthUnit(0.05).text(0.0012346), QStringLiteral("1.235 mm"));
  EXPECT_EQ(LengthUnit(5).name(), QStringLiteral("m"));
  EXPECT_EQ(LengthUnit(1e-4).name(), QStringLiteral("µm"));
  EXPECT_EQ(number(12.345), QStringLiteral("12.3"));
  EXPECT_EQ(number(0.012345), QStringLiteral("0.0123"));
  EXPECT_EQ(round_down_125(0.037), 0.02);
  EXPECT_EQ(round_down_125(5), 5);
}

}  // namespace
}  // namespace sonde::ui
