// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// A rigid motion as a turn about an axis and a slide along it.
struct Screw {
  Vec3 point = Vec3::Zero();  ///< on the axis, nearest to where the centre of mass starts
  Vec3 axis = Vec3::UnitZ();
  double slide = 0;  ///< m along the axis; may be negative
  double turn = 0;   ///< rad, ≥ 0
};
/// The screw of a motion that takes the centre of mass from `com`. With no turn the axis is along
/// the displacement, through com.
Screw screw_of(const SeparationMotion& motion, const Vec3& com);

/// The motion from the device pose to the separated one: a screw axis with an arrow for the slide
/// and an arc for the turn; for a motion that hardly turns, or turns about a far axis, the arrow of
/// the displacement alone. Small motions are drawn larger by a power of ten that the label names.
class SeparationView : public Overlay {
 public:
  SeparationView(vtkRenderer& renderer, GlyphShapes& shapes);

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  void draw_screw(const Frame& frame, const SeparationMotion& motion, const Screw& screw,
                  const Vec3& com);
  void draw_arrow(const Frame& frame, const SeparationMotion& motion, const Vec3& com);

  Arrow axis_;
  Arrow slide_;
  Arc turn_;
  double magnify_shift_ = 1;
  double magnify_turn_ = 1;
};

}  // namespace sonde::ui
