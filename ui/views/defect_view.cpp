// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/defect_view.hpp"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/theme.hpp"
#include "ui/views/glyphs.hpp"

namespace sonde::ui {
namespace {

constexpr float hole_width = 2, flipped_width = 5;

}  // namespace

DefectView::DefectView(vtkRenderer& renderer, const DrawnBodies& drawn) : renderer_(&renderer) {
  const auto both = [&](const DefectLines& lines) {
    return std::array{lines_on_body(renderer, *lines.holes, colour::hole),
                      lines_on_body(renderer, *lines.flipped, colour::flipped)};
  };
  probe_ = both(drawn.probe_defects);
  fixed_ = both(drawn.fixed_defects);
}

DefectView::~DefectView() {
  for (const auto& actors : {probe_, fixed_})
    for (const auto& actor : actors) renderer_->RemoveActor(actor);
}

void DefectView::set_cut(vtkPlane* probe, vtkPlane* fixed) {
  const auto cut = [](const auto& actors, vtkPlane* plane) {
    for (const auto& actor : actors) {
      actor->GetMapper()->RemoveAllClippingPlanes();
      if (plane) actor->GetMapper()->AddClippingPlane(plane);
    }
  };
  cut(probe_, probe);
  cut(fixed_, fixed);
}

void DefectView::draw(const Frame& frame) {
  for (const auto& actors : {probe_, fixed_}) {
    actors[0]->GetProperty()->SetLineWidth(hole_width * frame.density);
    actors[1]->GetProperty()->SetLineWidth(flipped_width * frame.density);
  }
  for (const auto& actor : probe_) {
    place(*actor, frame.snapshot.separation.device);
    actor->VisibilityOn();
  }
  for (const auto& actor : fixed_) actor->VisibilityOn();
}

void DefectView::hide() {
  for (const auto& actors : {probe_, fixed_})
    for (const auto& actor : actors) actor->VisibilityOff();
}

}  // namespace sonde::ui
