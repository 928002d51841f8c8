// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/separation_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double least_turn = 1e-3;   // rad; a smaller one is drawn as a translation
constexpr double least_depth = 1e-7;  // of the probe's radius; a smaller one is a mere touch
constexpr double far_axis = 3;        // of the probe's radius

QString drawn(double magnification) {
  if (magnification <= 1) return {};
  return QStringLiteral(" (drawn × %1)").arg(magnification);
}

/// Powers of ten with a margin on both sides, so that a drawing does not flicker between two.
void choose_magnification(double& magnification, double size, double small, double large) {
  while (size * magnification < small && magnification < 1000) magnification *= 10;
  while (size * magnification > large && magnification > 1) magnification /= 10;
}

}  // namespace

Screw screw_of(const SeparationMotion& motion, const Vec3& com) {
  Screw screw;
  screw.turn = motion.theta.norm();
  if (screw.turn < 1e-9) {
    screw.turn = 0;
    screw.slide = motion.t.norm();
    if (screw.slide > 0) screw.axis = motion.t / screw.slide;
    screw.point = com;
    return screw;
  }
  screw.axis = motion.theta / screw.turn;
  screw.slide = motion.t.dot(screw.axis);
  const Vec3 across = motion.t - screw.slide * screw.axis;
  // The point that stays: (R − I)(com − point) = across.
  screw.point = com + 0.5 * across + 0.5 / std::tan(screw.turn / 2) * screw.axis.cross(across);
  return screw;
}

SeparationView::SeparationView(vtkRenderer& renderer, GlyphShapes& shapes)
    : axis_(renderer, shapes, colour::ghost.darker(130)),
      slide_(renderer, shapes, colour::ghost),
      turn_(renderer, shapes, colour::ghost) {}

void SeparationView::draw(const Frame& frame) {
  const Separation& separation = frame.snapshot.separation;
  hide();
  if (separation.status != Status::penetrating) return;
  if (!(separation.depth > least_depth * frame.mass.radius)) return;
  const Vec3 com = separation.device * frame.mass.com;
  const SeparationMotion motion =
      separation_motion(frame.mass, separation.device, separation.separated);
  const Screw screw = screw_of(motion, com);
  const double reach = frame.mass.radius;
  choose_magnification(magnify_shift_, motion.t.norm() / std::max(reach, 1e-12), 0.06, 1.2);
  choose_magnification(magnify_turn_, screw.turn, 0.3, 3.5);
  if (screw.turn > least_turn && (screw.point - com).norm() < far_axis * reach)
    draw_screw(frame, motion, screw, com);
  else
    draw_arrow(frame, motion, com);
}

void SeparationView::draw_screw(const Frame& frame, const SeparationMotion& motion,
                                const Screw& screw, const Vec3& com) {
  const double reach = frame.mass.radius;
  const double thick = 1.7 * frame.pixel;
  const Vec3 half = screw.axis * reach * 1.25;
  axis_.set(screw.point - half, screw.point + half, 0.45 * thick, false);
  const double slide = screw.slide * magnify_shift_;
  // The slide is beside the arc, not inside it: from where the axis leaves the probe's ball.
  const Vec3 from = screw.point + screw.axis * (0.25 * reach);
  if (std::abs(slide) > 6 * frame.pixel) {
    slide_.set(from, from + screw.axis * slide, thick);
    label(from + screw.axis * slide,
          QStringLiteral("screw's slide %1%2")
              .arg(frame.unit.text(std::abs(screw.slide)), drawn(magnify_shift_)),
          colour::ghost, {from, from + screw.axis * slide});
  }
  Vec3 start = com - screw.point;
  start -= screw.axis * screw.axis.dot(start);
  const double arm = 0.45 * reach;
  start = start.norm() > 1e-3 * reach ? Vec3(start.normalized() * arm)
                                      : Vec3(any_normal(screw.axis) * arm);
  const double angle = std::min(screw.turn * magnify_turn_, 1.9 * std::numbers::pi);
  turn_.set(screw.point, screw.axis, start, angle, thick);
  const Vec3 end =
      screw.point + std::cos(angle) * start + std::sin(angle) * screw.axis.cross(start);
  // How far the centre of mass goes is what the readout says too; along the axis it is less.
  label(end,
        QStringLiteral("moves %1, turns %2%3")
            .arg(frame.unit.text(motion.t.norm()), angle_text(screw.turn), drawn(magnify_turn_)),
        colour::ghost, arc_points(screw.point, screw.axis, start, angle));
}

void SeparationView::draw_arrow(const Frame& frame, const SeparationMotion& motion,
                                const Vec3& com) {
  const Vec3 tip = com + motion.t * magnify_shift_;
  slide_.set(com, tip, 1.7 * frame.pixel);
  label(tip,
        QStringLiteral("moves %1%2, turns %3")
            .arg(frame.unit.text(motion.t.norm()), drawn(magnify_shift_),
                 angle_text(motion.theta.norm())),
        colour::ghost, {com, tip});
}

void SeparationView::hide() {
  axis_.hide();
  slide_.hide();
  turn_.hide();
}

}  // namespace sonde::ui
