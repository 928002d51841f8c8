// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/witness_view.hpp"

#include <numbers>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double point_pixels = 4;
constexpr double witness_ring_pixels = 1.2;

}  // namespace

WitnessView::WitnessView(vtkRenderer& renderer, GlyphShapes& shapes)
    : point_(renderer, shapes, colour::bound),
      rings_{Arc(renderer, shapes, colour::bound), Arc(renderer, shapes, colour::bound),
             Arc(renderer, shapes, colour::bound)} {}

void WitnessView::draw(const Frame& frame) {
  if (!frame.searched || !frame.searched->witness || !frame.searched->lower_bound) return hide();
  const BoundWitness& witness = *frame.searched->witness;
  point_.set(witness.at, point_pixels * frame.pixel);
  for (Eigen::Index i = 0; i < 3; ++i)
    rings_.at(static_cast<std::size_t>(i))
        .set(witness.at, Vec3::Unit(i), witness.depth * Vec3::Unit((i + 1) % 3),
             2 * std::numbers::pi, witness_ring_pixels * frame.pixel);
  label(witness.at,
        QStringLiteral("moves %1 at least: bound %2")
            .arg(frame.unit.text(witness.depth), frame.unit.text(*frame.searched->lower_bound)),
        colour::bound);
}

void WitnessView::hide() {
  point_.hide();
  for (Arc& ring : rings_) ring.hide();
}

}  // namespace sonde::ui
