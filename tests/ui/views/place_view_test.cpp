// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/place_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// A place of 20 mm at (0.1, 0, 0) m whose outward is x.
PointedPlace wide_place(bool on_probe) {
  return {.on_probe = on_probe,
          .at = {0.1, 0, 0},
          .outward = Vec3::UnitX(),
          .size = 0.02,
          .text = "opening closed"};
}

class PlaceViewTest : public testing::Test {
 protected:
  Eigen::AlignedBox3d ring() {
    const auto seen = stage.seen();
    EXPECT_EQ(seen.size(), 1u);
    return seen.empty() ? Eigen::AlignedBox3d() : bounds_of(*seen[0]);
  }
  Stage stage;
  PlaceView view{*stage.renderer};
};

TEST_F(PlaceViewTest, a_ring_lies_round_the_place_square_to_its_outward) {
  view.set(wide_place(false));
  view.show(stage.frame());
  const Eigen::AlignedBox3d box = ring();
  EXPECT_NEAR((box.center() - Vec3(0.1, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(box.sizes().x(), 0, 1e-6);
  EXPECT_GT(box.sizes().y(), 2 * 0.02) << "the place is within it";
  EXPECT_NEAR(box.sizes().y(), box.sizes().z(), 1e-6);
  ASSERT_EQ(texts_of(view), QStringList{"opening closed"});
  const Vec3 aside = view.labels()[0].at - Vec3(0.1, 0, 0);
  EXPECT_NEAR(aside.norm(), box.sizes().y() / 2, 1e-6) << "on the ring, not on the place";
}

/// The probe's x is the fixed body's z.
TEST_F(PlaceViewTest, of_the_probe_it_goes_where_the_probe_is) {
  stage.snapshot.separation.device = {Quat(Eigen::AngleAxisd(-std::acos(0.0), Vec3::UnitY())),
                                      Vec3(0, 0, 1)};
  view.set(wide_place(true));
  view.show(stage.frame());
  EXPECT_NEAR((ring().center() - Vec3(0, 0, 1.1)).norm(), 0, 1e-6);
  EXPECT_NEAR(ring().sizes().z(), 0, 1e-6);
  view.set(wide_place(false));
  view.show(stage.frame());
  EXPECT_NEAR((ring().center() - Vec3(0.1, 0, 0)).norm(), 0, 1e-6);
}

TEST_F(PlaceViewTest, a_point_has_a_ring_of_one_size_on_screen) {
  PointedPlace point = wide_place(false);
  point.size = 0;
  point.outward = Vec3::Zero();
  view.set(point);
  view.show(stage.frame());
  const double wide = ring().sizes().x();
  EXPECT_GT(wide, 10 * Stage::pixel);
  Frame far = stage.frame();
  far.pixel *= 3;
  view.show(far);
  EXPECT_NEAR(ring().sizes().x(), 3 * wide, 1e-9);
  view.set({});
  view.show(far);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
