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

}  // namespace
}  // namespace sonde::ui
