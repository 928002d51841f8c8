// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport finds under the cursor.

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// Seen from x, both bodies beside each other.
class ViewportSeeingTest : public ViewportAloneTest {
 protected:
  void SetUp() override {
    ViewportAloneTest::SetUp();
    if (!HasFatalFailure()) look_from(Vec3(1, 0, 0));
  }
};

TEST_F(ViewportSeeingTest, a_point_is_of_the_body_under_it_with_its_face_and_its_edge) {
  const Vec3 on_fixed(0.05, 0.045, 0.01), on_probe(0.02, 0, 0.12);
  const auto fixed = pick_at(on_fixed);
  ASSERT_TRUE(fixed);
  EXPECT_FALSE(fixed->on_probe);
  EXPECT_NEAR((fixed->x - on_fixed).norm(), 0, 1e-6);
  EXPECT_NEAR((fixed->normal - Vec3::UnitX()).norm(), 0, 1e-9);
  EXPECT_NEAR(std::abs(fixed->edge.z()), 1, 1e-9) << "the nearest side runs along z";
  EXPECT_NEAR(fixed->on_edge.y(), 0.05, 1e-9);
  const auto probe = pick_at(on_probe);
  ASSERT_TRUE(probe);
  EXPECT_TRUE(probe->on_probe);
  EXPECT_NEAR((probe->x - Vec3(0.02, 0, 0)).norm(), 0, 1e-6) << "in the probe's own frame";
  EXPECT_FALSE(pick_at(Vec3(0, 0.2, 0))) << "there is nothing";
}

TEST_F(ViewportSeeingTest, what_is_hidden_or_cut_away_is_not_found) {
  Seeing seeing;
  seeing.probe = Look::hidden;
  view->set_seeing(seeing);
  EXPECT_FALSE(pick_at(Vec3(0.02, 0, 0.12)));
  seeing.cut.on = true;
  seeing.cut.normal = Vec3::UnitX();  // the half at the eye's side
  view->set_seeing(seeing);
  const auto behind = pick_at(Vec3(0.05, 0, 0));
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->x.x(), -0.05, 1e-6) << "the inside of the face at the back";
  EXPECT_NEAR((behind->normal - Vec3::UnitX()).norm(), 0, 1e-9) << "to the eye's side";
  seeing.cut.normal = -Vec3::UnitX();
  view->set_seeing(seeing);
  ASSERT_TRUE(pick_at(Vec3(0.05, 0, 0)));
  EXPECT_NEAR(pick_at(Vec3(0.05, 0, 0))->x.x(), 0.05, 1e-6);
}

TEST_F(ViewportSeeingTest, the_cut_has_handles_where_it_is_drawn) {
  EXPECT_FALSE(view->cut_handles());
  Seeing seeing;
  seeing.cut.on = true;
  seeing.cut.point = Vec3(0, 0.01, 0);
  view->set_seeing(seeing);
  ASSERT_TRUE(view->cut_handles());
  EXPECT_EQ(view->cut_handles()->centre, Vec3(0, 0.01, 0));
  view->set_shown(Layer::cut, false);
  EXPECT_FALSE(view->cut_handles()) << "it cuts, and is not drawn";
}

/// A ball of 2.5 times the place's size fills the picture's height, out of where the place faces.
TEST_F(ViewportSeeingTest, a_place_is_looked_at_from_where_it_faces) {
  const PointedPlace place{
      .on_probe = true, .at = {0, 0, 0.02}, .outward = Vec3::UnitY(), .size = 0.01, .text = "here"};
  const CameraPlace before = view->before(place);
  EXPECT_NEAR((before.target - Vec3(0, 0, 0.14)).norm(), 0, 1e-12);
  const Vec3 back = before.position - before.target;
  EXPECT_NEAR((back.normalized() - Vec3::UnitY()).norm(), 0, 1e-12);
  EXPECT_EQ(before.up, Vec3::UnitZ());
  view->look(before);
  const QPointF middle = view->on_screen(before.target);
  const double high = view->on_screen(before.target - Vec3(0, 0, 0.01)).y() - middle.y();
  EXPECT_GT(high, 60);
  EXPECT_LT(high, 240 / 2.0) << "with some of the body around it";
}

}  // namespace
}  // namespace sonde::ui::test
