// SPDX-License-Identifier: GPL-3.0-or-later
// References: the sections of cubes are squares.
#include "ui/views/section_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"
#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// A cube of 2 m at the origin as the fixed body and one of 1 m at (1, 0, 0) as the probe.
class SectionViewTest : public testing::Test {
 protected:
  void SetUp() override {
    cut.on = true;
    cut.normal = Vec3::UnitZ();
    cut.point = Vec3(9, 9, 0.25);  // any point of the plane
    view.set_fixed({{large.get(), {}, Qt::blue}});
    view.set_probe(CutBody{small.get(), device, Qt::red});
  }
  Stage stage;
  const std::shared_ptr<const Body> large = sonde::test::body(sonde::test::box({2, 2, 2}));
  const std::shared_ptr<const Body> small = sonde::test::body(sonde::test::box({1, 1, 1}));
  const Pose device{Quat::Identity(), {1, 0, 0}};
  CutPlane cut;
  SectionView view{*stage.renderer};
};

TEST_F(SectionViewTest, the_sections_of_both_lie_in_the_plane) {
  view.show(cut, device);
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 4u) << "of each the faces and the outline";
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR((bounds_of(*seen[i]).min() - Vec3(-1, -1, 0.25)).norm(), 0, 1e-5);
    EXPECT_NEAR((bounds_of(*seen[i]).max() - Vec3(1, 1, 0.25)).norm(), 0, 1e-5);
  }
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_NEAR((bounds_of(*seen[i]).min() - Vec3(0.5, -0.5, 0.25)).norm(), 0, 1e-5);
    EXPECT_NEAR((bounds_of(*seen[i]).max() - Vec3(1.5, 0.5, 0.25)).norm(), 0, 1e-5);
  }
}

TEST_F(SectionViewTest, follows_the_probe_and_the_plane) {
  view.show(cut, device);
  view.show(cut, {Quat::Identity(), {1, 2, 0}});
  ASSERT_EQ(stage.seen().size(), 4u);
  EXPECT_NEAR((bounds_of(*stage.seen()[2]).center() - Vec3(1, 2, 0.25)).norm(), 0, 1e-5);
  cut.point.z() = 0.75;  // above the probe
  view.show(cut, {Quat::Identity(), {1, 2, 0}});
  ASSERT_EQ(stage.seen().size(), 2u);
  EXPECT_NEAR(bounds_of(*stage.seen()[0]).center().z(), 0.75, 1e-5);
  cut.on = false;
  view.show(cut, device);
  EXPECT_TRUE(stage.seen().empty());
  cut.on = true;
  cut.point.z() = 0.25;
  view.show(cut, device);
  EXPECT_EQ(stage.seen().size(), 4u) << "on again";
}

TEST_F(SectionViewTest, what_is_not_cut_has_no_section_and_a_surface_is_not_filled) {
  view.set_probe({});
  view.show(cut, device);
  EXPECT_EQ(stage.seen().size(), 2u);
  PolygonSoup open = sonde::test::box({2, 2, 2});
  open.polygons.pop_back();
  const auto sheet = sonde::test::body(open, Model::surface);
  ASSERT_FALSE(sheet->solid);
  view.set_fixed({{sheet.get(), {}, Qt::blue}});
  view.show(cut, device);
  EXPECT_EQ(stage.seen().size(), 1u) << "an outline alone";
  view.set_fixed({});
  view.show(cut, device);
  EXPECT_TRUE(stage.seen().empty());
}

}  // namespace
}  // namespace sonde::ui::test
