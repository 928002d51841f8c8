// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/body_look.hpp"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace sonde::ui::test {
namespace {

const QColor bronze(200, 140, 60);

class BodyLookTest : public testing::Test {
 protected:
  void SetUp() override { actor->SetMapper(mapper); }
  int planes() {
    vtkPlaneCollection* all = mapper->GetClippingPlanes();
    return all ? all->GetNumberOfItems() : 0;
  }
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPlane> plane;
};

TEST_F(BodyLookTest, each_look_is_seen_or_seen_through_in_its_way) {
  apply_look(*actor, Look::opaque, bronze, true, nullptr);
  vtkProperty& property = *actor->GetProperty();
  EXPECT_TRUE(actor->GetVisibility());
  EXPECT_EQ(property.GetOpacity(), 1);
  EXPECT_EQ(property.GetRepresentation(), VTK_SURFACE);
  apply_look(*actor, Look::xray, bronze, true, nullptr);
  EXPECT_GT(property.GetOpacity(), 0.1);
  EXPECT_LT(property.GetOpacity(), 0.6);
  apply_look(*actor, Look::wireframe, bronze, true, nullptr);
  EXPECT_EQ(property.GetRepresentation(), VTK_WIREFRAME);
  EXPECT_EQ(property.GetOpacity(), 1);
  apply_look(*actor, Look::hidden, bronze, true, nullptr);
  EXPECT_FALSE(actor->GetVisibility());
  apply_look(*actor, Look::opaque, bronze, true, nullptr);
  EXPECT_TRUE(actor->GetVisibility());
  EXPECT_EQ(property.GetRepresentation(), VTK_SURFACE);
}

/// Culling is free of charge only where no back face can be seen.
TEST_F(BodyLookTest, back_faces_are_left_out_where_none_can_be_seen) {
  const auto culls = [&](Look look, bool solid, vtkPlane* cut) {
    apply_look(*actor, look, bronze, solid, cut);
    return bool(actor->GetProperty()->GetBackfaceCulling());
  };
  EXPECT_TRUE(culls(Look::opaque, true, nullptr));
  EXPECT_TRUE(culls(Look::xray, true, nullptr));
  EXPECT_FALSE(culls(Look::opaque, false, nullptr)) << "a surface has two sides";
  EXPECT_FALSE(culls(Look::wireframe, true, nullptr));
  EXPECT_FALSE(culls(Look::opaque, true, plane)) << "the inside shows";
}

TEST_F(BodyLookTest, a_cut_shows_the_inside_in_a_darker_colour_that_no_light_changes) {
  for (int i = 0; i < 3; ++i) apply_look(*actor, Look::opaque, bronze, true, plane);
  EXPECT_EQ(planes(), 1) << "the same one, however often";
  vtkProperty* inside = actor->GetBackfaceProperty();
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->GetAmbient(), 1);
  EXPECT_EQ(inside->GetDiffuse(), 0);
  const double* rgb = inside->GetColor();
  EXPECT_EQ(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]).rgb(), cut_colour(bronze).rgb());
  EXPECT_LT(cut_colour(bronze).value(), 0.6 * bronze.value());
  EXPECT_NEAR(cut_colour(bronze).hsvHue(), bronze.hsvHue(), 1);
  apply_look(*actor, Look::xray, bronze, true, plane);
  EXPECT_FALSE(actor->GetBackfaceProperty()) << "nothing is filled that is seen through";
  EXPECT_EQ(planes(), 1);
  apply_look(*actor, Look::opaque, bronze, true, nullptr);
  EXPECT_EQ(planes(), 0);
  EXPECT_FALSE(actor->GetBackfaceProperty());
}

}  // namespace
}  // namespace sonde::ui::test
