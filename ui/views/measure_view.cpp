// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/measure_view.hpp"

#include <QStringList>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double ball_pixels = 4.5;
constexpr double line_pixels = 1.1;

QString components(const LengthUnit& unit, const Vec3& x) {
  return QStringLiteral("%1, %2, %3").arg(unit.text(x.x()), unit.text(x.y()), unit.text(x.z()));
}

}  // namespace

MeasureView::MeasureView(vtkRenderer& renderer, GlyphShapes& shapes)
    : line_(renderer, shapes, colour::measure) {
  for (auto& ball : balls_) ball = std::make_unique<Ball>(renderer, shapes, colour::measure);
}

void MeasureView::add(const MeasuredPoint& point) {
  if (points_.size() == most) points_.clear();
  points_.push_back(point);
}

void MeasureView::draw(const Frame& frame) {
  hide();
  std::vector<Vec3> at;
  for (const MeasuredPoint& point : points_) {
    at.push_back(point.on_probe ? frame.snapshot.separation.device * point.x : point.x);
    balls_.at(at.size() - 1)->set(at.back(), ball_pixels * frame.pixel);
  }
  if (at.size() == 1)
    label(at[0],
          QStringLiteral("at %1; %2 from the other body")
              .arg(components(frame.unit, at[0]), frame.unit.text(points_[0].gap)),
          colour::measure);
  if (at.size() < most) return;
  line_.set(at[0], at[1], line_pixels * frame.pixel, false);
  const Vec3 apart = at[1] - at[0];
  label(0.5 * (at[0] + at[1]),
        QStringLiteral("%1 apart (%2)")
            .arg(frame.unit.text(apart.norm()), components(frame.unit, apart)),
        colour::measure, {at[0], at[1]});
}

void MeasureView::hide() {
  for (const auto& ball : balls_) ball->hide();
  line_.hide();
}

}  // namespace sonde::ui
