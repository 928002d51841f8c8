// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_plot.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>

#include <QLabel>
#include <QMouseEvent>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/base/theme.hpp"
#include "ui/panels/chart_legend.hpp"
#include "ui/panels/chart_style.hpp"
#include "ui/panels/map_chart.hpp"

namespace sonde::ui {
namespace {

// px
constexpr double cells_left = 48, cells_right = 22, cells_foot = 38;
constexpr double cells_head = 20, cells_head_untitled = 6;
constexpr double tick_room = 24;  // of a damping
constexpr double name_edge = 5;

QString label_of(GainAxis axis, const char* what, const char* key, const QString& unit) {
  return QStringLiteral("%1 %2, %3%4")
      .arg(QLatin1String(what), QLatin1String(key), unit,
           axis == GainAxis::rotation ? QStringLiteral(" (rotation)") : QString());
}

/// Ends a line.
QPointF line_end() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {none, none};
}

}  // namespace

MapPlot::MapPlot(QWidget* parent)
    : ChartCanvas(parent),
      chart_(std::make_unique<MapChart>(scene())),
      legend_(new ChartLegend(this)) {
  setObjectName(QStringLiteral("map_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMouseTracking(true);
  setToolTip(QStringLiteral("A click sets the gains there; Undo takes them back."));
  legend_->set_entries(map_legend());
}

MapPlot::~MapPlot() = default;

void MapPlot::set_map(const StabilityMap& map) {
  map_ = map;
  chart_->fill_cells(map_);
  chart_->draw(MapMark::stable, path(map_.rows, &MapRow::stable));
  chart_->draw(MapMark::theory_stable, path(map_.rows, &MapRow::theory_stable));
  chart_->draw(MapMark::theory_passive, path(map_.rows, &MapRow::theory_passive));
  chart_->set_titles(
      map_.over_damping
          ? label_of(map_.axis, "damping", damping_key(map_.axis), damping_unit(map_.axis))
          : QString(),
      label_of(map_.axis, "stiffness", stiffness_key(map_.axis), stiffness_unit(map_.axis)));
  set_names();
  redraw();
}

void MapPlot::set_now(std::optional<MapPoint> point) {
  if (point == now_) return;
  now_ = point;
  redraw();
}

void MapPlot::set_recommended(std::optional<MapPoint> point) {
  if (point == recommended_) return;
  recommended_ = point;
  redraw();
}

void MapPlot::set_contact(const std::string& kind, const StabilityMap& of_kind) {
  contact_ = of_kind.rows.empty() ? std::string() : kind;
  of_contact_ = of_kind;
  redraw();
}

void MapPlot::set_names() {
  for (QLabel* name : names_) delete name;
  names_.clear();
  if (map_.over_damping) return;
  for (const MapRow& row : map_.rows) {
    names_.push_back(new QLabel(row.label, this));
    names_.back()->setFont(legend_->font());
    names_.back()->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    names_.back()->setAutoFillBackground(true);
    names_.back()->show();
  }
}

QRectF MapPlot::area() const {
  double left = cells_left;
  for (const QLabel* name : names_) left = std::max(left, name->sizeHint().width() + 2 * name_edge);
  const double head = map_.over_damping ? cells_head : cells_head_untitled;
  return {left, head, std::max(width() - left - cells_right, 1.0),
          std::max(height() - head - cells_foot - legend_->room(), 1.0)};
}

QRectF MapPlot::ranges() const {
  const bool none = map_.rows.empty();
  return {QPointF(std::log10(map_.low), none ? 0 : map_.rows.front().from),
          QPointF(std::log10(map_.high), none ? 1 : map_.rows.back().to)};
}

QPointF MapPlot::on_axes(const MapPoint& point) const {
  const QRectF all = ranges();
  const bool any_row = map_.over_damping || map_.rows.empty();
  const double row = any_row ? point.damping : (all.top() + map_.rows.front().to) / 2;
  return {std::log10(std::clamp(point.stiffness, map_.low, map_.high)),
          std::clamp(row, all.top(), all.bottom())};
}

QPointF MapPlot::on_screen(const QPointF& on_axes, const QRectF& cells) const {
  const QRectF all = ranges();
  return {cells.left() + cells.width() * (on_axes.x() - all.left()) / all.width(),
          cells.bottom() - cells.height() * (on_axes.y() - all.top()) / all.height()};
}

QPointF MapPlot::place(const MapPoint& point) const { return on_screen(on_axes(point), area()); }

double MapPlot::bottom() const { return area().bottom(); }

MapPoint MapPlot::point_at(const QPointF& at) const {
  const QRectF within = area();
  const double x = std::clamp((at.x() - within.left()) / within.width(), 0.0, 1.0);
  const double y = std::clamp((within.bottom() - at.y()) / within.height(), 0.0, 1.0);
  const double stiffness = map_.low * std::pow(map_.high / map_.low, x);
  const double digit = std::pow(10, std::floor(std::log10(stiffness)) - 2);
  MapPoint point{std::clamp(std::round(stiffness / digit) * digit, map_.low, map_.high), 0};
  if (map_.over_damping) point.damping = ranges().top() + y * ranges().height();
  return point;
}

void MapPlot::mousePressEvent(QMouseEvent* event) {
  const bool on_map = !map_.rows.empty() && area().contains(event->localPos());
  if (event->button() != Qt::LeftButton || !on_map) return ChartCanvas::mousePressEvent(event);
  dragging_ = true;
  emit asked(point_at(event->localPos()));
}

void MapPlot::mouseMoveEvent(QMouseEvent* event) {
  const bool held = event->buttons() & Qt::LeftButton;
  if (held && dragging_) emit asked(point_at(event->localPos()));
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

void MapPlot::arrange(double ratio) {
  legend_->setVisible(!map_.rows.empty());
  chart_->show(!map_.rows.empty());
  if (map_.rows.empty()) return;
  legend_->arrange();
  const QRectF cells = area();
  place_chart(chart_->chart(), cells, ratio);
  set_theme(chart_->chart(), palette());
  arrange_axes(cells);
  arrange_names(cells);
  draw_contact(cells);
  draw_point(recommended_, MapMark::recommended_at, MapMark::recommended_across);
  draw_point(now_, MapMark::now_at, MapMark::now_across);
  chart_->widen(ratio);
  chart_->chart().RecalculateBounds();
}

void MapPlot::arrange_axes(const QRectF& cells) {
  const QRectF all = ranges();
  const std::vector<AxisMark> upright = log_marks(all.left(), all.right(), cells.width());
  std::vector<AxisMark> across;
  if (map_.over_damping)
    across = round_marks(all.top(), all.bottom(), cells.height(), tick_room);
  else
    for (const MapRow& row : map_.rows) across.push_back({row.to, {}});
  chart_->set_axis(vtkAxis::BOTTOM, all.left(), all.right(), upright);
  chart_->set_axis(vtkAxis::LEFT, all.top(), all.bottom(), across);
  std::vector<QPointF> grid;
  for (const auto& [x, text] : upright)
    if (!text.isEmpty()) grid.insert(grid.end(), {{x, all.top()}, {x, all.bottom()}, line_end()});
  for (const auto& [y, text] : across)
    grid.insert(grid.end(), {{all.left(), y}, {all.right(), y}, line_end()});
  chart_->set_grid(grid);
}

/// On a plate where they are of the present contact's kind.
void MapPlot::arrange_names(const QRectF& cells) {
  const int wide = qRound(cells.left()) - 2;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const MapRow& row = map_.rows[i];
    const bool present = !contact_.empty() && row.kind == contact_;
    QPalette colours = palette();
    colours.setColor(QPalette::Window, present ? colour::contact : plot_background(palette()));
    colours.setColor(QPalette::WindowText, present ? Qt::black : faint_text(palette()));
    names_[i]->setPalette(colours);
    const int high = names_[i]->sizeHint().height();
    const double middle = on_screen({0, (row.from + row.to) / 2}, cells).y();
    names_[i]->setGeometry(0, qRound(middle - high / 2.0), wide, high);
  }
}

std::vector<QPointF> MapPlot::path(const std::vector<MapRow>& rows, double MapRow::*limit) const {
  std::vector<QPointF> path;
  for (const MapRow& row : rows) {
    const double x = std::log10(row.*limit);
    if (!(row.*limit >= map_.low && row.*limit <= map_.high))
      path.push_back(line_end());
    else if (map_.over_damping)
      path.emplace_back(x, row.damping);
    else
      path.insert(path.end(), {{x, row.from}, {x, row.to}, line_end()});
  }
  return path;
}

/// Its boundary; over situations a frame about its rows too, a pixel within them.
void MapPlot::draw_contact(const QRectF& cells) {
  const QRectF all = ranges();
  const double wide = all.width() / cells.width(), high = all.height() / cells.height();
  std::vector<MapRow> own = map_.over_damping ? of_contact_.rows : map_.rows;
  std::vector<QPointF> frame;
  if (!map_.over_damping) {
    std::erase_if(own, [this](const MapRow& row) { return row.kind != contact_; });
    for (const MapRow& row : own) {
      const QPolygonF box = QRectF(QPointF(all.left(), row.from), QPointF(all.right(), row.to))
                                .adjusted(wide, high, -wide, -high);
      frame.insert(frame.end(), box.begin(), box.end());
      frame.push_back(line_end());
    }
  }
  chart_->draw(MapMark::contact_frame, frame);
  chart_->draw(MapMark::contact_stable, path(own, &MapRow::stable));
}

/// Over situations with a line across, for the gains are the same in each.
void MapPlot::draw_point(const std::optional<MapPoint>& point, MapMark mark, MapMark line) {
  std::vector<QPointF> at, across;
  if (point) at.push_back(on_axes(*point));
  if (point && !map_.over_damping)
    across = {{at[0].x(), ranges().top()}, {at[0].x(), ranges().bottom()}};
  chart_->draw(line, across);
  chart_->draw(mark, at);
}

}  // namespace sonde::ui
