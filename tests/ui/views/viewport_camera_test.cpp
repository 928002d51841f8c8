// SPDX-License-Identifier: GPL-3.0-or-later
// Where a Viewport looks from, and where what it shows is on the screen.

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

using ViewportCameraTest = ViewportAloneTest;

TEST_F(ViewportCameraTest, a_pixel_aside_is_a_pixel_on_the_screen) {
  look_from(Vec3(0.3, -0.4, 0.2));
  const QPointF middle = view->on_screen(Vec3::Zero());
  EXPECT_TRUE(view->rect().contains(middle.toPoint())) << "what is looked at";
  const ViewAxes axes = view->camera().axes();
  const double pixel = view->metres_per_pixel(Vec3::Zero());
  const QPointF right = view->on_screen(50 * pixel * axes.right) - middle;
  EXPECT_NEAR(right.x(), 50, 1e-6);
  EXPECT_NEAR(right.y(), 0, 1e-6);
  const QPointF up = view->on_screen(50 * pixel * axes.up) - middle;
  EXPECT_NEAR(up.x(), 0, 1e-6);
  EXPECT_NEAR(up.y(), -50, 1e-6) << "less is higher in Qt";
  EXPECT_GT(view->metres_per_pixel(-0.1 * axes.towards), pixel) << "what is further is smaller";
}

TEST_F(ViewportCameraTest, a_place_to_look_from_is_kept) {
  const CameraPlace wanted{.position = {0.1, 0.5, 0.2}, .target = {0.1, 0, 0.2}, .up = {0, 0, 1}};
  view->look(wanted);
  const CameraPlace place = view->place();
  EXPECT_NEAR((place.position - wanted.position).norm(), 0, 1e-12);
  EXPECT_NEAR((place.target - wanted.target).norm(), 0, 1e-12);
  EXPECT_NEAR((place.up - wanted.up).norm(), 0, 1e-12);
  EXPECT_TRUE(view->dirty()) << "another picture";
}

TEST_F(ViewportCameraTest, whatever_was_looked_at_a_fitted_picture_shows_both_bodies_whole) {
  const Vec3 at_hand(0, -0.3, 0.12), as_held(0, 0.3, 0.12);
  now.snapshot.separation.device.p = at_hand;
  now.snapshot.separation.separated.p = as_held;
  for (const Vec3& side : {Vec3(5, 0, 0), Vec3(0.01, 0.01, 0.01), Vec3(0, 0, -2)}) {
    look_from(side);
    view->fit();
    QRectF drawn;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      for (const Vec3& x :
           {Vec3(0.05 * corner), Vec3(0.02 * corner + at_hand), Vec3(0.02 * corner + as_held)})
        drawn |= QRectF(view->on_screen(x), QSizeF(1e-3, 1e-3));
    }
    EXPECT_TRUE(QRectF(view->rect()).contains(drawn)) << side.transpose();
    EXPECT_GT(std::max(drawn.width(), drawn.height()), 100) << side.transpose();
  }
}

TEST_F(ViewportCameraTest, a_probe_that_is_placed_out_of_the_picture_is_found_again) {
  look_from(Vec3(0.3, -0.4, 0.2));
  view->fit();
  const CameraPlace before = view->place();
  const Pose near{Quat::Identity(), Vec3(0, 0, 0.1)}, away{Quat::Identity(), Vec3(0, 0, 2)};
  view->find_probe(near);
  EXPECT_EQ(view->place().position, before.position) << "it is seen as it is";
  ASSERT_FALSE(view->rect().contains(view->on_screen(away.p).toPoint()));
  view->find_probe(away);
  EXPECT_TRUE(view->rect().contains(view->on_screen(away.p).toPoint()));
  EXPECT_TRUE(view->rect().contains(view->on_screen(Vec3::Zero()).toPoint())) << "and the other";
}

}  // namespace
}  // namespace sonde::ui::test
