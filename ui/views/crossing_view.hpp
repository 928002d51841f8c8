// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>

#include "engine/geometry/soup.hpp"
#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// Triangles of a body that go through others of it: filled, each with its edges, on the body.
class CrossingView : public Overlay {
 public:
  /// Of the probe they move with it.
  CrossingView(vtkRenderer& renderer, bool of_probe);
  ~CrossingView() override;
  /// These triangles of that soup; it may go afterwards.
  void set(const Soup& soup, std::span<const std::uint32_t> triangles);
  /// The body is cut there; null: not cut.
  void set_cut(vtkPlane* plane);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
  bool of_probe_;
};

}  // namespace sonde::ui
