// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/crossing_view.hpp"

#include <gtest/gtest.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// Two triangles, of which the second lies at z = 1.
Soup two_triangles() {
  Soup out;
  out.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {0, 2, 1}};
  out.triangles = {{0, 1, 2}, {3, 4, 5}};
  return out;
}

TEST(CrossingView, draws_the_triangles_that_cross_and_no_others) {
  Stage stage;
  CrossingView view(*stage.renderer, false);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty()) << "there are none";
  const std::vector<std::uint32_t> second{1};
  view.set(two_triangles(), second);
  stage.snapshot.separation.device.p = Vec3(5, 5, 5);
  view.show(stage.frame());
  ASSERT_EQ(stage.seen().size(), 1u);
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR((box.min() - Vec3(0, 0, 1)).norm(), 0, 1e-6) << "of the fixed body they stay";
  EXPECT_NEAR((box.max() - Vec3(2, 2, 1)).norm(), 0, 1e-6);
  view.set(two_triangles(), {});
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

TEST(CrossingView, of_the_probe_they_move_with_it) {
  Stage stage;
  CrossingView view(*stage.renderer, true);
  const std::vector<std::uint32_t> first{0};
  view.set(two_triangles(), first);
  // x becomes y, y becomes −x.
  stage.snapshot.separation.device = {Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ())),
                                      Vec3(5, 0, 0)};
  view.show(stage.frame());
  ASSERT_EQ(stage.seen().size(), 1u);
  const Eigen::AlignedBox3d box = bounds_of(*stage.seen()[0]);
  EXPECT_NEAR((box.min() - Vec3(4, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((box.max() - Vec3(5, 1, 0)).norm(), 0, 1e-6);
  view.set_visible(false);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

TEST(CrossingView, is_cut_with_its_body) {
  Stage stage;
  CrossingView view(*stage.renderer, false);
  const std::vector<std::uint32_t> first{0};
  view.set(two_triangles(), first);
  view.show(stage.frame());
  vtkMapper& mapper = *stage.seen().at(0)->GetMapper();
  vtkNew<vtkPlane> plane;
  for (int i = 0; i < 2; ++i) view.set_cut(plane);
  ASSERT_TRUE(mapper.GetClippingPlanes());
  EXPECT_EQ(mapper.GetClippingPlanes()->GetNumberOfItems(), 1);
  EXPECT_EQ(mapper.GetClippingPlanes()->GetItem(0), plane);
  view.set_cut(nullptr);
  EXPECT_TRUE(!mapper.GetClippingPlanes() || mapper.GetClippingPlanes()->GetNumberOfItems() == 0);
}

}  // namespace
}  // namespace sonde::ui::test
