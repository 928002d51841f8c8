// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_plot.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>

#include <QLabel>
#include <QMouseEvent>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/base/theme.hpp"
#include "ui/panels/chart_legend.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

// px
constexpr double cells_left = 48, cells_right = 22, cells_foot = 38;
constexpr double cells_head = 20, cells_head_untitled = 6;
constexpr double tick_room = 24;  // of a damping
constexpr double name_edge = 5;

const QColor light_line(240, 244, 248);

constexpr std::array classes{MapClass::passive, MapClass::stable, MapClass::chattering,
                             MapClass::saturated, MapClass::unstable};

QColor colour_of(MapClass map_class) {
  constexpr std::array rgb{0xa1403bu, 0x4f7fb0u, 0xc9952fu, 0x6f9440u, 0x2c7a58u};
  return QColor(QRgb(rgb.at(static_cast<std::size_t>(map_class))));
}

/// Lines and points as they are seen on the map: on a window of its own shade one may be lost.
std::vector<LegendEntry> map_legend() {
  std::vector<LegendEntry> entries;
  entries.reserve(classes.size());
  for (const MapClass each : classes)
    entries.push_back({QStringLiteral("■"), colour_of(each), QLatin1String(name_of(each))});
  const QColor behind = colour_of(MapClass::passive);
  const auto on_map = [&](const char* mark, const QColor& colour, const char* words) {
    entries.push_back({QString::fromUtf8(mark), colour, QLatin1String(words), behind});
  };
  on_map("——", light_line, "limit, measured");
  on_map("– –", light_line, "in theory");
  on_map("····", light_line, "passive in theory");
  // There at all times: with it, the cells would move as contacts come and go.
  on_map("□", colour::contact, "contact now");
  on_map("●", Qt::white, "gains now");
  on_map("◆", colour::ghost, "recommended");
  return entries;
}

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

/// What is drawn over the cells, from below.
enum Mark : std::size_t {
  stable,
  theory_stable,
  theory_passive,
  contact_frame,
  contact_stable,
  recommended_across,
  recommended_at,
  now_across,
  now_at,
  mark_count
};

/// A line, or points, with a dark edge: to be told from every colour of the map.
struct Look {
  QColor edge;
  double edge_width;  ///< px
  QColor colour;
  double width;  ///< px
  int line = vtkPen::SOLID_LINE, marker = VTK_MARKER_NONE;
};
const std::array<Look, mark_count>& looks() {
  constexpr int solid = vtkPen::SOLID_LINE;
  static const QColor faint(0, 0, 0, 120), across(0, 0, 0, 160);
  static const std::array<Look, mark_count> all{
      {{faint, 3.2, light_line, 1.6},
       {faint, 3.2, light_line, 1.6, vtkPen::DASH_LINE},
       {faint, 3.2, light_line, 1.6, vtkPen::DOT_LINE},
       {Qt::black, 3.5, colour::contact, 1.8},
       {Qt::black, 6, colour::contact, 3.5},
       {across, 4, colour::ghost, 2},
       {Qt::black, 14, colour::ghost, 11, solid, VTK_MARKER_DIAMOND},
       {across, 4, Qt::white, 2},
       {Qt::black, 12, Qt::white, 10, solid, VTK_MARKER_CIRCLE}}};
  return all;
}

vtkPlotPoints* add_mark(vtkChartXY& chart, const Look& look, const QColor& colour) {
  const bool line = look.marker == VTK_MARKER_NONE;
  auto* plot = vtkPlotPoints::SafeDownCast(line ? add_line(chart) : add_markers(chart));
  plot->SetMarkerStyle(look.marker);
  set_pen(*plot->GetPen(), colour);
  return plot;
}

}  // namespace

/// The axes count decimal logarithms of stiffness, and dampings or rows.
struct MapPlot::Drawn {
  explicit Drawn(vtkContextScene& scene) {
    set_up(*chart);
    chart->SetVisible(false);
    for (const int place : {vtkAxis::BOTTOM, vtkAxis::LEFT})
      chart->GetAxis(place)->SetGridVisible(false);  // it would be beneath the cells
    scene.AddItem(chart);
    for (const MapClass each : classes) cells.push_back(add_boxes(*chart, colour_of(each)));
    grid = add_line(*chart);
    set_pen(*grid->GetPen(), QColor(0, 0, 0, 70));
    for (const Look& look : looks()) {
      edges.push_back(add_mark(*chart, look, look.edge));
      marks.push_back(add_mark(*chart, look, look.colour));
      marks.back()->GetPen()->SetLineType(look.line);
    }
  }

  void fill_cells(const StabilityMap& map) {
    for (std::size_t i = 0; i < classes.size(); ++i) {
      std::vector<QRectF> boxes;
      for (const MapRow& row : map.rows)
        for (const MapRow::Stretch& stretch : row.stretches)
          if (stretch.map_class == classes.at(i))
            boxes.emplace_back(QPointF(std::log10(stretch.from), row.from),
                               QPointF(std::log10(stretch.to), row.to));
      set_boxes(*cells[i], boxes);
    }
  }

  void set_axis(int place, double from, double to, const std::vector<AxisMark>& at) {
    chart->GetAxis(place)->SetRange(from, to);
    set_marks(*chart->GetAxis(place), at);
  }

  void draw(std::size_t mark, const std::vector<QPointF>& points) {
    for (vtkPlotPoints* plot : {edges[mark], marks[mark]}) {
      set_points(*plot, points);
      plot->SetVisible(!points.empty());
    }
  }

  void widen(double ratio) {
    const auto set = [ratio](vtkPlotPoints& plot, double width) {
      plot.SetWidth(float(width * ratio));
      plot.SetMarkerSize(float(width * ratio));
    };
    for (std::size_t i = 0; i < mark_count; ++i) {
      set(*edges[i], looks().at(i).edge_width);
      set(*marks[i], looks().at(i).width);
    }
    grid->SetWidth(float(ratio));
  }

  vtkNew<vtkChartXY> chart;
  std::vector<vtkPlot*> cells;
  vtkPlot* grid = nullptr;
  std::vector<vtkPlotPoints*> edges, marks;
};

MapPlot::MapPlot(QWidget* parent)
    : ChartCanvas(parent),
      drawn_(std::make_unique<Drawn>(scene())),
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
  drawn_->fill_cells(map_);
  drawn_->draw(stable, path(map_.rows, &MapRow::stable));
  drawn_->draw(theory_stable, path(map_.rows, &MapRow::theory_stable));
  drawn_->draw(theory_passive, path(map_.rows, &MapRow::theory_passive));
  drawn_->chart->SetTitle(map_.over_damping ? label_of(map_.axis, "damping", damping_key(map_.axis),
                                                       damping_unit(map_.axis))
                                                  .toStdString()
                                            : std::string());
  drawn_->chart->GetAxis(vtkAxis::BOTTOM)
      ->SetTitle(
          label_of(map_.axis, "stiffness", stiffness_key(map_.axis), stiffness_unit(map_.axis))
              .toStdString());
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
  drawn_->chart->SetVisible(!map_.rows.empty());
  if (map_.rows.empty()) return;
  legend_->arrange();
  const QRectF cells = area();
  place_chart(*drawn_->chart, cells, ratio);
  set_theme(*drawn_->chart, palette());
  arrange_axes(cells);
  arrange_names(cells);
  draw_contact(cells);
  draw_point(recommended_, recommended_at, recommended_across);
  draw_point(now_, now_at, now_across);
  drawn_->widen(ratio);
  drawn_->chart->RecalculateBounds();
}

void MapPlot::arrange_axes(const QRectF& cells) {
  const QRectF all = ranges();
  const std::vector<AxisMark> upright = log_marks(all.left(), all.right(), cells.width());
  std::vector<AxisMark> across;
  if (map_.over_damping)
    across = round_marks(all.top(), all.bottom(), cells.height(), tick_room);
  else
    for (const MapRow& row : map_.rows) across.push_back({row.to, {}});
  drawn_->set_axis(vtkAxis::BOTTOM, all.left(), all.right(), upright);
  drawn_->set_axis(vtkAxis::LEFT, all.top(), all.bottom(), across);
  std::vector<QPointF> grid;
  for (const auto& [x, text] : upright)
    if (!text.isEmpty()) grid.insert(grid.end(), {{x, all.top()}, {x, all.bottom()}, line_end()});
  for (const auto& [y, text] : across)
    grid.insert(grid.end(), {{all.left(), y}, {all.right(), y}, line_end()});
  set_points(*drawn_->grid, grid);
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
  drawn_->draw(contact_frame, frame);
  drawn_->draw(contact_stable, path(own, &MapRow::stable));
}

/// Over situations with a line across, for the gains are the same in each.
void MapPlot::draw_point(const std::optional<MapPoint>& point, std::size_t mark, std::size_t line) {
  std::vector<QPointF> at, across;
  if (point) at.push_back(on_axes(*point));
  if (point && !map_.over_damping)
    across = {{at[0].x(), ranges().top()}, {at[0].x(), ranges().bottom()}};
  drawn_->draw(line, across);
  drawn_->draw(mark, at);
}

}  // namespace sonde::ui
