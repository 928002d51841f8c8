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
  const QString limited = wrench.saturated ? QStringLiteral(" (limit)") : QString();
  if (force * scale_.metres_per_newton > least_shown * frame.mass.radius) {
    const Vec3 tip = com + wrench.force * scale_.metres_per_newton;
    force_.set(com, tip, 3 * frame.pixel);
    const QString note = note_.text.isEmpty() ? QString() : '\n' + note_.text;
    label(tip, QStringLiteral("%1 N%2%3").arg(number(force), limited, note), colour::force,
          {com, tip}, note_.course);
  }
  const double angle = std::min(torque / scale_.newton_metres_per_quarter * std::numbers::pi / 2,
                                1.9 * std::numbers::pi);
  if (angle > 0.02) {
    const Vec3 axis = wrench.torque / torque;
    const Vec3 start = any_normal(axis) * (0.62 * frame.mass.radius);
    torque_.set(com, axis, start, angle, 2.4 * frame.pixel);
    const Vec3 end = com + std::cos(angle) * start + std::sin(angle) * axis.cross(start);
    label(end, QStringLiteral("%1 N·m").arg(number(torque)), colour::torque,
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
