// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <optional>

#include "ui/document/handles.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"
#include "ui/views/seeing.hpp"

class vtkActor;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// Unit, normal to each other: two in the plane, and the plane's normal.
Mat3 axes_of_plane(const Vec3& normal);

/// The plane that cuts the bodies: the outline of a square in it, an arrow to drag it along its
/// normal, and two rings to tilt it.
class CutView : public Overlay {
 public:
  CutView(vtkRenderer& renderer, GlyphShapes& shapes);
  ~CutView() override;

  void set(const CutPlane& cut, double size);
  /// For mappers: they draw the half on its normal's side. It follows set().
  vtkPlane& plane();
  /// The handles, with arrows of that length.
  Handles handles(double length) const;
  /// The handles that are drawn: the arrow along the normal and the rings about the other axes.
  static bool draws(const Grip& grip) { return grip.turns == (grip.axis != 2); }

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPlane> plane_;
  vtkSmartPointer<vtkPolyData> square_;
  vtkSmartPointer<vtkActor> outline_;
  Arrow arrow_;
  std::array<Arc, 2> rings_;
  CutPlane cut_;
};

}  // namespace sonde::ui
