// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cap_view.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <QAction>
#include <cmath>

#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/defects.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/session.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

constexpr double radius = 0.05;

/// Both bodies look alike from above: a ball, or one with an opening at its top.
class CapTest : public WindowTest {
 protected:
  void open_balls(bool open_ones, double apart, const char* look = nullptr) {
    const PolygonSoup ball = sonde::test::icosphere(radius, 3);
    const PolygonSoup mesh =
        open_ones ? sonde::test::without(
                        ball, [](const Vec3& x) { return (x - Vec3(0, 0, radius)).norm() < 0.009; })
                  : ball;
    folder.write("ball.off", sonde::test::as_off(mesh));
    const auto file = folder.write("balls.sonde.json",
                                   R"({"unit": "m", "probe": {"mesh": "ball.off", "pose": [)" +
                                       std::to_string(apart) +
                                       R"(, 0, 0, 1, 0, 0, 0]}, "fixed": {"mesh": "ball.off"}})");
    open({QString::fromStdString(file.string())});
    ASSERT_EQ(failed, 0);
    for (const Layer layer : {Layer::screw, Layer::contacts, Layer::wrench})
      window->viewport().set_shown(layer, false);
    act("from_above");
    window->set_paused(true);
    settle();
    if (look) act(look);
  }
  static bool is_cap(const QColor& pixel) {
    return std::abs(pixel.hsvHue() - colour::cap.hsvHue()) < 20 && pixel.hsvSaturation() > 50 &&
           pixel.value() > 50;
  }
  /// Left (the fixed body's half) and right of the middle between the bodies.
  std::pair<int, int> cap_pixels(double apart) {
    const QImage image = picture();
    const double middle = window->viewport().on_screen(Vec3(apart / 2, 0, 0)).x();
    std::pair<int, int> count;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (is_cap(image.pixelColor(x, y))) ++(x < middle ? count.first : count.second);
    return count;
  }
};

TEST_F(CapTest, caps_have_their_colour_on_both_bodies_and_a_sound_body_has_none) {
  open_balls(true, 0.15);
  ASSERT_FALSE(window->session()->fixed().caps.triangles.empty());
  const auto [fixed, probe] = cap_pixels(0.15);
  EXPECT_GT(fixed, 300);
  EXPECT_GT(probe, 300);
  EXPECT_LT(std::abs(fixed - probe), 0.5 * fixed);
  act("show_mended");
  EXPECT_EQ(cap_pixels(0.15), std::pair(0, 0));
  act("show_mended");
  EXPECT_EQ(cap_pixels(0.15).first, fixed);
  open_balls(false, 0.15);
  EXPECT_EQ(cap_pixels(0.15), std::pair(0, 0));
}

TEST_F(CapTest, the_edge_of_a_closed_opening_is_seen) {
  open_balls(true, 0.15);
  const QImage image = picture();
  const Soup& caps = window->session()->fixed().caps;
  int dark = 0, all = 0;
  for (const Vec3& corner : caps.vertices) {
    const QPoint at = window->viewport().on_screen(corner).toPoint();
    int darkest = 255;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        darkest = std::min(darkest, image.pixelColor(at + QPoint(dx, dy)).value());
    dark += darkest < 130;
    ++all;
  }
  EXPECT_GT(dark, all / 2);
}

TEST_F(CapTest, caps_are_seen_on_bodies_that_are_seen_through_and_not_on_hidden_ones) {
  open_balls(true, 0.15, "xray_fixed");
  EXPECT_GT(cap_pixels(0.15).first, 200);
  act("hide_fixed");
  EXPECT_EQ(cap_pixels(0.15).first, 0);
  act("xray_probe");
  EXPECT_GT(cap_pixels(0.15).second, 200);
  act("hide_probe");
  EXPECT_EQ(cap_pixels(0.15).second, 0);
}

TEST_F(CapTest, and_on_the_ghost) {
  open_balls(true, 0.07);
  ASSERT_TRUE(wait_until([this] { return shown().separation.status == Status::penetrating; }));
  settle();
  act("hide_probe");
  act("hide_fixed");
  EXPECT_GT(cap_pixels(0).second, 100);
  act("show_ghost");
  EXPECT_EQ(cap_pixels(0).second, 0);
}

}  // namespace
}  // namespace sonde::ui::test
