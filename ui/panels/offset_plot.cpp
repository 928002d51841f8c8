// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/offset_plot.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
constexpr double map_left = 46, map_right = 10;  // px

/// What can be of a point, in the colours that the study's picture has.
struct Outcome {
  const char* words;
  QColor colour;
};
const std::array<Outcome, 3>& outcomes() {
  static const std::array<Outcome, 3> all{{{"goes in", {0x1b, 0x78, 0x37}},
                                           {"binds", {0xfd, 0xae, 0x61}},
                                           {"overlaps at once", {0xba, 0xba, 0xba}}}};
  return all;
}
const Outcome& outcome(double free, double wanted) {
  return outcomes().at(free >= wanted ? 0 : free >= 0 ? 1 : 2);
}

}  // namespace

OffsetPlot::OffsetPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("offset_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip(QStringLiteral("A click takes the probe to the mouth, off by that much"));
  QFont small = font();
  small.setPointSizeF(8.5);
  setFont(small);
}

void OffsetPlot::set_map(OffsetMap map, const LengthUnit& unit) {
  map_ = std::move(map);
  unit_ = unit;
  chosen_.reset();
  update();
}

void OffsetPlot::choose(std::optional<MapPlace> place) {
  chosen_ = place;
  update();
}

QRectF OffsetPlot::area() const {
  const double line = QFontMetricsF(font()).height();
  return {map_left, line + 6, std::max(width() - map_left - map_right, 1.0),
          std::max(height() - 3 * line - 16, 1.0)};
}

/// Offsets to the right, tilts upwards.
QRectF OffsetPlot::cell(const MapPlace& place) const {
  const QRectF all = area();
  const double wide = all.width() / static_cast<double>(map_.at.offsets),
               high = all.height() / static_cast<double>(map_.at.tilts);
  return {all.left() + wide * static_cast<double>(place.offset),
          all.bottom() - high * static_cast<double>(place.tilt + 1), wide, high};
}

QPointF OffsetPlot::place_of(const MapPlace& place) const { return cell(place).center(); }

void OffsetPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), plot_background(palette()));
  if (map_.free.empty()) return;
  for (std::size_t i = 0; i < map_.at.offsets; ++i)
    for (std::size_t j = 0; j < map_.at.tilts; ++j)
      // To whole pixels, so that no seam shows between cells.
      painter.fillRect(cell({i, j}).toAlignedRect(),
                       outcome(map_.free[i * map_.at.tilts + j], map_.wanted).colour);
  if (chosen_) {
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
    painter.drawRect(cell(*chosen_).adjusted(0, 0, -1, -1));
  }
  paint_words(painter);
}

void OffsetPlot::paint_words(QPainter& painter) const {
  const QRectF all = area();
  const double line = QFontMetricsF(font()).height();
  painter.setPen(faint_text(palette()));
  painter.drawText(QPointF(4, line),
                   QStringLiteral("tilt, ° (up), by offset, %1").arg(unit_.name()));
  const double offset = map_.at.largest_offset / unit_.metres(),
               tilt = map_.at.largest_tilt * to_degrees;
  const QRectF foot(all.left(), all.bottom() + 2, all.width(), line);
  painter.drawText(foot, Qt::AlignLeft, number(-offset));
  painter.drawText(foot, Qt::AlignHCenter, QStringLiteral("0"));
  painter.drawText(foot, Qt::AlignRight, number(offset));
  const QRectF side(0, all.top(), map_left - 4, all.height());
  painter.drawText(side, Qt::AlignRight | Qt::AlignTop, number(tilt));
  painter.drawText(side, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"));
  painter.drawText(side, Qt::AlignRight | Qt::AlignBottom, number(-tilt));
  double x = 4;
  const double y = height() - 4 - line;
  for (const Outcome& each : outcomes()) {
    const QString words = QString::fromUtf8(each.words);
    painter.fillRect(QRectF(x, y + 2, 10, line - 4), each.colour);
    painter.drawText(QPointF(x + 14, y + line - 4), words);
    x += 22 + QFontMetricsF(font()).horizontalAdvance(words);
  }
}

void OffsetPlot::mousePressEvent(QMouseEvent* event) {
  const QRectF all = area();
  if (event->button() != Qt::LeftButton || map_.free.empty() || !all.contains(event->localPos()))
    return;
  const auto at = [](double part, std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(std::max(0.0, part) * static_cast<double>(count)));
  };
  const QPointF from = event->localPos();
  asked({at((from.x() - all.left()) / all.width(), map_.at.offsets),
         at((all.bottom() - from.y()) / all.height(), map_.at.tilts)});
}

}  // namespace sonde::ui
