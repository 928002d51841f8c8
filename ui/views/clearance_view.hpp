// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// The nearest points of a free probe and the fixed body, and a line between them with its length.
class ClearanceView : public Overlay {
 public:
  ClearanceView(vtkRenderer& renderer, GlyphShapes& shapes);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  Ball on_probe_, on_fixed_;
  Arrow line_;
};

}  // namespace sonde::ui
