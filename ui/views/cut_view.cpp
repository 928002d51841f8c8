// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cut_view.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/theme.hpp"
#include "ui/views/handle_view.hpp"

namespace sonde::ui {
namespace {

constexpr float outline_width = 1.5F;  // pixels
constexpr double arrow_pixels = 2.2;
constexpr double cut_ring_pixels = 1.1;

}  // namespace

Mat3 axes_of_plane(const Vec3& normal) {
  const Vec3 side = any_normal(normal);
  Mat3 axes;
  axes << side, normal.cross(side), normal;
  return axes;
}

CutView::CutView(vtkRenderer& renderer, GlyphShapes& shapes)
    : renderer_(&renderer),
      plane_(vtkSmartPointer<vtkPlane>::New()),
      square_(vtkSmartPointer<vtkPolyData>::New()),
      outline_(vtkSmartPointer<vtkActor>::New()),
      arrow_(renderer, shapes, colour::cut),
      rings_{Arc(renderer, shapes, colour::cut), Arc(renderer, shapes, colour::cut)} {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1, 2, 3, 0});
  square_->SetPoints(points);
  square_->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(square_);
  outline_->SetMapper(mapper);
  outline_->GetProperty()->SetColor(colour::cut.redF(), colour::cut.greenF(), colour::cut.blueF());
  outline_->GetProperty()->LightingOff();
  outline_->VisibilityOff();
  renderer.AddActor(outline_);
}

CutView::~CutView() { renderer_->RemoveActor(outline_); }

void CutView::set(const CutPlane& cut, double size) {
  cut_ = cut;
  const Vec3 drawn = -cut.normal;
  plane_->SetOrigin(Vec3(cut.point).data());
  plane_->SetNormal(Vec3(drawn).data());
  const Mat3 axes = axes_of_plane(cut.normal);
  const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 4; ++i) {
    const Vec3 corner = cut.point + size * (signs[i][0] * axes.col(0) + signs[i][1] * axes.col(1));
    square_->GetPoints()->SetPoint(i, corner.data());
  }
  square_->GetPoints()->Modified();
  square_->Modified();
}

vtkPlane& CutView::plane() { return *plane_; }

Handles CutView::handles(double length) const {
  return {cut_.point, axes_of_plane(cut_.normal), length};
}

void CutView::draw(const Frame& frame) {
  if (!cut_.on) return hide();
  const Handles held = handles(HandleView::pixels * frame.pixel);
  outline_->GetProperty()->SetLineWidth(outline_width * frame.density);
  outline_->VisibilityOn();
  const Vec3 tip = held.centre + cut_.normal * held.length;
  arrow_.set(held.centre, tip, arrow_pixels * frame.pixel);
  for (Eigen::Index i = 0; i < 2; ++i)
    rings_.at(static_cast<std::size_t>(i))
        .set(held.centre, held.axes.col(i), held.axes.col((i + 1) % 3) * held.length * ring_part,
             ring_angle, cut_ring_pixels * frame.pixel);
  label(tip, QStringLiteral("cut away"), colour::cut, {held.centre, tip});
}

void CutView::hide() {
  outline_->VisibilityOff();
  arrow_.hide();
  for (Arc& ring : rings_) ring.hide();
}

}  // namespace sonde::ui
