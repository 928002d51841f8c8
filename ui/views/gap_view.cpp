// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/gap_view.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/views/glyphs.hpp"

namespace sonde::ui {

QColor gap_colour(double part) {
  // Viridis, from its light end.
  static const std::array<QColor, 5> stops{QColor(253, 231, 37), QColor(94, 201, 98),
                                           QColor(33, 145, 140), QColor(59, 82, 139),
                                           QColor(68, 1, 84)};
  const double at = std::clamp(part, 0.0, 1.0) * double(stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double share = at - double(low);
  const auto mixed = [share](double a, double b) { return (1 - share) * a + share * b; };
  const QColor &a = stops.at(low), &b = stops.at(low + 1);
  return QColor::fromRgbF(mixed(a.redF(), b.redF()), mixed(a.greenF(), b.greenF()),
                          mixed(a.blueF(), b.blueF()));
}

GapView::GapView(vtkRenderer& renderer)
    : renderer_(&renderer),
      patch_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(patch_);
  // It lies on the body, and is to be seen rather than that.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -4);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetAmbient(0.7);  // its colours are to be read beside the legend
  actor_->GetProperty()->SetDiffuse(0.3);
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

GapView::~GapView() { renderer_->RemoveActor(actor_); }

void GapView::set(const GapField& field, const Pose& X_FB, double reach) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < field.gaps.size(); ++i) {
    points->InsertNextPoint(field.patch.vertices[i].data());
    const QColor colour = gap_colour(reach > 0 ? field.gaps[i] / reach : 0);
    colours->InsertNextTuple3(colour.red(), colour.green(), colour.blue());
  }
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : field.patch.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  patch_->SetPoints(points);
  patch_->SetPolys(cells);
  patch_->GetPointData()->SetScalars(colours);
  place(*actor_, X_FB);
}

void GapView::set_cut(vtkPlane* cut) {
  actor_->GetMapper()->RemoveAllClippingPlanes();
  if (cut) actor_->GetMapper()->AddClippingPlane(cut);
}

void GapView::draw(const Frame& /*frame*/) {
  actor_->SetVisibility(patch_->GetNumberOfCells() > 0);
}

void GapView::hide() { actor_->VisibilityOff(); }

}  // namespace sonde::ui
