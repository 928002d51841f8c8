// SPDX-License-Identifier: GPL-3.0-or-later
// References: the counts of triangles and edges of a cube and a ball.
#include "ui/views/drawn_bodies.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <utility>

#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui::test {
namespace {

/// A cube, triangulated: 12 triangles.
PolygonSoup cube_soup(double side) {
  return sonde::test::triangulated(sonde::test::box({side, side, side}));
}

std::shared_ptr<const Body> as_in_file(const PolygonSoup& soup) {
  return make_body(soup, Model::automatic, "mesh", {}, Repair::none);
}

LoadedScene loaded_of(const std::shared_ptr<const Body>& probe,
                      const std::shared_ptr<const Body>& fixed) {
  LoadedScene out{.pair = Pair(probe, fixed)};
  out.start.p = Vec3(0, 0, 3);
  return out;
}

TEST(DrawnBodies, begin_as_the_scene_does) {
  LoadedScene loaded = loaded_of(as_in_file(cube_soup(1)), as_in_file(cube_soup(2)));
  loaded.scene.fixed.pose.q = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
  loaded.coupling.max_force = 7;
  DrawnBodies drawn = draw_bodies(loaded);
  EXPECT_EQ(drawn.first.p, Vec3(0, 0, 3));
  EXPECT_NEAR((drawn.q_FW * loaded.scene.fixed.pose.q).angularDistance(Quat::Identity()), 0, 1e-9);
  EXPECT_EQ(drawn.coupling.max_force, 7);
  EXPECT_FALSE(drawn.camera.has_value());
  loaded.here = Pose{Quat::Identity(), {1, 0, 0}};
  EXPECT_EQ(draw_bodies(loaded).first.p, Vec3(1, 0, 0)) << "where the probe was left";
}

TEST(DrawnBodies, a_sound_mesh_is_drawn_whole_and_has_no_defects) {
  const DrawnBodies drawn =
      draw_bodies(loaded_of(as_in_file(cube_soup(1)), as_in_file(cube_soup(2))));
  EXPECT_EQ(drawn.probe_surface->GetNumberOfPolys(), 12);
  double bounds[6];
  drawn.fixed_surface->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 1, 1e-6);
  for (const DefectLines* lines : {&drawn.probe_defects, &drawn.fixed_defects}) {
    EXPECT_EQ(lines->holes->GetNumberOfLines(), 0);
    EXPECT_EQ(lines->flipped->GetNumberOfLines(), 0);
  }
  EXPECT_FALSE(drawn.probe_caps.faces);
}

TEST(DrawnBodies, a_missing_triangle_leaves_three_open_edges_and_a_turned_one_three_flipped) {
  PolygonSoup open = cube_soup(1), turned = cube_soup(1);
  open.polygons.pop_back();
  std::swap(turned.polygons[0][1], turned.polygons[0][2]);
  const DrawnBodies drawn = draw_bodies(loaded_of(as_in_file(open), as_in_file(turned)));
  EXPECT_EQ(drawn.probe_defects.holes->GetNumberOfLines(), 3);
  EXPECT_EQ(drawn.probe_defects.flipped->GetNumberOfLines(), 0);
  EXPECT_EQ(drawn.fixed_defects.holes->GetNumberOfLines(), 0);
  EXPECT_EQ(drawn.fixed_defects.flipped->GetNumberOfLines(), 3);
}

/// Of a ball without the four triangles into which one was divided: they have six sides together,
/// and four triangles close those. Where two of them meet is no seam.
TEST(DrawnBodies, what_closes_an_opening_is_drawn_with_the_lines_where_it_meets_the_mesh) {
  PolygonSoup ball = sonde::test::icosphere(0.05, 2);
  ball.polygons.resize(ball.polygons.size() - 4);
  const DrawnBodies drawn =
      draw_bodies(loaded_of(sonde::test::body(ball), as_in_file(cube_soup(1))));
  ASSERT_TRUE(drawn.probe_caps.faces && drawn.probe_caps.seams);
  EXPECT_EQ(drawn.probe_caps.faces->GetNumberOfPolys(), 4);
  EXPECT_EQ(drawn.probe_caps.seams->GetNumberOfLines(), 6);
  EXPECT_FALSE(drawn.fixed_caps.faces);
}

TEST(DrawnBodies, of_several_parts_those_that_are_shown_are_drawn) {
  const auto cube = as_in_file(cube_soup(1));
  LoadedScene loaded = loaded_of(cube, cube);
  loaded.parts = {{"a", cube, {}}, {"b", cube, {Quat::Identity(), {0, 0, 5}}}, {"c", cube, {}}};
  loaded.scene.fixed.parts.resize(3);
  loaded.scene.fixed.parts[2].shown = false;
  const DrawnBodies drawn = draw_bodies(loaded);
  EXPECT_EQ(drawn.fixed_surface->GetNumberOfPolys(), 24);
  EXPECT_EQ(drawn.parts.size(), 3u);
  ASSERT_EQ(drawn.part_looks.size(), 3u);
  EXPECT_FALSE(drawn.part_looks[2].shown);
  EXPECT_EQ(drawn.part_surface.first_cell.back(), 36) << "hidden ones can be shown later";
}

}  // namespace
}  // namespace sonde::ui::test
