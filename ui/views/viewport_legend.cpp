// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport says of its colours.

#include <utility>
#include <vector>

#include "ui/base/theme.hpp"
#include "ui/views/scenery.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {

void Viewport::update_legend() {
  const Scenery& s = *scenery_;
  std::vector<LegendLine> legend{{colour::probe, s.descriptions[0]},
                                 {colour::fixed, s.descriptions[1]}};
  if (shown(Layer::ghost)) {
    // Where bodies overlap a little, most of the ghost is seen in its other colour.
    const bool mixes = !has_colours(*s.probe_surface);
    legend.push_back({colour::ghost,
                      mixes ? QStringLiteral("separated probe; right: on the probe")
                            : QStringLiteral("separated probe, as held"),
                      LegendMark::clear, mixes ? colour::ghost_on_probe : QColor()});
  }
  if (shown(Layer::nearest))
    legend.push_back({colour::nearest, QStringLiteral("nearest way out"), LegendMark::mesh});
  if (shown(Layer::straight))
    legend.push_back(
        {colour::straight, QStringLiteral("nearest without a turn (PD_t)"), LegendMark::wires});
  if (shown(Layer::bound))
    legend.push_back(
        {colour::bound, QStringLiteral("witness of the lower bound"), LegendMark::ring});
  if (shown(Layer::stiffness))
    legend.push_back({colour::stiffness, QStringLiteral("felt stiffness, by its main directions")});
  if (shown(Layer::clearance))
    legend.push_back({colour::clearance, QStringLiteral("clearance: the nearest points")});
  if (shown(Layer::contacts))
    legend.push_back({colour::contact, QStringLiteral("contacts and normals")});
  if (shown(Layer::wrench)) {
    legend.push_back({colour::force, s.wrench.force_legend(s.unit)});
    legend.push_back({colour::torque, s.wrench.torque_legend()});
  }
  if (s.seeing.cut.on)
    legend.push_back({colour::cut, QStringLiteral("cut plane: drag its arrow or rings")});
  if (shown(Layer::measures))
    legend.push_back({colour::measure, QStringLiteral("measuring: click on a body, twice")});
  if (shown(Layer::defects)) {
    legend.push_back({colour::hole, QStringLiteral("edges of holes, thin")});
    legend.push_back({colour::flipped, QStringLiteral("edges between flipped faces, thick")});
  }
  if (shown(Layer::grid))
    legend.push_back(
        {colour::faint, QStringLiteral("grid, %1 %2")
                            .arg(round_figure(s.grid.spacing() / s.unit.metres()), s.unit.name())});
  if (s.caps && s.caps->any() && shown(Layer::mended))
    legend.push_back({colour::cap, QStringLiteral("openings that were closed")});
  if (shown(Layer::crossings))
    legend.push_back(
        {colour::crossing, QStringLiteral("triangles through others"), LegendMark::mesh});
  s.hints->set_legend(std::move(legend));
  update_scale();
}

/// The colours of the gap, with their lengths.
void Viewport::update_scale() {
  const Scenery& s = *scenery_;
  if (!shown(Layer::gaps) || !(s.gap_reach > 0)) return s.hints->set_scale({});
  ColourScale scale{QStringLiteral("gap, %1").arg(s.unit.name()), {}, {}};
  constexpr int colours = 32, ticks = 5;
  for (int i = 0; i < colours; ++i) scale.colours.push_back(gap_colour(i / double(colours - 1)));
  for (int i = 0; i < ticks; ++i)
    scale.ticks << number(s.gap_reach * i / (ticks - 1) / s.unit.metres());
  s.hints->set_scale(std::move(scale));
}

}  // namespace sonde::ui
