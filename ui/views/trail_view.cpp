// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/trail_view.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double span = 4;  // s
constexpr float width = 2;  // pixels

}  // namespace

TrailView::TrailView(vtkRenderer& renderer)
    : renderer_(&renderer), hand_(line_in(colour::probe)), held_(line_in(colour::ghost)) {}

TrailView::~TrailView() {
  renderer_->RemoveActor(hand_.actor);
  renderer_->RemoveActor(held_.actor);
}

TrailView::Line TrailView::line_in(const QColor& colour) {
  Line line{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkActor>::New()};
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(line.path);
  line.actor->SetMapper(mapper);
  line.actor->PickableOff();
  line.actor->VisibilityOff();
  vtkProperty* property = line.actor->GetProperty();
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  property->LightingOff();
  renderer_->AddActor(line.actor);
  return line;
}

void TrailView::draw(const Frame& frame) {
  const Snapshot& now = frame.snapshot;
  // A time that falls is a new run.
  if (!places_.empty() && now.time < places_.back().time) places_.clear();
  places_.push_back({now.time, now.separation.device * frame.mass.com,
                     now.separation.separated * frame.mass.com});
  while (places_.front().time < now.time - span) places_.pop_front();
  for (const Line& line : {hand_, held_})
    line.actor->GetProperty()->SetLineWidth(width * frame.density);
  show_line(hand_, &Place::hand);
  show_line(held_, &Place::held);
}

void TrailView::show_line(const Line& line, Vec3 Place::*where) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(places_.size()));
  for (const Place& place : places_)
    cells->InsertCellPoint(points->InsertNextPoint((place.*where).data()));
  line.path->SetPoints(points);
  line.path->SetLines(cells);
  line.actor->SetVisibility(places_.size() > 1);
}

void TrailView::hide() {
  places_.clear();  // what was not watched is not drawn later
  hand_.actor->VisibilityOff();
  held_.actor->VisibilityOff();
}

}  // namespace sonde::ui
