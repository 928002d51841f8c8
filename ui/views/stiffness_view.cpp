// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/stiffness_view.hpp"

#include "engine/sonde.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double longest_pixels = 80;  // of the stiffest direction, to either side
constexpr double largest_pixels = 60;  // of the stiffest axis, the radius of its arc
constexpr double thick_pixels = 1.6;
constexpr double least_share = 0.02;  // of the stiffest: what is less is not drawn
constexpr double arc_angle = 1.5;     // rad

}  // namespace

StiffnessView::StiffnessView(vtkRenderer& renderer, GlyphShapes& shapes)
    : rods_{Arrow{renderer, shapes, colour::stiffness}, Arrow{renderer, shapes, colour::stiffness},
            Arrow{renderer, shapes, colour::stiffness}},
      arcs_{Arc{renderer, shapes, colour::stiffness}, Arc{renderer, shapes, colour::stiffness},
            Arc{renderer, shapes, colour::stiffness}} {}

void StiffnessView::draw(const Frame& frame) {
  hide();
  const Separation& now = frame.snapshot.separation;
  const Coupling& coupling = frame.snapshot.coupling;
  if (!frame.pair || now.status != Status::penetrating) return;
  const Vec3 com = now.device * frame.mass.com;
  if (!in_object_norm(coupling.mode))
    return label(com, QStringLiteral("felt stiffness: of the object norm only"), colour::stiffness);
  const WrenchDerivative derivative = wrench_derivative(*frame.pair, now);
  if (derivative.sides == WrenchDerivative::Sides::none)
    return label(com, QStringLiteral("no felt stiffness: %1").arg(derivative.reason),
                 colour::stiffness);
  const auto [along, about] = principal_stiffnesses(derivative, coupling.k);
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = along[i].value / along[0].value;
    if (!(along[0].value > 0) || !(share > least_share)) continue;
    const Vec3 half = share * longest_pixels * frame.pixel * along[i].direction;
    rods_[i].set(com - half, com + half, thick_pixels * frame.pixel, false);
    label(com + half, QStringLiteral("%1 N/m").arg(number(along[i].value)), colour::stiffness,
          {com - half, com + half});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = about[i].value / about[0].value;
    if (!(about[0].value > 0) || !(share > least_share)) continue;
    const Vec3& axis = about[i].direction;
    const Vec3 start = share * largest_pixels * frame.pixel * any_normal(axis);
    arcs_[i].set(com, axis, start, arc_angle, thick_pixels * frame.pixel);
    const std::vector<Vec3> arc = arc_points(com, axis, start, arc_angle);
    label(arc.back(), QStringLiteral("%1 N·m/rad").arg(number(about[i].value)), colour::stiffness,
          arc);
  }
}

void StiffnessView::hide() {
  for (Arrow& rod : rods_) rod.hide();
  for (Arc& arc : arcs_) arc.hide();
}

}  // namespace sonde::ui
