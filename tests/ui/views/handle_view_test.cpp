// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/handle_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

constexpr double arrow_length = HandleView::pixels * Stage::pixel;

/// The probe is turned so that its x is the fixed body's y; its centre of mass is at (0, 1, 0).
class HandleViewTest : public testing::Test {
 protected:
  void SetUp() override {
    stage.mass.com = Vec3(1, 0, 0);
    stage.snapshot.separation.device.q = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
  }
  Vec3 tip(std::size_t i) const { return view.labels().at(i).at; }
  Stage stage;
  HandleView view{*stage.renderer, stage.shapes};
};

TEST_F(HandleViewTest, three_arrows_with_names_lead_from_the_centre_of_mass) {
  view.show(stage.frame());
  EXPECT_EQ(texts_of(view), QStringList({"x", "y", "z"}));
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR((tip(std::size_t(i)) - Vec3(0, 1, 0) - arrow_length * Vec3::Unit(i)).norm(), 0,
                1e-12);
  EXPECT_EQ(stage.seen().size(), 12u) << "three arrows and three rings, with heads";
  for (vtkActor* actor : stage.seen()) {
    const Eigen::AlignedBox3d box = bounds_of(*actor);
    EXPECT_LT((box.center() - Vec3(0, 1, 0)).norm(), 1.1 * arrow_length);
  }
}

TEST_F(HandleViewTest, along_the_probes_own_axes_they_turn_with_it) {
  view.set_local(true);
  view.show(stage.frame());
  EXPECT_NEAR((tip(0) - Vec3(0, 1 + arrow_length, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((tip(1) - Vec3(-arrow_length, 1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((tip(2) - Vec3(0, 1, arrow_length)).norm(), 0, 1e-12);
}

TEST_F(HandleViewTest, are_of_one_size_on_screen_and_gone_where_they_are_not_wanted) {
  Frame far = stage.frame();
  far.pixel *= 10;
  view.show(far);
  EXPECT_NEAR(tip(2).z(), 10 * arrow_length, 1e-12);
  view.set_visible(false);
  view.show(far);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
