// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/body_look.hpp"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

namespace sonde::ui {
namespace {

constexpr double xray_opacity = 0.3;
constexpr int inside_shade = 190;  // QColor's: 100 is as it was, 200 is half as bright

/// No light falls on it: all of the cut has one colour, like a filled face.
void paint_inside(vtkActor& actor, const QColor& colour) {
  const QColor inside = cut_colour(colour);
  vtkNew<vtkProperty> property;
  property->SetColor(inside.redF(), inside.greenF(), inside.blueF());
  property->SetAmbient(1);
  property->SetDiffuse(0);
  property->SetSpecular(0);
  actor.SetBackfaceProperty(property);
}

}  // namespace

QColor cut_colour(const QColor& colour) { return colour.darker(inside_shade); }

void apply_look(vtkActor& actor, Look look, const QColor& colour, bool solid, vtkPlane* cut) {
  actor.SetVisibility(look != Look::hidden);
  vtkProperty& property = *actor.GetProperty();
  property.SetOpacity(look == Look::xray ? xray_opacity : 1);
  if (look == Look::wireframe)
    property.SetRepresentationToWireframe();
  else
    property.SetRepresentationToSurface();
  // Back faces are seen through a cut and between wires alone.
  property.SetBackfaceCulling(solid && !cut && look != Look::wireframe);
  actor.GetMapper()->RemoveAllClippingPlanes();
  actor.SetBackfaceProperty(nullptr);
  if (!cut) return;
  actor.GetMapper()->AddClippingPlane(cut);
  if (look == Look::opaque) paint_inside(actor, colour);
}

}  // namespace sonde::ui
