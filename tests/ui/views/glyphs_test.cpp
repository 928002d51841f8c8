// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/glyphs.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <numbers>

#include "tests/support/shapes.hpp"
#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

TEST(Glyphs, a_normal_is_a_unit_vector_square_to_any_axis) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis =
        i < 3 ? Vec3(Vec3::Unit(i)) : Vec3(sonde::test::random_in_ball(random, 1).normalized());
    EXPECT_NEAR(any_normal(axis).norm(), 1, 1e-12);
    EXPECT_NEAR(any_normal(axis).dot(axis), 0, 1e-12);
  }
}

TEST(Glyphs, a_ball_has_its_centre_its_radius_and_its_colour) {
  Stage stage;
  Ball ball(*stage.renderer, stage.shapes, QColor(10, 200, 30));
  EXPECT_TRUE(stage.seen().empty()) << "hidden at first";
  ball.set({1, 2, 3}, 0.5);
  ASSERT_EQ(stage.seen().size(), 1u);
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR((box.center() - Vec3(1, 2, 3)).norm(), 0, 1e-6);
  EXPECT_NEAR(box.sizes().z(), 1, 1e-6);
  EXPECT_EQ(colour_of(*stage.seen()[0]).rgb(), QColor(10, 200, 30).rgb());
  ball.hide();
  EXPECT_TRUE(stage.seen().empty());
}

/// Along z, where bounds are sharp. A head is three times as wide as its shaft.
TEST(Glyphs, an_arrow_begins_and_ends_where_it_should_with_its_head_at_the_end) {
  Stage stage;
  Arrow arrow(*stage.renderer, stage.shapes, Qt::red);
  arrow.set({1, 0, 0}, {1, 0, 2}, 0.01);
  ASSERT_EQ(stage.seen().size(), 2u);
  const Eigen::AlignedBox3d shaft = bounds_of(*stage.seen()[0]), head = bounds_of(*stage.seen()[1]);
  EXPECT_NEAR(shaft.min().z(), 0, 1e-6);
  EXPECT_NEAR(shaft.max().z(), head.min().z(), 1e-6) << "without a gap";
  EXPECT_NEAR(head.max().z(), 2, 1e-6);
  EXPECT_NEAR(shaft.sizes().x(), 0.02, 1e-6);
  EXPECT_NEAR(head.sizes().x(), 0.06, 1e-6);
  arrow.set({1, 0, 0}, {1, 0, -2}, 0.01);
  EXPECT_NEAR(bounds_of(*stage.seen()[1]).min().z(), -2, 1e-6) << "it points to its end";
}

TEST(Glyphs, a_short_arrow_keeps_a_shaft_and_one_of_no_length_is_none) {
  Stage stage;
  Arrow arrow(*stage.renderer, stage.shapes, Qt::red);
  arrow.set({0, 0, 0}, {0, 0, 0.01}, 0.01);
  ASSERT_EQ(stage.seen().size(), 2u);
  EXPECT_NEAR(bounds_of(*stage.seen()[1]).max().z(), 0.01, 1e-9);
  EXPECT_GT(bounds_of(*stage.seen()[0]).sizes().z(), 0.003);
  arrow.set({0, 0, 0}, {0, 0, 0.01}, 0.001, false);
  ASSERT_EQ(stage.seen().size(), 1u) << "a rod";
  EXPECT_NEAR(bounds_of(*stage.seen()[0]).sizes().z(), 0.01, 1e-9);
  arrow.set({0, 0, 0}, {0, 0, 0}, 0.01);
  EXPECT_TRUE(stage.seen().empty());
}

/// Half a turn about z, from (1, 0, 0) over (0, 1, 0) to (−1, 0, 0).
TEST(Glyphs, an_arc_goes_round_its_axis_as_far_as_its_angle) {
  const std::vector<Vec3> points =
      arc_points(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), std::numbers::pi);
  EXPECT_NEAR((points.front() - Vec3::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((points[points.size() / 2] - Vec3::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR((points.back() + Vec3::UnitX()).norm(), 0, 1e-12);
  Stage stage;
  Arc arc(*stage.renderer, stage.shapes, Qt::red);
  arc.set(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), std::numbers::pi, 0.01);
  ASSERT_EQ(stage.seen().size(), 2u) << "a tube and a head";
  Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR(box.max().x(), 1.01, 2e-3);
  EXPECT_NEAR(box.max().y(), 1.01, 2e-3);
  EXPECT_GT(box.min().y(), -0.02) << "no more than half of it";
  EXPECT_NEAR(box.sizes().z(), 0.02, 2e-3);
  arc.set(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), 0, 0.01);
  EXPECT_TRUE(stage.seen().empty());
}

TEST(Glyphs, lines_on_a_body_are_hidden_until_they_are_shown) {
  Stage stage;
  vtkNew<vtkPolyData> none;
  const auto lines = lines_on_body(*stage.renderer, *none, Qt::blue);
  EXPECT_TRUE(stage.seen().empty());
  lines->VisibilityOn();
  EXPECT_EQ(stage.seen(), std::vector<vtkActor*>{lines});
  EXPECT_FALSE(lines->GetProperty()->GetLighting());
}

}  // namespace
}  // namespace sonde::ui::test
