// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/gap_field.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

double area(const Soup& soup) {
  double sum = 0;
  for (const Triangle& t : soup.triangles)
    sum += 0.5 * (soup.vertices[t[1]] - soup.vertices[t[0]])
                     .cross(soup.vertices[t[2]] - soup.vertices[t[0]])
                     .norm();
  return sum;
}

/// A cube that hovers 2 mm over a slab: the gap of a point is its height over the slab.
class Hovering : public testing::Test {
 protected:
  std::shared_ptr<const Body> cube = test::body(test::box(Vec3(0.1, 0.1, 0.1)));
  std::shared_ptr<const Body> slab = test::body(test::box(Vec3(1, 1, 0.02)));
  Pose X_OM{Quat::Identity(), Vec3(0, 0, 0.01 + 0.05 + 0.002)};
  GapOptions options{.reach = 0.01, .cell = 0.005};
};

TEST_F(Hovering, gaps_are_heights) {
  const GapField field = gap_field(*cube, *slab, X_OM, options);
  ASSERT_EQ(field.gaps.size(), field.patch.vertices.size());
  for (std::size_t i = 0; i < field.gaps.size(); ++i)
    EXPECT_NEAR(field.gaps[i], (X_OM * field.patch.vertices[i]).z() - 0.01, 1e-9);
}

TEST_F(Hovering, the_patch_is_what_is_near_cut_to_the_cell) {
  const GapField field = gap_field(*cube, *slab, X_OM, options);
  for (const Triangle& t : field.patch.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LE((field.patch.vertices[t.at(i)] - field.patch.vertices[t.at((i + 1) % 3)]).norm(),
                options.cell * (1 + 1e-9));
  // The face below, and of the four beside it the 8 mm that are within reach, to a cell.
  const double least = 0.01 + 4 * 0.1 * 0.008;
  EXPECT_GE(area(field.patch), least - 1e-9);
  EXPECT_LE(area(field.patch), least + 4 * 0.1 * options.cell);
}

TEST_F(Hovering, the_other_body_shows_the_same) {
  const GapField field = gap_field(*slab, *cube, inverse(X_OM), options);
  EXPECT_GT(area(field.patch), 0.01);
  EXPECT_LT(area(field.patch), 0.15 * 0.15);
  EXPECT_LE(field.patch.triangles.size(), 4 * options.most);
}

TEST_F(Hovering, far_away_and_stopped_there_is_nothing) {
  const Pose far{Quat::Identity(), Vec3(0, 0, 1)};
  EXPECT_TRUE(gap_field(*cube, *slab, far, options).patch.triangles.empty());
  // Asked now and then only: fine enough for it to be asked.
  options.cell = 1e-3;
  EXPECT_TRUE(gap_field(*cube, *slab, X_OM, options, [] { return true; }).patch.triangles.empty());
}

}  // namespace
}  // namespace sonde
