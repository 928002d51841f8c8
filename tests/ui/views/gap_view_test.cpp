// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/gap_view.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// The lightness of CIE L*a*b*, out of its definition.
double lightness_of(const QColor& colour) {
  const auto linear = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
                   0.0722 * linear(colour.blueF());
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

/// A triangle whose corners are at gaps of 0, 1 and 4 mm.
GapField three_gaps() {
  GapField out;
  out.patch.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  out.patch.triangles = {{0, 1, 2}};
  out.gaps = {0, 0.001, 0.004};
  return out;
}

TEST(GapView, colours_fall_in_lightness_so_that_no_hue_is_needed) {
  double before = 101;
  for (int i = 0; i <= 50; ++i) {
    const double now = lightness_of(gap_colour(i / 50.0));
    EXPECT_LT(now, before) << i;
    before = now;
  }
  EXPECT_GT(gap_colour(0).red(), 200) << "yellow at a touch";
  EXPECT_LT(gap_colour(0).blue(), 80);
  EXPECT_EQ(gap_colour(-3), gap_colour(0));
  EXPECT_EQ(gap_colour(7), gap_colour(1));
}

TEST(GapView, each_corner_has_the_colour_of_its_gap_where_the_body_is) {
  Stage stage;
  GapView view(*stage.renderer);
  view.set(three_gaps(), {Quat::Identity(), {0, 0, 5}}, 0.002);
  view.show(stage.frame());
  ASSERT_EQ(stage.seen().size(), 1u);
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR((box.min() - Vec3(0, 0, 5)).norm(), 0, 1e-6);
  EXPECT_NEAR((box.max() - Vec3(1, 1, 5)).norm(), 0, 1e-6);
  vtkDataArray* colours =
      stage.seen()[0]->GetMapper()->GetInputAsDataSet()->GetPointData()->GetScalars();
  ASSERT_TRUE(colours);
  const std::array<QColor, 3> wanted{gap_colour(0), gap_colour(0.5), gap_colour(1)};
  for (std::size_t i = 0; i < 3; ++i) {
    const double* rgb = colours->GetTuple(vtkIdType(i));
    EXPECT_EQ(QColor(int(rgb[0]), int(rgb[1]), int(rgb[2])).rgb(), wanted[i].rgb()) << i;
  }
}

TEST(GapView, an_empty_field_paints_nothing) {
  Stage stage;
  GapView view(*stage.renderer);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  view.set(three_gaps(), {}, 0.002);
  view.show(stage.frame());
  EXPECT_EQ(stage.seen().size(), 1u);
  view.clear();
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

}  // namespace
}  // namespace sonde::ui::test
