// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// The handles around the probe, of one size on screen. They have names, so that colour is not
/// needed to tell them apart.
class HandleView : public Overlay {
 public:
  HandleView(vtkRenderer& renderer, GlyphShapes& shapes);

  /// Along the probe's own axes, rather than the fixed body's.
  void set_local(bool local) { local_ = local; }
  bool local() const { return local_; }

  static constexpr double pixels = 95;  ///< the length of an arrow

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  std::array<std::unique_ptr<Arrow>, 3> arrows_;
  std::array<std::unique_ptr<Arc>, 3> rings_;
  bool local_ = false;
};

}  // namespace sonde::ui
