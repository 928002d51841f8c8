// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <QColor>

#include "engine/proximity/queries/gap_field.hpp"
#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// The colour of a gap that is this part of the largest one shown: from yellow at a touch, over
/// green, to dark blue. Lightness falls monotonically, so it can be read without the hue.
QColor gap_colour(double part);

/// The gaps to the other body, painted on a body where it is near.
class GapView : public Overlay {
 public:
  explicit GapView(vtkRenderer& renderer);
  ~GapView() override;

  /// On a body at X_FB, for gaps up to that one, m. An empty field paints nothing.
  void set(const GapField& field, const Pose& X_FB, double reach);
  void clear() { set({}, {}, 0); }
  /// The body is cut there.
  void set_cut(vtkPlane* cut);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> patch_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace sonde::ui
