// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cap_view.hpp"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/theme.hpp"
#include "ui/views/body_look.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/probe_view.hpp"

namespace sonde::ui {
namespace {

constexpr double see_through = 0.6;  // opacity on what is translucent itself, of another colour
constexpr int seam_shade = 260;      // QColor's: 200 is half as bright
constexpr float seam_width = 2;      // pixels

}  // namespace

CapView::Drawn CapView::drawn_of(vtkRenderer& renderer, const CapSurface& caps, bool solid) {
  const vtkSmartPointer<vtkPolyData> none = vtkSmartPointer<vtkPolyData>::New();
  Drawn drawn;
  drawn.there = caps.faces != nullptr;
  drawn.solid = solid;
  drawn.faces = body_actor(renderer, drawn.there ? *caps.faces : *none, colour::cap, solid);
  // The body has the same triangles there: these come before them, and the lines before these.
  drawn.faces->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  drawn.faces->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -4);
  drawn.seams =
      lines_on_body(renderer, drawn.there ? *caps.seams : *none, colour::cap.darker(seam_shade));
  return drawn;
}

CapView::CapView(vtkRenderer& renderer, const DrawnBodies& drawn) : renderer_(&renderer) {
  const bool probe_solid = drawn.pair->probe().solid, fixed_solid = drawn.pair->fixed().solid;
  probe_ = drawn_of(renderer, drawn.probe_caps, probe_solid);
  fixed_ = drawn_of(renderer, drawn.fixed_caps, fixed_solid);
  ghost_ = drawn_of(renderer, drawn.probe_caps, probe_solid);
  // As the ghost itself: where it and the probe all but coincide, the probe is what one sees.
  ghost_.faces->GetProperty()->SetOpacity(see_through);
  ghost_.faces->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  ghost_.seams->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(2, 1);
}

CapView::~CapView() {
  for (const Drawn& drawn : {probe_, fixed_, ghost_})
    for (const auto& actor : {drawn.faces, drawn.seams}) renderer_->RemoveActor(actor);
}

bool CapView::any() const { return probe_.there || fixed_.there; }

std::array<const vtkActor*, 3> CapView::faces() const {
  return {probe_.faces, fixed_.faces, ghost_.faces};
}

void CapView::set_seeing(const Seeing& seeing, vtkPlane* cut_probe, vtkPlane* cut_fixed) {
  const auto apply = [](Drawn& drawn, Look look, vtkPlane* cut) {
    drawn.shown = look != Look::hidden;
    apply_look(*drawn.faces, look, colour::cap, drawn.solid, cut);
    if (look == Look::xray) drawn.faces->GetProperty()->SetOpacity(see_through);
    drawn.seams->GetMapper()->RemoveAllClippingPlanes();
    if (cut) drawn.seams->GetMapper()->AddClippingPlane(cut);
  };
  apply(probe_, seeing.probe, cut_probe);
  apply(fixed_, seeing.fixed, cut_fixed);
}

void CapView::set_visible(const Drawn& drawn, bool visible) {
  drawn.faces->SetVisibility(visible && drawn.there);
  drawn.seams->SetVisibility(visible && drawn.there);
}

void CapView::draw(const Frame& frame) {
  const Separation& separation = frame.snapshot.separation;
  const bool apart = separation.status == Status::penetrating;
  for (const Drawn& drawn : {probe_, fixed_, ghost_})
    drawn.seams->GetProperty()->SetLineWidth(seam_width * frame.density);
  for (const auto& actor : {probe_.faces, probe_.seams}) place(*actor, separation.device);
  if (apart)
    for (const auto& actor : {ghost_.faces, ghost_.seams})
      place(*actor, on_the_way(frame.mass, separation.device, separation.separated, frame.swing));
  set_visible(probe_, probe_.shown);
  set_visible(fixed_, fixed_.shown);
  set_visible(ghost_, ghost_shown_ && apart);
}

void CapView::hide() {
  for (const Drawn& drawn : {probe_, fixed_, ghost_}) set_visible(drawn, false);
}

}  // namespace sonde::ui
