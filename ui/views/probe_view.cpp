// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/probe_view.hpp"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/theme.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {

vtkSmartPointer<vtkActor> body_actor(vtkRenderer& renderer, vtkPolyData& surface,
                                     const QColor& colour, bool solid) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&surface);
  mapper->SetScalarVisibility(has_colours(surface));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  property->SetAmbient(0.12);
  property->SetDiffuse(0.88);
  property->SetSpecular(0.15);
  property->SetSpecularPower(30);
  property->SetBackfaceCulling(solid);
  renderer.AddActor(actor);
  return actor;
}

namespace {

vtkSmartPointer<vtkActor> ghost_actor(vtkRenderer& renderer, vtkPolyData& surface,
                                      const QColor& colour, bool solid) {
  auto actor = body_actor(renderer, surface, colour, solid);
  actor->GetProperty()->SetOpacity(ghost_opacity);
  // Where the ghost and the probe all but coincide, the probe is what one sees.
  actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  return actor;
}

}  // namespace

ProbeView::ProbeView(vtkRenderer& renderer, vtkPolyData& surface, bool solid)
    : renderer_(&renderer), actor_(body_actor(renderer, surface, colour::probe, solid)) {}

ProbeView::~ProbeView() { renderer_->RemoveActor(actor_); }

vtkActor& ProbeView::actor() { return *actor_; }

void ProbeView::draw(const Frame& frame) {
  place(*actor_, frame.snapshot.separation.device);
  actor_->VisibilityOn();
}

void ProbeView::hide() { actor_->VisibilityOff(); }

GhostView::GhostView(vtkRenderer& renderer, vtkPolyData& surface, bool solid)
    : renderer_(&renderer), actor_(ghost_actor(renderer, surface, colour::ghost, solid)) {}

GhostView::~GhostView() { renderer_->RemoveActor(actor_); }

vtkActor& GhostView::actor() { return *actor_; }

void GhostView::draw(const Frame& frame) {
  const Separation& separation = frame.snapshot.separation;
  if (separation.status != Status::penetrating) return hide();
  place(*actor_, on_the_way(frame.mass, separation.device, separation.separated, frame.swing));
  actor_->VisibilityOn();
}

void GhostView::hide() { actor_->VisibilityOff(); }

FoundView::FoundView(vtkRenderer& renderer, vtkPolyData& surface, bool solid, Way way, Shape shape,
                     const QString& name, const QColor& colour)
    : renderer_(&renderer),
      actor_(ghost_actor(renderer, surface, colour, solid)),
      way_(way),
      name_(name),
      colour_(colour) {
  vtkProperty& property = *actor_->GetProperty();
  if (shape == Shape::mesh) {
    const QColor edge = colour.darker(150);
    property.EdgeVisibilityOn();
    property.SetEdgeColor(edge.redF(), edge.greenF(), edge.blueF());
  } else {
    property.SetRepresentationToWireframe();
    property.SetOpacity(1);
    property.BackfaceCullingOff();
  }
}

FoundView::~FoundView() { renderer_->RemoveActor(actor_); }

vtkActor& FoundView::actor() { return *actor_; }

void FoundView::draw(const Frame& frame) {
  const FoundSeparation* way =
      frame.searched && frame.searched->*way_ ? &*(frame.searched->*way_) : nullptr;
  if (!way || !(way->depth > 0)) return hide();
  actor_->GetProperty()->SetLineWidth(frame.density);
  place(*actor_, way->separated);
  actor_->VisibilityOn();
  label(way->separated * frame.mass.com,
        QStringLiteral("%1, %2").arg(name_, frame.unit.text(way->depth)), colour_);
}

void FoundView::hide() { actor_->VisibilityOff(); }

Pose on_the_way(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ, double part) {
  const Vec3 from = X_FO * mass.com;
  const Vec3 to = X_FQ * mass.com;
  const Quat turned = X_FO.q.slerp(part, X_FQ.q);
  return {turned, from + part * (to - from) - turned * mass.com};
}

}  // namespace sonde::ui
