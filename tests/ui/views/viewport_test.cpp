// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <algorithm>
#include <ostream>

#include "tests/ui/window_fixture.hpp"
#include "ui/shell/demo.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(WindowTest, vtk_found_its_opengl) {
  EXPECT_STREQ(Viewport::window_class(), "vtkXOpenGLRenderWindow");
}

TEST_F(WindowTest, a_scene_is_drawn) {
  open_cubes();
  const QImage image = picture();
  EXPECT_GT(image.width(), 300);
  EXPECT_GT(lit_share(image), 0.03);
}

TEST_F(WindowTest, the_default_scene_opens) {
  open({QStringLiteral(SONDE_RESOURCES "/scenes/spoon-in-cup.sonde.json")});
  ASSERT_EQ(opened, 1) << (complaints.empty() ? "" : complaints[0].toStdString());
  EXPECT_GT(lit_share(picture()), 0.03);
  EXPECT_GE(window->session()->loaded().trajectory.size(), 2u);
}

struct LayerCase {
  const char* action;
  int least;  ///< pixels that come with it
};

void PrintTo(const LayerCase& layer, std::ostream* out) { *out << layer.action; }

class LayerTest : public WindowTest, public ::testing::WithParamInterface<LayerCase> {};

TEST_P(LayerTest, is_drawn_and_can_be_hidden) {
  open_cubes();
  settle();
  auto* action = window->findChild<QAction*>(GetParam().action);
  ASSERT_TRUE(action);
  ASSERT_TRUE(action->isChecked());
  window->viewport().camera().zoom(1.3);  // the arrow is small beside the legend and the hint
  // A still picture: nothing else may differ between the two.
  window->set_paused(true);
  settle();
  const QImage with = picture();
  action->trigger();
  EXPECT_FALSE(action->isChecked());
  const QImage without = picture();
  EXPECT_GT(pixels_between(with, without), GetParam().least);
  action->trigger();
  EXPECT_LT(pixels_between(with, picture()), 20);
}

INSTANTIATE_TEST_SUITE_P(Layers, LayerTest,
                         ::testing::Values(LayerCase{"show_ghost", 500},
                                           LayerCase{"show_screw", 40},
                                           LayerCase{"show_contacts", 40},
                                           LayerCase{"show_wrench", 100}),
                         [](const auto& info) { return std::string(info.param.action); });

/// Where the cubes overlap by 10 mm, held and nearest are one: a turn of the held pose's colour
/// into that of the way shows that it is drawn.
TEST_F(WindowTest, the_ways_out_are_drawn_by_a_key) {
  open_cubes();
  ASSERT_TRUE(wait_until([this] {
    return window->searched() && window->searched()->nearest && window->searched()->pdt;
  }));
  window->set_paused(true);
  settle();
  const QImage without = picture();
  for (const char* name : {"show_nearest", "show_straight"}) {
    auto* action = window->findChild<QAction*>(name);
    ASSERT_TRUE(action);
    EXPECT_FALSE(action->shortcut().isEmpty());
    EXPECT_FALSE(action->isChecked());
    action->trigger();
    EXPECT_GT(pixels_between(without, picture()), 500) << name;
    action->trigger();
    EXPECT_LT(pixels_between(without, picture()), 20) << name;
  }
}

TEST_F(WindowTest, the_witness_of_the_bound_is_drawn_by_a_key) {
  open_cubes();
  ASSERT_TRUE(wait_until([this] { return window->searched() && window->searched()->witness; }));
  window->set_paused(true);
  settle();
  const QImage without = picture();
  auto* action = window->findChild<QAction*>("show_bound");
  ASSERT_TRUE(action);
  action->trigger();
  EXPECT_GT(pixels_between(without, picture()), 60);
  action->trigger();
  EXPECT_LT(pixels_between(without, picture()), 20);
}

/// The face at +x is half open: from there its edges are seen, from behind the body hides them.
TEST_F(WindowTest, a_body_hides_the_defects_behind_it) {
  const auto file = folder.write("hole.sonde.json", R"({"unit": "mm",
      "probe": {"mesh": "large.off", "pose": [0, 0, 500, 1, 0, 0, 0]},
      "fixed": {"mesh": "open.off", "pose": [0, 0, 0, 1, 0, 0, 0]}})");
  open({QString::fromStdString(file.string())});
  window->set_paused(true);
  window->viewport().set_shown(Layer::hint, false);
  const auto drawn_from = [this](const Vec3& side) {
    window->viewport().camera().look_at(Vec3(0.05, 0.05, 0.05), side, Vec3::UnitZ(), 0.5);
    window->viewport().set_shown(Layer::defects, false);
    const QImage without = picture();
    window->viewport().set_shown(Layer::defects, true);
    return pixels_between(without, picture());
  };
  EXPECT_GT(drawn_from(Vec3::UnitX()), 100);
  EXPECT_LT(drawn_from(-Vec3::UnitX()), 30);
}

TEST_F(WindowTest, the_hint_says_how_and_can_be_hidden) {
  open_cubes();
  window->set_paused(true);
  settle();
  auto* action = window->findChild<QAction*>("show_hint");
  ASSERT_TRUE(action);
  const QImage with = window->viewport().grab().toImage();
  action->trigger();
  settle();
  EXPECT_GT(pixels_between(with, window->viewport().grab().toImage()), 1000);
}

/// Every vertex, by the projection that places labels: in one of the areas that the texts leave.
TEST_F(WindowTest, a_fitted_picture_has_no_text_over_the_bodies) {
  open({QStringLiteral(SONDE_RESOURCES "/scenes/spoon-in-cup.sonde.json")});
  settle();
  for (const bool hint : {true, false}) {
    window->viewport().set_shown(Layer::hint, hint);
    act("fit");
    QRectF drawn;
    const auto add = [&](const Body& body, const Pose& pose) {
      for (const Vec3& vertex : body.soup.vertices)
        drawn |= QRectF(window->viewport().on_screen(pose * vertex), QSizeF(1e-3, 1e-3));
    };
    add(window->session()->fixed(), Pose{});
    add(window->session()->probe(), window->session()->device_pose());
    const auto areas =
        static_cast<HintView*>(window->findChild<QWidget*>("hint_view"))->clear_areas();
    EXPECT_TRUE(std::any_of(areas.begin(), areas.end(),
                            [&](const QRectF& area) { return area.contains(drawn); }));
    EXPECT_GT(drawn.height(), 150) << "as large as there is room";
  }
}

/// Points one behind the other are at one place on screen, and a metre has one size at any depth.
TEST_F(WindowTest, parallel_lines_stay_parallel_when_asked) {
  open_cubes();
  Viewport& view = window->viewport();
  const Vec3 target = view.camera().target();
  const Vec3 towards = view.camera().axes().towards, aside = 0.05 * view.camera().axes().right;
  const double scale = view.metres_per_pixel(target), before = view.camera().distance();
  const auto apart = [&] {
    const QPointF off = view.on_screen(target + aside + 0.1 * towards) -
                        view.on_screen(target + aside - 0.1 * towards);
    return std::hypot(off.x(), off.y());
  };
  EXPECT_GT(apart(), 2);
  act("parallel");
  picture();
  EXPECT_LT(apart(), 1e-6);
  EXPECT_NEAR(view.metres_per_pixel(target) / scale, 1, 1e-9) << "what is looked at keeps its size";
  EXPECT_EQ(view.metres_per_pixel(target + 0.1 * towards), view.metres_per_pixel(target));
  // A click finds what is under it, and the wheel zooms.
  const auto hit = view.pick(view.on_screen(com()));
  ASSERT_TRUE(hit);
  const Vec3 there = view.pose_of(hit->on_probe) * hit->x;
  const QPointF off = view.on_screen(there) - view.on_screen(com());
  EXPECT_LT(std::hypot(off.x(), off.y()), 0.1);
  const QImage whole = picture();
  const QColor background = whole.pixelColor(0, whole.height() / 2);
  view.camera().zoom(50);
  EXPECT_NEAR(view.metres_per_pixel(target) * 50 / scale, 1, 1e-9);
  const QImage near = picture();
  const QColor middle = near.pixelColor(near.width() / 2, near.height() / 2);
  EXPECT_GT(std::abs(middle.red() - background.red()) + std::abs(middle.blue() - background.blue()),
            24)
      << "the eye steps back: nothing is cut off in front";
  view.camera().zoom(0.02);
  act("parallel");
  EXPECT_NEAR(view.camera().distance(), before, 1e-9);
  EXPECT_NEAR(view.metres_per_pixel(target) / scale, 1, 1e-9);
}

TEST_F(WindowTest, the_ghost_swings) {
  open_cubes();
  // Until the force has come in, its arrow grows.
  ASSERT_TRUE(wait_until([this] { return shown().hand.share >= 1; }));
  wait(200);
  const std::size_t still = window->frames();
  wait(200);
  EXPECT_LE(window->frames(), still + 2) << "drawn although nothing changed";
  act("swing");
  EXPECT_TRUE(wait_until([&] { return window->frames() > still + 8; }));
}

TEST_F(WindowTest, a_picture_has_docks_and_overlays) {
  open_cubes();
  ASSERT_TRUE(window->save_picture(path("picture.png")));
  const QImage image(path("picture.png"));
  EXPECT_EQ(image.size(), window->size() * window->devicePixelRatio());
  EXPECT_GT(lit_share(image), 0.05);
}

TEST_F(WindowTest, a_picture_that_cannot_be_written_is_a_message) {
  open_cubes();
  EXPECT_FALSE(window->save_picture(path("no/such/folder.png")));
  EXPECT_EQ(complaints.size(), 1u);
}

}  // namespace
}  // namespace sonde::ui::test
