// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/place_view.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/base/theme.hpp"
#include "ui/views/glyphs.hpp"

namespace sonde::ui {
namespace {

constexpr int ring_segments = 64;
constexpr double ring_room = 1.25;  // of the place's size: the ring is beside it
constexpr double least_ring = 14;   // the ring's radius round a place that is a point
constexpr float ring_width = 2;     // pixels

vtkSmartPointer<vtkPolyData> unit_ring() {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(ring_segments + 1);
  for (int i = 0; i < ring_segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / ring_segments;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), 0);
    lines->InsertCellPoint(i);
  }
  lines->InsertCellPoint(0);
  auto ring = vtkSmartPointer<vtkPolyData>::New();
  ring->SetPoints(points);
  ring->SetLines(lines);
  return ring;
}

}  // namespace

PlaceView::PlaceView(vtkRenderer& renderer)
    : ring_(unit_ring()), actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ring_);
  actor_->SetMapper(mapper);
  vtkProperty& property = *actor_->GetProperty();
  property.SetColor(colour::cap.redF(), colour::cap.greenF(), colour::cap.blueF());
  property.LightingOff();
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

void PlaceView::draw(const Frame& frame) {
  if (!place_) return hide();
  const Pose X_FB = place_->on_probe ? frame.snapshot.separation.device : Pose{};
  const Vec3 axis = place_->outward.norm() > 0 ? place_->outward : Vec3(Vec3::UnitZ());
  const Vec3 at = X_FB * place_->at;
  const Quat turn = X_FB.q * Quat::FromTwoVectors(Vec3::UnitZ(), axis);
  place(*actor_, {turn, at});
  const double radius = std::max(ring_room * place_->size, least_ring * frame.pixel);
  actor_->SetScale(radius);
  actor_->GetProperty()->SetLineWidth(ring_width * frame.density);
  actor_->VisibilityOn();
  label(at + turn * Vec3(0, radius, 0), place_->text, colour::cap);  // not on what it points at
}

void PlaceView::hide() { actor_->VisibilityOff(); }

}  // namespace sonde::ui
