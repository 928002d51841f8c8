// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <deque>

#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// The path of the probe's centre of mass in the last seconds: at the hand, and as held.
class TrailView : public Overlay {
 public:
  explicit TrailView(vtkRenderer& renderer);
  ~TrailView() override;
  void clear() { places_.clear(); }

 private:
  struct Line {
    vtkSmartPointer<vtkPolyData> path;
    vtkSmartPointer<vtkActor> actor;
  };
  struct Place {
    double time;  ///< s
    Vec3 hand, held;
  };
  Line line_in(const QColor& colour);
  void show_line(const Line& line, Vec3 Place::*where);
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  Line hand_, held_;
  std::deque<Place> places_;
};

}  // namespace sonde::ui
