// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/grid_view.hpp"

#include <gtest/gtest.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>

#include <cmath>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// 100 × 60 × 30 mm, its lowest place at z = 20 mm.
const Eigen::AlignedBox3d slab(Vec3(0.013, 0, 0.02), Vec3(0.113, 0.06, 0.05));

class GridViewTest : public testing::Test {
 protected:
  vtkDataSet& lines() { return *stage.seen().at(0)->GetMapper()->GetInputAsDataSet(); }
  Stage stage;
  GridView view{*stage.renderer};
};

TEST_F(GridViewTest, lies_under_the_body_and_further_than_it_at_a_round_spacing) {
  view.show(stage.frame());
  view.set(slab, Quat::Identity());
  view.show(stage.frame());
  EXPECT_DOUBLE_EQ(view.spacing(), 0.01) << "15 mm, rounded down to 1, 2 or 5";
  ASSERT_EQ(stage.seen().size(), 1u);
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR(box.min().z(), 0.02, 1e-7);
  EXPECT_NEAR(box.max().z(), 0.02, 1e-7);
  EXPECT_LT(box.min().x(), slab.min().x());
  EXPECT_GT(box.max().y(), slab.max().y());
  view.set_visible(false);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

TEST_F(GridViewTest, its_lines_lie_at_whole_multiples_of_the_spacing) {
  view.set(slab, Quat::Identity());
  view.show(stage.frame());
  ASSERT_GT(lines().GetNumberOfPoints(), 20);
  for (vtkIdType i = 0; i < lines().GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const double part = lines().GetPoint(i)[axis] / view.spacing();
      EXPECT_NEAR(part, std::round(part), 1e-4) << i;
    }
}

/// The scene's up is the fixed body's x: its lowest place is at x = 13 mm.
TEST_F(GridViewTest, the_ground_is_square_to_the_scenes_up) {
  view.set(slab, Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitX()));
  view.show(stage.frame());
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen().at(0));
  EXPECT_NEAR(box.min().x(), 0.013, 1e-7);
  EXPECT_NEAR(box.max().x(), 0.013, 1e-7);
  EXPECT_GT(box.sizes().z(), 0.03);
  EXPECT_DOUBLE_EQ(view.spacing(), 0.005) << "of 60 mm: 9, rounded down";
}

}  // namespace
}  // namespace sonde::ui::test
