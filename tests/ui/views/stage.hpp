// SPDX-License-Identifier: GPL-3.0-or-later
// What an overlay shows of a moment, without a window: its actors, where they lie, and its labels.
#pragma once

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QStringList>
#include <vector>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui::test {

/// A moment to show, of a probe of 50 mm. A pixel is a tenth of a millimetre.
struct Stage {
  static constexpr double pixel = 1e-4;
  vtkNew<vtkRenderer> renderer;
  GlyphShapes shapes;
  Snapshot snapshot;
  MassProperties mass;
  LengthUnit unit{0.05};

  Stage() {
    mass.radius = 0.05;
    snapshot.separation.status = Status::penetrating;
    snapshot.hand.share = 1;
  }
  Frame frame() { return Frame{snapshot, mass, unit, pixel}; }
  /// The visible actors, in the order in which they were made.
  std::vector<vtkActor*> seen() {
    std::vector<vtkActor*> out;
    vtkActorCollection* all = renderer->GetActors();
    all->InitTraversal();
    while (vtkActor* actor = all->GetNextActor())
      if (actor->GetVisibility()) out.push_back(actor);
    return out;
  }
};

/// Of what an actor draws, in the scene.
inline Eigen::AlignedBox3d bounds_of(vtkActor& actor) {
  const double* b = actor.GetBounds();
  return {Vec3(b[0], b[2], b[4]), Vec3(b[1], b[3], b[5])};
}

inline QColor colour_of(vtkActor& actor) {
  const double* rgb = actor.GetProperty()->GetColor();
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]).toRgb();
}

/// Without those that are a line alone.
inline QStringList texts_of(const Overlay& overlay) {
  QStringList out;
  for (const Label& label : overlay.labels())
    if (!label.text.isEmpty()) out << label.text;
  return out;
}

}  // namespace sonde::ui::test
