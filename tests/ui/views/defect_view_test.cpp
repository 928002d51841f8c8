// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/defect_view.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "tests/ui/views/stage.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

vtkSmartPointer<vtkPolyData> line_to(const Vec3& end) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(end.data());
  lines->InsertNextCell({0, 1});
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(points);
  out->SetLines(lines);
  return out;
}

/// The probe has a hole along x and the fixed body one along y; where faces are flipped, along z.
class DefectViewTest : public testing::Test {
 protected:
  DefectViewTest() {
    drawn.probe_defects = {line_to({1, 0, 0}), line_to({0, 0, 1})};
    drawn.fixed_defects = {line_to({0, 1, 0}), line_to({0, 0, 2})};
    view = std::make_unique<DefectView>(*stage.renderer, drawn);
  }
  Stage stage;
  DrawnBodies drawn;
  std::unique_ptr<DefectView> view;
};

TEST_F(DefectViewTest, edges_of_the_probe_move_with_it_and_those_of_the_fixed_body_stay) {
  EXPECT_TRUE(stage.seen().empty());
  stage.snapshot.separation.device.p = Vec3(5, 0, 0);
  view->show(stage.frame());
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 4u);
  EXPECT_NEAR((bounds_of(*seen[0]).max() - Vec3(6, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((bounds_of(*seen[1]).max() - Vec3(5, 0, 1)).norm(), 0, 1e-6);
  EXPECT_NEAR((bounds_of(*seen[2]).max() - Vec3(0, 1, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((bounds_of(*seen[3]).max() - Vec3(0, 0, 2)).norm(), 0, 1e-6);
  view->set_visible(false);
  view->show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

TEST_F(DefectViewTest, flipped_faces_differ_from_holes_in_colour_and_in_width) {
  view->show(stage.frame());
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 4u);
  for (const std::size_t hole : {0u, 2u}) {
    EXPECT_EQ(colour_of(*seen[hole]).rgb(), colour::hole.rgb());
    EXPECT_EQ(colour_of(*seen[hole + 1]).rgb(), colour::flipped.rgb());
    EXPECT_GE(seen[hole + 1]->GetProperty()->GetLineWidth(),
              2 * seen[hole]->GetProperty()->GetLineWidth());
  }
  const float before = seen[0]->GetProperty()->GetLineWidth();
  Frame dense = stage.frame();
  dense.density = 3;
  view->show(dense);
  EXPECT_EQ(seen[0]->GetProperty()->GetLineWidth(), 3 * before) << "as wide on any screen";
}

TEST_F(DefectViewTest, each_body_is_cut_by_itself) {
  view->show(stage.frame());
  const auto planes = [&](std::size_t line) {
    vtkPlaneCollection* all = stage.seen().at(line)->GetMapper()->GetClippingPlanes();
    return all ? all->GetNumberOfItems() : 0;
  };
  vtkNew<vtkPlane> plane;
  for (int i = 0; i < 2; ++i) view->set_cut(nullptr, plane);
  EXPECT_EQ(planes(0) + planes(1), 0);
  EXPECT_EQ(planes(2), 1);
  EXPECT_EQ(planes(3), 1);
  view->set_cut(plane, nullptr);
  EXPECT_EQ(planes(0), 1);
  EXPECT_EQ(planes(2), 0);
}

TEST_F(DefectViewTest, what_goes_leaves_nothing_behind) {
  EXPECT_EQ(stage.renderer->GetActors()->GetNumberOfItems(), 4);
  view.reset();
  EXPECT_EQ(stage.renderer->GetActors()->GetNumberOfItems(), 0);
}

}  // namespace
}  // namespace sonde::ui::test
