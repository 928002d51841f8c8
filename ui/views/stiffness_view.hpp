// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// The stiffness that the hand feels at the probe's centre of mass, in contact and with the object
/// norm: a rod along each principal direction, as long as it is stiff, and an arc about each
/// principal axis, as large. What is a small part of the stiffest is left out.
class StiffnessView : public Overlay {
 public:
  StiffnessView(vtkRenderer& renderer, GlyphShapes& shapes);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  std::array<Arrow, 3> rods_;
  std::array<Arc, 3> arcs_;
};

}  // namespace sonde::ui
