// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "ui/views/overlay.hpp"
#include "ui/views/seeing.hpp"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// A ring round a place of a body, with words beside it: it says where to look.
class PlaceView : public Overlay {
 public:
  explicit PlaceView(vtkRenderer& renderer);
  void set(const std::optional<PointedPlace>& place) { place_ = place; }
  const std::optional<PointedPlace>& pointed() const { return place_; }

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkPolyData> ring_;
  vtkSmartPointer<vtkActor> actor_;
  std::optional<PointedPlace> place_;
};

}  // namespace sonde::ui
