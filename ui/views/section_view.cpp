// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/section_view.hpp"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <utility>

#include "engine/geometry/transform.hpp"
#include "ui/document/same_pose.hpp"
#include "ui/views/section.hpp"

namespace sonde::ui {
namespace {

constexpr int section_shade = 220;  // QColor's: 200 is half as bright
constexpr double section_line = 2;  // pixels

void colour_cells(vtkPolyData& surface, const QColor& colour) {
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(surface.GetNumberOfCells());
  const int channels[] = {colour.red(), colour.green(), colour.blue()};
  for (int i = 0; i < 3; ++i) colours->FillComponent(i, channels[i]);
  surface.GetCellData()->SetScalars(colours);
}

/// In the fixed body's frame.
void place_in_scene(vtkPolyData& surface, const Pose& X_FB) {
  const Transform X(X_FB);
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    Vec3 x;
    surface.GetPoint(i, x.data());
    x = X * x;
    surface.GetPoints()->SetPoint(i, x.data());
  }
}

vtkSmartPointer<vtkActor> flat_actor(vtkRenderer& renderer, int order) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(vtkNew<vtkPolyData>());
  mapper->SetScalarModeToUseCellData();
  // All of them lie in one plane: those of a higher order come before the others.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -4.0 * order);
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4.0 * order);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(section_line);
  actor->PickableOff();
  actor->VisibilityOff();
  renderer.AddActor(actor);
  return actor;
}

}  // namespace

SectionView::Drawn SectionView::drawn_of(vtkRenderer& renderer, int order) {
  return {flat_actor(renderer, order), flat_actor(renderer, order + 2)};
}

SectionView::SectionView(vtkRenderer& renderer)
    : renderer_(&renderer), fixed_(drawn_of(renderer, 1)), probe_(drawn_of(renderer, 2)) {}

SectionView::~SectionView() {
  for (const Drawn& drawn : {fixed_, probe_})
    for (const auto& actor : {drawn.faces, drawn.lines}) renderer_->RemoveActor(actor);
}

std::vector<const vtkActor*> SectionView::actors() const {
  return {fixed_.faces, fixed_.lines, probe_.faces, probe_.lines};
}

void SectionView::set_fixed(std::vector<CutBody> fixed) {
  of_fixed_ = std::move(fixed);
  fixed_.stale = true;
}

void SectionView::set_probe(std::optional<CutBody> probe) {
  of_probe_.clear();
  if (probe) of_probe_.push_back(std::move(*probe));
  probe_.stale = true;
}

void SectionView::fill(Drawn& drawn, const std::vector<CutBody>& bodies, const CutPlane& cut) {
  vtkNew<vtkAppendPolyData> faces, lines;
  for (const CutBody& each : bodies) {
    const Pose X_BF = inverse(each.X_FB);
    const SectionFace section = section_of(each.body->soup, X_BF * cut.point, X_BF.q * cut.normal);
    if (section.outline->GetNumberOfCells() == 0) continue;
    place_in_scene(*section.outline, each.X_FB);
    // The filled surface may share the outline's points, or have its own.
    if (section.filled->GetPoints() && section.filled->GetPoints() != section.outline->GetPoints())
      place_in_scene(*section.filled, each.X_FB);
    colour_cells(*section.outline, each.colour.darker(section_shade));
    lines->AddInputData(section.outline);
    if (!each.body->solid || section.filled->GetNumberOfCells() == 0) continue;
    colour_cells(*section.filled, each.colour);
    faces->AddInputData(section.filled);
  }
  for (const auto& [actor, all] :
       {std::pair{drawn.faces, faces.Get()}, std::pair{drawn.lines, lines.Get()}}) {
    const bool any = all->GetNumberOfInputConnections(0) > 0;
    actor->SetVisibility(any);
    if (!any) continue;
    all->Update();
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(all->GetOutput());
  }
}

void SectionView::show(const CutPlane& cut, const Pose& device) {
  const bool moved = !cut_.on || cut.point != cut_.point || cut.normal != cut_.normal;
  cut_ = cut;
  if (!cut.on) {
    for (const Drawn& drawn : {fixed_, probe_})
      for (const auto& actor : {drawn.faces, drawn.lines}) actor->VisibilityOff();
    return;
  }
  if (std::exchange(fixed_.stale, false) || moved) fill(fixed_, of_fixed_, cut);
  const bool probe_moved = !of_probe_.empty() && !same(of_probe_.front().X_FB, device);
  if (probe_moved) of_probe_.front().X_FB = device;
  if (std::exchange(probe_.stale, false) || moved || probe_moved) fill(probe_, of_probe_, cut);
}

}  // namespace sonde::ui
