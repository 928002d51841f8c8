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
  ProbeView(vtkRenderer& renderer, vtkPolyData& surface, bool solid);
  ~ProbeView() override;
  vtkActor& actor();  ///< to be drawn in another look

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

/// Of whatever shows a probe elsewhere than at the device pose. colour::ghost_on_probe is by it.
inline constexpr double ghost_opacity = 0.38;

/// The separated probe as a translucent ghost; it may swing between the device pose and its own.
class GhostView : public Overlay {
 public:
  GhostView(vtkRenderer& renderer, vtkPolyData& surface, bool solid);
  ~GhostView() override;
  vtkActor& actor();

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

/// A way out that a search found: the probe there, with its depth beside it. It differs by shape,
/// besides its colour.
class FoundView : public Overlay {
 public:
  enum class Shape {
    mesh,  ///< translucent, with the edges of its triangles
    wires  ///< the edges alone
  };
  /// Which of the ways: a member of what was searched.
  using Way = std::optional<FoundSeparation> BackgroundResult::*;
  FoundView(vtkRenderer& renderer, vtkPolyData& surface, bool solid, Way way, Shape shape,
            const QString& name, const QColor& colour);
  ~FoundView() override;
  vtkActor& actor();

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
  Way way_;
  QString name_;
  QColor colour_;
};

/// An actor for a body of that colour. For a solid it leaves out the back faces: they are never
/// seen, cost half of the drawing on software GL, and would be a second layer of a ghost.
vtkSmartPointer<vtkActor> body_actor(vtkRenderer& renderer, vtkPolyData& surface,
                                     const QColor& colour, bool solid);

/// The pose a part of the way from O to Q: the centre of mass on a line, the turn at even speed.
Pose on_the_way(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ, double part);

}  // namespace sonde::ui
