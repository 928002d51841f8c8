// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of any size, drawn beside the window's own.

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

using ViewportPictureTest = ViewportAloneTest;

TEST_F(ViewportPictureTest, has_the_size_that_is_wanted_and_leaves_the_window_as_it_is) {
  const QImage before = view->picture();
  const CameraPlace place = view->place();
  const QImage large = view->picture(now, {.size = {900, 500}});
  EXPECT_EQ(large.size(), QSize(900, 500));
  EXPECT_EQ(view->picture(now, {.size = {70, 200}}).size(), QSize(70, 200));
  EXPECT_EQ(view->place().position, place.position);
  EXPECT_LT(pixels_between(before, view->picture()), 20);
}

TEST_F(ViewportPictureTest, without_a_background_there_are_the_bodies_alone) {
  const PictureOptions options{.size = {640, 480}, .transparent = true, .overlays = false};
  const QImage image = view->picture(now, options);
  ASSERT_FALSE(image.isNull());
  EXPECT_EQ(image.pixelColor(0, 0).alpha(), 0);
  const QPoint probe = view->on_screen(Vec3(0, 0, 0.12)).toPoint();
  EXPECT_EQ(image.pixelColor(probe).alpha(), 255);
  EXPECT_GT(image.pixelColor(probe).red(), image.pixelColor(probe).blue()) << "it is orange";
  const QImage opaque = view->picture(now, {.size = {640, 480}, .overlays = false});
  EXPECT_EQ(opaque.pixelColor(0, 0).alpha(), 255);
}

TEST_F(ViewportPictureTest, overlays_are_in_it_where_they_are_wanted) {
  now.snapshot.wrench.force = Vec3(0, 0, 5);
  now.snapshot.hand.share = 1;
  const QImage with = view->picture(now, {.size = {640, 480}});
  const QImage without = view->picture(now, {.size = {640, 480}, .overlays = false});
  EXPECT_GT(pixels_between(with, without), 1000) << "legend, ruler and the force";
  EXPECT_TRUE(view->shown(Layer::wrench)) << "the window's own are as before";
}

TEST_F(ViewportPictureTest, there_is_none_without_room_or_bodies) {
  EXPECT_TRUE(view->picture(now, {.size = {0, 100}}).isNull());
  EXPECT_TRUE(view->picture(now, {.size = {100, Viewport::largest_picture + 1}}).isNull());
  Viewport empty;
  EXPECT_TRUE(empty.picture(now, {.size = {100, 100}}).isNull());
}

}  // namespace
}  // namespace sonde::ui::test
