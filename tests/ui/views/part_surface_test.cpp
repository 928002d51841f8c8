// SPDX-License-Identifier: GPL-3.0-or-later
// References: the bounds and the counts of two boxes.
#include "ui/views/part_surface.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "engine/scene/scene.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

BodyPart box_at(double side, const Vec3& p) {
  BodyPart part;
  part.body = sonde::test::body(sonde::test::box({side, side, side}));
  part.X_BP.p = p;
  return part;
}

TEST(PartSurface, a_hidden_part_is_not_drawn_and_each_has_its_colour) {
  const PartSurface parts =
      make_part_surface({box_at(0.02, Vec3::Zero()), box_at(0.04, Vec3(0.1, 0, 0))});
  ASSERT_EQ(parts.first_cell.size(), 3u);
  EXPECT_EQ(parts.first_cell[1], 12);
  EXPECT_EQ(parts.first_cell[2], 24);
  const QColor red(200, 10, 20), blue(10, 20, 200);
  auto both = shown_parts(parts, {{red, true}, {blue, true}});
  EXPECT_EQ(both->GetNumberOfPolys(), 24);
  double bounds[6];
  both->ComputeCellsBounds();
  both->GetCellsBounds(bounds);
  EXPECT_NEAR(bounds[0], -0.01, 1e-8);
  EXPECT_NEAR(bounds[1], 0.12, 1e-8);
  double rgb[3];
  both->GetPointData()->GetScalars()->GetTuple(parts.first_point[1], rgb);
  EXPECT_EQ(QColor(int(rgb[0]), int(rgb[1]), int(rgb[2])), blue);
  auto one = shown_parts(parts, {{red, true}, {blue, false}});
  EXPECT_EQ(one->GetNumberOfPolys(), 12);
  one->ComputeCellsBounds();
  one->GetCellsBounds(bounds);
  EXPECT_NEAR(bounds[1], 0.01, 1e-8);
}

TEST(PartSurface, a_part_without_a_colour_takes_one_in_turn_and_the_chosen_one_is_lighter) {
  SceneBody body;
  body.parts.resize(8);
  body.parts[3].colour = "#102030";
  EXPECT_EQ(part_colour(body, 3), QColor("#102030"));
  EXPECT_EQ(part_colour(body, 0), part_colour(body, 6)) << "six colours in turn";
  EXPECT_NE(part_colour(body, 0), part_colour(body, 1));
  const auto looks = looks_of(body, 3);
  EXPECT_GT(looks[3].colour.lightness(), QColor("#102030").lightness());
  EXPECT_EQ(looks[2].colour, part_colour(body, 2));
}

}  // namespace
}  // namespace sonde::ui
