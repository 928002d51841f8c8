// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/crossing_view.hpp"

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
#include "ui/views/glyphs.hpp"

namespace sonde::ui {

CrossingView::CrossingView(vtkRenderer& renderer, bool of_probe)
    : renderer_(&renderer),
      data_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()),
      of_probe_(of_probe) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  // They lie on the body: it hides those behind it, and not those in front.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -8);
  actor_->SetMapper(mapper);
  const QColor fill = colour::crossing, edge = fill.darker(260);
  vtkProperty& property = *actor_->GetProperty();
  property.SetColor(fill.redF(), fill.greenF(), fill.blueF());
  property.EdgeVisibilityOn();
  property.SetEdgeColor(edge.redF(), edge.greenF(), edge.blueF());
  property.LightingOff();
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

CrossingView::~CrossingView() { renderer_->RemoveActor(actor_); }

void CrossingView::set(const Soup& soup, std::span<const std::uint32_t> triangles) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::uint32_t t : triangles) {
    vtkIdType corners[3];
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = points->InsertNextPoint(soup.vertices[soup.triangles[t][k]].data());
    cells->InsertNextCell(3, corners);
  }
  data_->SetPoints(points);
  data_->SetPolys(cells);
  data_->Modified();
}

void CrossingView::set_cut(vtkPlane* plane) {
  actor_->GetMapper()->RemoveAllClippingPlanes();
  if (plane) actor_->GetMapper()->AddClippingPlane(plane);
}

void CrossingView::draw(const Frame& frame) {
  if (of_probe_) place(*actor_, frame.snapshot.separation.device);
  actor_->SetVisibility(data_->GetNumberOfPolys() > 0);
}

void CrossingView::hide() { actor_->VisibilityOff(); }

}  // namespace sonde::ui
