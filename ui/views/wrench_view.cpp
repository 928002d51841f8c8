// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/wrench_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double least_shown = 1e-3;  // of the legend's unit: below, rounding

}  // namespace

QString lessened_text(Lessened by, double share) {
  if (by == Lessened::nothing) return {};
  const QString what = QString::fromUtf8(words(by));
  return by == Lessened::coming_in
             ? QStringLiteral("%1, %2 %").arg(what).arg(100 * share, 0, 'f', 0)
             : what;
}

namespace {

QString in_brackets(const QString& text) {
  return text.isEmpty() ? text : QStringLiteral(" (%1)").arg(text);
}

}  // namespace

WrenchScale wrench_scale(double radius, const Coupling& coupling) {
  return {.metres_per_newton = round_down_125(1.3 * radius / coupling.max_force),
          .newton_metres_per_quarter = round_down_125(coupling.max_torque / 1.4)};
}

WrenchView::WrenchView(vtkRenderer& renderer, GlyphShapes& shapes)
    : force_(renderer, shapes, colour::force), torque_(renderer, shapes, colour::torque) {}

void WrenchView::draw(const Frame& frame) {
  hide();
  const Wrench& wrench = frame.snapshot.wrench;
  const Vec3 com = frame.snapshot.separation.device * frame.mass.com;
  const double force = wrench.force.norm();
  const double torque = wrench.torque.norm();
  const HandState& hand = frame.snapshot.hand;
  const Coupling& gains = frame.snapshot.coupling;
  const QString by = in_brackets(lessened_text(force_lessened(wrench, hand, gains), hand.share));
  if (force * scale_.metres_per_newton > least_shown * frame.mass.radius) {
    const Vec3 tip = com + wrench.force * scale_.metres_per_newton;
    force_.set(com, tip, 3 * frame.pixel);
    label(tip, QStringLiteral("%1 N%2").arg(number(force), by), colour::force, {com, tip}, note_);
  }
  const double angle = std::min(torque / scale_.newton_metres_per_quarter * std::numbers::pi / 2,
                                1.9 * std::numbers::pi);
  if (angle > 0.02) {
    const Vec3 axis = wrench.torque / torque;
    const Vec3 start = any_normal(axis) * (0.62 * frame.mass.radius);
    torque_.set(com, axis, start, angle, 2.4 * frame.pixel);
    const Vec3 end = com + std::cos(angle) * start + std::sin(angle) * axis.cross(start);
    const QString why =
        in_brackets(lessened_text(torque_lessened(wrench, hand, gains), hand.share));
    label(end, QStringLiteral("%1 N·m%2").arg(number(torque), why), colour::torque,
          arc_points(com, axis, start, angle));
  }
}

void WrenchView::hide() {
  force_.hide();
  torque_.hide();
}

QString WrenchView::force_legend(const LengthUnit& unit) const {
  return QStringLiteral("force, 1 N is %1 %2")
      .arg(round_figure(scale_.metres_per_newton / unit.metres()), unit.name());
}

QString WrenchView::torque_legend() const {
  return QStringLiteral("torque, a quarter turn is %1 N·m")
      .arg(round_figure(scale_.newton_metres_per_quarter));
}

}  // namespace sonde::ui
