// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <array>

#include "ui/views/drawn_bodies.hpp"
#include "ui/views/overlay.hpp"
#include "ui/views/seeing.hpp"

class vtkActor;
class vtkPlane;
class vtkRenderer;

namespace sonde::ui {

/// What closes openings of the bodies, in a colour of its own, over the very triangles of the body
/// that it is; with the edges of the openings as lines. On the ghost too.
class CapView : public Overlay {
 public:
  CapView(vtkRenderer& renderer, const DrawnBodies& drawn);
  ~CapView() override;
  /// As the bodies look; null: that body is not cut.
  void set_seeing(const Seeing& seeing, vtkPlane* cut_probe, vtkPlane* cut_fixed);
  /// Whether the ghost is on show.
  void set_ghost(bool shown) { ghost_shown_ = shown; }
  /// Whether there is anything to be seen.
  bool any() const;
  /// Those that keep their colour whatever the background.
  std::array<const vtkActor*, 3> faces() const;

 private:
  struct Drawn {
    vtkSmartPointer<vtkActor> faces, seams;
    bool solid = false, there = false, shown = true;
  };
  static Drawn drawn_of(vtkRenderer& renderer, const CapSurface& caps, bool solid);
  static void set_visible(const Drawn& drawn, bool visible);
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  Drawn probe_, fixed_, ghost_;
  bool ghost_shown_ = true;
};

}  // namespace sonde::ui
