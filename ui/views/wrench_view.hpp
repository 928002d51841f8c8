// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/loop/lessened.hpp"
#include "ui/views/force_note.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// How long a force is drawn and how far a torque turns. Round figures, so that the legend can be
/// used as a ruler.
struct WrenchScale {
  double metres_per_newton = 1e-3;
  double newton_metres_per_quarter = 0.1;  ///< torque that a quarter turn stands for
};
/// The force limit is about as long as the probe's radius; the torque limit at most three quarters
/// of a turn.
WrenchScale wrench_scale(double radius, const Coupling& coupling);

/// Why the hand gets another force than the coupling wants: "limit", "coming in, 40 %"; empty where
/// nothing acts.
QString lessened_text(Lessened by, double share);

/// What the hand feels, at the probe's centre of mass at the device pose: the force as an arrow,
/// the torque as an arc, each with its magnitude.
class WrenchView : public Overlay {
 public:
  WrenchView(vtkRenderer& renderer, GlyphShapes& shapes);
  void set_scale(const WrenchScale& scale) { scale_ = scale; }
  void set_note(ForceNote note) { note_ = std::move(note); }
  const ForceNote& note() const { return note_; }
  QString force_legend(const LengthUnit& unit) const;
  QString torque_legend() const;

 private:
  void draw(const Frame& frame) override;
  void hide() override;
  Arrow force_;
  Arc torque_;
  WrenchScale scale_;
  ForceNote note_;
};

}  // namespace sonde::ui
