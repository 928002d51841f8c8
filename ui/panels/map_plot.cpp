// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_plot.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "engine/study/charts/chart_scale.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double legend_lines = 5;

QColor colour_of(MapClass map_class) {
  constexpr std::array rgb{0xa1403bu, 0x4f7fb0u, 0xc9952fu, 0x6f9440u, 0x2c7a58u};
  return QColor(QRgb(rgb.at(static_cast<std::size_t>(map_class))));
}

QFont small(const QFont& font) {
  QFont out = font;
  out.setPointSizeF(8.5);
  return out;
}

/// Light, with a dark edge: to be told from every colour of the map.
void paint_stroke(QPainter& painter, const QPainterPath& path, Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 120), 3.2));
  painter.drawPath(path);
  painter.setPen(QPen(QColor(240, 244, 248), 1.6, style, Qt::FlatCap));
  painter.drawPath(path);
}

void paint_diamond(QPainter& painter, const QPointF& at) {
  painter.setPen(QPen(Qt::black, 1));
  painter.setBrush(colour::ghost);
  painter.drawPolygon(QPolygonF(
      {at + QPointF(0, -6), at + QPointF(6, 0), at + QPointF(0, 6), at + QPointF(-6, 0)}));
}

void paint_outline(QPainter& painter, const QRectF& box) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 3.5));
  painter.drawRect(box.adjusted(1, 1, -1, -1));
  painter.setPen(QPen(colour::contact, 1.8));
  painter.drawRect(box.adjusted(1, 1, -1, -1));
}

void paint_disc(QPainter& painter, const QPointF& at) {
  painter.setPen(QPen(Qt::black, 1.2));
  painter.setBrush(Qt::white);
  painter.drawEllipse(at, 5, 5);
}

QString label_of(GainAxis axis, const char* what, const char* key, const QString& unit) {
  return QStringLiteral("%1 %2, %3%4")
      .arg(QLatin1String(what), QLatin1String(key), unit,
           axis == GainAxis::rotation ? QStringLiteral(" (rotation)") : QString());
}

}  // namespace

struct MapPlot::Scales {
  QRectF area;
  ChartScale x, y;

  Scales(const StabilityMap& map, const QRectF& where)
      : area(where),
        x({.label = {}, .logarithmic = true, .from = map.low, .to = map.high}, {}),
        y({.label = {},
           .logarithmic = false,
           .from = map.rows.empty() ? 0 : map.rows.front().from,
           .to = map.rows.empty() ? 1 : map.rows.back().to},
          {}) {}

  double to_x(double stiffness) const {
    return area.left() + std::clamp(x.place(stiffness).value_or(0), 0.0, 1.0) * area.width();
  }
  double to_y(double row) const {
    return area.bottom() - std::clamp(y.place(row).value_or(0), 0.0, 1.0) * area.height();
  }
};

MapPlot::MapPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("map_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMouseTracking(true);
  setToolTip(QStringLiteral("A click sets the gains there; Undo takes them back."));
}

void MapPlot::set_map(const StabilityMap& map) {
  map_ = map;
  update();
}

void MapPlot::set_now(std::optional<MapPoint> point) {
  now_ = point;
  update();
}

void MapPlot::set_recommended(std::optional<MapPoint> point) {
  recommended_ = point;
  update();
}

void MapPlot::set_contact(const std::string& kind, const StabilityMap& of_kind) {
  contact_ = of_kind.rows.empty() ? std::string() : kind;
  of_contact_ = of_kind;
  update();
}

QRectF MapPlot::area() const {
  const QFontMetrics metrics(small(font()));
  const double line = metrics.height();
  double labels = metrics.horizontalAdvance(QStringLiteral("0.0005"));
  for (const MapRow& row : map_.rows)
    labels = std::max(labels, double(metrics.horizontalAdvance(row.label)));
  return {QPointF(labels + 10, map_.over_damping ? 1.4 * line : 6),
          QPointF(width() - 10, height() - (2.3 + legend_lines) * line)};
}

QPointF MapPlot::place(const MapPoint& point) const {
  const Scales scales(map_, area());
  const double row = map_.over_damping || map_.rows.empty()
                         ? point.damping
                         : (map_.rows.front().from + map_.rows.front().to) / 2;
  return {scales.to_x(point.stiffness), scales.to_y(row)};
}

double MapPlot::bottom() const { return area().bottom(); }

MapPoint MapPlot::point_at(const QPointF& at) const {
  const QRectF within = area();
  const auto part = [](double of, double whole) {
    return whole > 0 ? std::clamp(of / whole, 0.0, 1.0) : 0;
  };
  const double x = part(at.x() - within.left(), within.width());
  const double y = part(within.bottom() - at.y(), within.height());
  const double stiffness = map_.low * std::pow(map_.high / map_.low, x);
  const double digit = std::pow(10, std::floor(std::log10(stiffness)) - 2);
  MapPoint point{std::clamp(std::round(stiffness / digit) * digit, map_.low, map_.high), 0};
  if (map_.over_damping && !map_.rows.empty())
    point.damping = map_.rows.front().from + y * (map_.rows.back().to - map_.rows.front().from);
  return point;
}

void MapPlot::mousePressEvent(QMouseEvent* event) {
  const bool on_map = !map_.rows.empty() && area().contains(event->localPos());
  if (event->button() != Qt::LeftButton || !on_map) return QWidget::mousePressEvent(event);
  dragging_ = true;
  if (asked) asked(point_at(event->localPos()));
}

void MapPlot::mouseMoveEvent(QMouseEvent* event) {
  const bool held = event->buttons() & Qt::LeftButton;
  if (held && dragging_ && asked) asked(point_at(event->localPos()));
  dragging_ = dragging_ && held;
  setCursor(!map_.rows.empty() && area().contains(event->localPos()) ? Qt::CrossCursor
                                                                     : Qt::ArrowCursor);
}

void MapPlot::mouseReleaseEvent(QMouseEvent* /*event*/) { dragging_ = false; }

std::optional<MapClass> MapPlot::map_class(const MapPoint& point) const {
  std::optional<MapClass> worst;
  for (const MapRow& row : map_.rows) {
    if (map_.over_damping && (point.damping < row.from || point.damping > row.to)) continue;
    for (const MapRow::Stretch& stretch : row.stretches)
      if (point.stiffness >= stretch.from && point.stiffness <= stretch.to)
        worst = std::min(worst.value_or(stretch.map_class), stretch.map_class);
  }
  return worst;
}

void MapPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setFont(small(font()));
  const Scales scales(map_, area());
  painter.fillRect(scales.area, palette().base());
  if (map_.rows.empty()) return;
  paint_cells(painter, scales);  // without antialiasing: no seams
  painter.setRenderHint(QPainter::Antialiasing);
  paint_stiffness(painter, scales);
  paint_rows(painter, scales);
  paint_limit(painter, scales, &MapRow::stable, Qt::SolidLine);
  paint_limit(painter, scales, &MapRow::theory_stable, Qt::DashLine);
  paint_limit(painter, scales, &MapRow::theory_passive, Qt::DotLine);
  if (!contact_.empty()) paint_contact(painter, scales);
  paint_points(painter);
  paint_legend(painter);
}

void MapPlot::paint_cells(QPainter& painter, const Scales& scales) const {
  for (const MapRow& row : map_.rows)
    for (const MapRow::Stretch& stretch : row.stretches)
      painter.fillRect(QRectF(QPointF(scales.to_x(stretch.from), scales.to_y(row.to)),
                              QPointF(scales.to_x(stretch.to), scales.to_y(row.from))),
                       colour_of(stretch.map_class));
}

void MapPlot::paint_stiffness(QPainter& painter, const Scales& scales) const {
  const QRectF& area = scales.area;
  const QFontMetrics metrics(painter.font());
  const double line = metrics.height();
  double free = 0;  // px, where a label may begin
  for (const ChartScale::Tick& tick : scales.x.ticks()) {
    const double x = area.left() + tick.place * area.width();
    painter.setPen(QColor(0, 0, 0, tick.text.empty() ? 30 : 70));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    // Within the plot, or not at all: half of a number is another number.
    const QString text = QString::fromStdString(tick.text);
    const double wide = metrics.horizontalAdvance(text);
    const double left = std::min(x - wide / 2, width() - wide);
    painter.setPen(faint_text(palette()));
    if (text.isEmpty() || left < free) continue;
    painter.drawText(QRectF(left, area.bottom() + 2, wide, line), Qt::AlignCenter, text);
    free = left + wide + 4;
  }
  painter.drawText(
      QRectF(0, area.bottom() + 2 + line, width(), line), Qt::AlignCenter,
      label_of(map_.axis, "stiffness", stiffness_key(map_.axis), stiffness_unit(map_.axis)));
}

void MapPlot::paint_rows(QPainter& painter, const Scales& scales) const {
  const QRectF& area = scales.area;
  const QFontMetrics metrics(painter.font());
  const double line = metrics.height();
  const auto label = [&](double y, const QString& text) {
    painter.drawText(QRectF(0, y - line / 2, area.left() - 5, line),
                     Qt::AlignRight | Qt::AlignVCenter, text);
  };
  const auto grid = [&](double y) {
    painter.setPen(QColor(0, 0, 0, 70));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  };
  if (!map_.over_damping) {
    for (const MapRow& row : map_.rows) {
      grid(scales.to_y(row.to));
      const double y = (scales.to_y(row.from) + scales.to_y(row.to)) / 2;
      const bool present = !contact_.empty() && row.kind == contact_;
      if (present) {
        painter.fillRect(QRectF(0, y - line / 2, area.left() - 2, line), colour::contact);
        painter.setPen(Qt::black);
      } else {
        painter.setPen(faint_text(palette()));
      }
      label(y, row.label);
    }
    return;
  }
  for (const ChartScale::Tick& tick : scales.y.ticks()) {
    const double y = area.bottom() - tick.place * area.height();
    grid(y);
    painter.setPen(faint_text(palette()));
    label(y, QString::fromStdString(tick.text));
  }
  painter.drawText(QPointF(4, metrics.ascent()),
                   label_of(map_.axis, "damping", damping_key(map_.axis), damping_unit(map_.axis)));
}

/// Through the dampings; over situations, an upright stroke in each row. None off the map.
QPainterPath MapPlot::path_of(const StabilityMap& map, const Scales& scales,
                              double MapRow::*limit) const {
  QPainterPath path;
  bool broken = true;
  for (const MapRow& row : map.rows) {
    const double stiffness = row.*limit;
    const bool drawn = std::isfinite(stiffness) && stiffness >= map_.low && stiffness <= map_.high;
    const double x = drawn ? scales.to_x(stiffness) : 0;
    if (!drawn) {
      broken = true;
    } else if (!map_.over_damping) {
      path.moveTo(x, scales.to_y(row.from));
      path.lineTo(x, scales.to_y(row.to));
    } else {
      const QPointF at(x, scales.to_y(row.damping));
      if (broken)
        path.moveTo(at);
      else
        path.lineTo(at);
      broken = false;
    }
  }
  return path;
}

void MapPlot::paint_limit(QPainter& painter, const Scales& scales, double MapRow::*limit,
                          Qt::PenStyle style) const {
  paint_stroke(painter, path_of(map_, scales, limit), style);
}

/// Its boundary in the colour of contacts; over situations a frame about its rows too.
void MapPlot::paint_contact(QPainter& painter, const Scales& scales) const {
  StabilityMap own = of_contact_;
  if (!map_.over_damping) {
    own.rows.clear();
    for (const MapRow& row : map_.rows)
      if (row.kind == contact_) own.rows.push_back(row);
    for (const MapRow& row : own.rows)
      paint_outline(painter, QRectF(QPointF(scales.area.left(), scales.to_y(row.to)),
                                    QPointF(scales.area.right(), scales.to_y(row.from))));
  }
  const QPainterPath path = path_of(own, scales, &MapRow::stable);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 6));
  painter.drawPath(path);
  painter.setPen(QPen(colour::contact, 3.5, Qt::SolidLine, Qt::FlatCap));
  painter.drawPath(path);
}

void MapPlot::paint_points(QPainter& painter) const {
  const QRectF within = area();
  const auto across = [&](const MapPoint& point, const QColor& colour) {
    if (map_.over_damping) return;
    const double x = place(point).x();
    painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
    painter.drawLine(QPointF(x, within.top()), QPointF(x, within.bottom()));
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QPointF(x, within.top()), QPointF(x, within.bottom()));
  };
  if (recommended_) {
    across(*recommended_, colour::ghost);
    paint_diamond(painter, place(*recommended_));
  }
  if (now_) {
    across(*now_, Qt::white);
    paint_disc(painter, place(*now_));
  }
}

void MapPlot::paint_legend(QPainter& painter) const {
  const QFontMetrics metrics(painter.font());
  const double line = metrics.height(), left = 4, mark = 16;
  double x = left, y = height() - legend_lines * line;
  const auto entry = [&](const QString& text, const std::function<void(const QPointF&)>& draw) {
    const double wide = mark + 4 + metrics.horizontalAdvance(text) + 10;
    if (x > left && x + wide > width()) {
      x = left;
      y += line;
    }
    draw({x + mark / 2, y + line / 2});
    painter.setPen(faint_text(palette()));
    painter.drawText(QPointF(x + mark + 4, y + metrics.ascent()), text);
    x += wide;
  };
  for (const MapClass each : {MapClass::passive, MapClass::stable, MapClass::chattering,
                              MapClass::saturated, MapClass::unstable})
    entry(QLatin1String(name_of(each)), [&](const QPointF& at) {
      painter.fillRect(QRectF(at.x() - 6, at.y() - 5, 12, 10), colour_of(each));
    });
  // As they are seen on the map: on a window of its own shade a line may be lost.
  const auto stroke = [&painter](Qt::PenStyle style) {
    return [&painter, style](const QPointF& at) {
      painter.fillRect(QRectF(at.x() - 8, at.y() - 5, 16, 10), colour_of(MapClass::passive));
      QPainterPath path(at - QPointF(8, 0));
      path.lineTo(at + QPointF(8, 0));
      paint_stroke(painter, path, style);
    };
  };
  entry(QStringLiteral("limit, measured"), stroke(Qt::SolidLine));
  entry(QStringLiteral("in theory"), stroke(Qt::DashLine));
  entry(QStringLiteral("passive in theory"), stroke(Qt::DotLine));
  if (!contact_.empty())
    entry(QStringLiteral("contact now"), [&](const QPointF& at) {
      paint_outline(painter, QRectF(at.x() - 8, at.y() - 5, 16, 10));
    });
  entry(QStringLiteral("gains now"), [&](const QPointF& at) { paint_disc(painter, at); });
  entry(QStringLiteral("recommended"), [&](const QPointF& at) { paint_diamond(painter, at); });
}

}  // namespace sonde::ui
