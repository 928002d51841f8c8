// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "ui/views/overlay.hpp"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// A grid on the ground: the plane square to the scene's up at the lowest place of the fixed body.
/// Bodies hide it where they stand before it.
class GridView : public Overlay {
 public:
  explicit GridView(vtkRenderer& renderer);
  ~GridView() override;

  /// `box`: the fixed body's, in its mesh frame; q_FW: the scene's axes there.
  void set(const Eigen::AlignedBox3d& box, const Quat& q_FW);
  double spacing() const { return spacing_; }  ///< m

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> lines_;
  vtkSmartPointer<vtkActor> actor_;
  double spacing_ = 0;
};

}  // namespace sonde::ui
