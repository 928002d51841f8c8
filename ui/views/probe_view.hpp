// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// The probe, opaque, where the device holds it.
class ProbeView : public Overlay {
 public:
  ProbeView(vtkRenderer& renderer, vtkPolyData& surface);
  ~ProbeView() override;

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

/// The separated probe, a translucent ghost; with a trail it swings from the device pose to there.
class GhostView : public Overlay {
 public:
  /// A solid's back faces are left out: one layer to look through instead of two.
  GhostView(vtkRenderer& renderer, vtkPolyData& surface, bool solid);
  ~GhostView() override;

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

/// The pose a part of the way from O to Q: the centre of mass on a line, the turn at even speed.
Pose on_the_way(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ, double part);

}  // namespace sonde::ui
