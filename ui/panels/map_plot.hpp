// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "ui/tuning/stability_map.hpp"

class QPainter;

namespace sonde::ui {

/// Gains as a place on a map.
struct MapPoint {
  double stiffness = 0;
  double damping = 0;
};

/// A stability map: coloured cells of stiffness by damping, the measured and the theoretical limits
/// as lines, the present and the recommended gains as points. Where rows are situations, the points
/// are lines across, because the gains are the same in each. A point outside the map is drawn at
/// its edge.
class MapPlot : public QWidget {
 public:
  explicit MapPlot(QWidget* parent);

  void set_map(const StabilityMap& map);
  const StabilityMap& map() const { return map_; }
  void set_now(std::optional<MapPoint> point);
  void set_recommended(std::optional<MapPoint> point);
  const std::optional<MapPoint>& now() const { return now_; }
  const std::optional<MapPoint>& recommended() const { return recommended_; }

  /// Where a point is drawn, px; on a map of situations in the lowest row.
  QPointF place(const MapPoint& point) const;
  /// The map's class at that place; on a map of situations the worst; none outside the map.
  std::optional<MapClass> map_class(const MapPoint& point) const;

  QSize sizeHint() const override { return {330, 310}; }
  QSize minimumSizeHint() const override { return {270, 280}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Scales;
  QRectF area() const;
  void paint_cells(QPainter& painter, const Scales& scales) const;
  void paint_stiffness(QPainter& painter, const Scales& scales) const;
  void paint_rows(QPainter& painter, const Scales& scales) const;
  void paint_limit(QPainter& painter, const Scales& scales, double MapRow::*limit,
                   Qt::PenStyle style) const;
  void paint_points(QPainter& painter) const;
  void paint_legend(QPainter& painter) const;

  StabilityMap map_;
  std::optional<MapPoint> now_, recommended_;
};

}  // namespace sonde::ui
