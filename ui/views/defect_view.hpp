// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <array>

#include "ui/views/drawn_bodies.hpp"
#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPlane;
class vtkRenderer;

namespace sonde::ui {

/// The edges where the meshes are not closed, hidden by bodies in front of them: edges of holes as
/// thin lines, edges between flipped faces as thick lines.
class DefectView : public Overlay {
 public:
  DefectView(vtkRenderer& renderer, const DrawnBodies& drawn);
  ~DefectView() override;
  /// The plane that cuts the bodies; null: no cut.
  void set_cut(vtkPlane* probe, vtkPlane* fixed);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  std::array<vtkSmartPointer<vtkActor>, 2> probe_, fixed_;
};

}  // namespace sonde::ui
