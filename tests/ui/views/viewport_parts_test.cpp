// SPDX-License-Identifier: GPL-3.0-or-later
// A fixed body of several parts in the view.

#include <vtkPolyData.h>

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

using ViewportPartsTest = ViewportAloneTest;

/// Two cubes of 40 mm, 100 mm apart in y.
LoadedScene of_two_parts(LoadedScene scene, const std::shared_ptr<const Body>& cube) {
  scene.parts = {{"left", cube, {Quat::Identity(), {0, -0.05, 0}}},
                 {"right", cube, {Quat::Identity(), {0, 0.05, 0}}}};
  scene.scene.fixed.parts.resize(2);
  return scene;
}

TEST_F(ViewportPartsTest, a_hidden_part_is_neither_drawn_nor_found) {
  const LoadedScene scene = of_two_parts(loaded(), cube(0.04));
  show(scene);
  look_from(Vec3(1, 0, 0));
  const Vec3 on_right(0.02, 0.05, 0);
  ASSERT_TRUE(pick_at(on_right));
  EXPECT_EQ(pick_at(on_right)->part, std::optional<std::size_t>(1));
  EXPECT_EQ(pick_at(Vec3(0.02, -0.05, 0))->part, std::optional<std::size_t>(0));
  std::vector<PartLook> looks = looks_of(scene.scene.fixed);
  looks[1].shown = false;
  const auto surface = view->show_parts(looks);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->GetNumberOfPolys(), 12);
  EXPECT_FALSE(pick_at(on_right));
  EXPECT_TRUE(pick_at(Vec3(0.02, -0.05, 0)));
  EXPECT_EQ(view->show_parts(looks), surface) << "nothing else: the same";
}

TEST_F(ViewportPartsTest, of_one_mesh_there_are_no_looks_of_parts) {
  EXPECT_FALSE(view->show_parts({{Qt::red, true}}));
  EXPECT_TRUE(view->pick(view->on_screen(Vec3::Zero())));
  EXPECT_FALSE(view->pick(view->on_screen(Vec3::Zero()))->part.has_value());
}

TEST_F(ViewportPartsTest, a_box_goes_round_the_chosen_part) {
  show(of_two_parts(loaded(), cube(0.04)));
  for (const Layer layer : {Layer::wrench, Layer::contacts, Layer::screw, Layer::hint})
    view->set_shown(layer, false);
  look_from(Vec3(1, 0.2, 0.1));
  const auto seen = [&](std::optional<std::size_t> part) {
    view->choose_part(part);
    view->draw(now, 1);
    return view->picture();
  };
  const QImage none = seen({}), right = seen(1);
  EXPECT_GT(pixels_between(none, right), 50);
  EXPECT_LT(pixels_between(none, seen(7)), 5) << "there is no such part";
  const double middle = view->on_screen(Vec3::Zero()).x() * view->devicePixelRatioF();
  int left_of_it = 0;
  for (int y = 0; y < none.height(); ++y)
    for (int x = 0; x < int(middle); ++x) left_of_it += none.pixel(x, y) != right.pixel(x, y);
  EXPECT_EQ(left_of_it, 0) << "round the right one alone";
}

}  // namespace
}  // namespace sonde::ui::test
