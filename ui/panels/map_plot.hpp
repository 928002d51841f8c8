// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/chart_canvas.hpp"
#include "ui/tuning/stability_map.hpp"

class QLabel;

namespace sonde::ui {

class ChartLegend;
class MapChart;
enum class MapMark : std::size_t;

/// A stability map: coloured cells of stiffness by damping, the measured and the theoretical limits
/// as lines, the present and the recommended gains as points. Where rows are situations, the points
/// are lines across, because the gains are the same in each. A point outside the map is drawn at
/// its edge. The contact that holds the probe now is marked: the names of its rows, and its own
/// boundary. A click, or a drag with the left button, asks for the gains there.
class MapPlot : public ChartCanvas {
  Q_OBJECT
 public:
  explicit MapPlot(QWidget* parent);
  ~MapPlot() override;

  void set_map(const StabilityMap& map);
  const StabilityMap& map() const { return map_; }
  void set_now(std::optional<MapPoint> point);
  void set_recommended(std::optional<MapPoint> point);
  /// The map of the present contact's kind alone; no rows: there is none, or it was not studied.
  void set_contact(const std::string& kind, const StabilityMap& of_kind);
  const std::string& contact() const { return contact_; }
  const std::optional<MapPoint>& now() const { return now_; }
  const std::optional<MapPoint>& recommended() const { return recommended_; }

  /// Where a point is drawn, px; on a map of situations in the lowest row.
  QPointF place(const MapPoint& point) const;
  /// Where the cells end below, px.
  double bottom() const;
  /// The gains at a place, px, brought into the map; stiffness to three digits, as it is shown. On
  /// a map of situations the damping is 0.
  MapPoint point_at(const QPointF& at) const;
  /// The map's class at that place; on a map of situations the worst; none outside the map.
  std::optional<MapClass> map_class(const MapPoint& point) const;

  QSize sizeHint() const override { return {330, 310}; }
  QSize minimumSizeHint() const override { return {270, 280}; }

 signals:
  void asked(const MapPoint& point);

 protected:
  void arrange(double ratio) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  /// Of the cells, px.
  QRectF area() const;
  /// In the units of the axes, rising from the top of the rectangle to its bottom.
  QRectF ranges() const;
  QPointF on_screen(const QPointF& on_axes, const QRectF& cells) const;
  /// Brought into the map.
  QPointF on_axes(const MapPoint& point) const;
  /// Through the dampings; over situations, an upright stroke in each row. None off the map.
  std::vector<QPointF> path(const std::vector<MapRow>& rows, double MapRow::*limit) const;
  void set_names();
  void arrange_axes(const QRectF& cells);
  void arrange_names(const QRectF& cells);
  void draw_contact(const QRectF& cells);
  void draw_point(const std::optional<MapPoint>& point, MapMark mark, MapMark line);

  std::unique_ptr<MapChart> chart_;
  ChartLegend* legend_;
  std::vector<QLabel*> names_;  ///< of the rows that are situations
  StabilityMap map_, of_contact_;
  std::string contact_;
  std::optional<MapPoint> now_, recommended_;
  bool dragging_ = false;
};

}  // namespace sonde::ui
