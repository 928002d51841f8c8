// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/study/assembly/insertion_map.hpp"
#include "ui/base/format.hpp"
#include "ui/panels/chart_canvas.hpp"

namespace sonde::ui {

class ChartLegend;

/// How a part may be off at the mouth, and how far it goes in there.
struct OffsetMap {
  InsertionMap at;
  std::vector<double> free;  ///< m, as free_travels has them
  double wanted = 0;         ///< m of travel that count as in
};

/// A point of such a map.
struct MapPlace {
  std::size_t offset = 0, tilt = 0;
};

/// A map of offsets to either side by tilts: a cell for each, in the colour of whether it goes in.
/// A click asks for a point.
class OffsetPlot : public ChartCanvas {
  Q_OBJECT
 public:
  explicit OffsetPlot(QWidget* parent);
  ~OffsetPlot() override;
  void set_map(OffsetMap map, const LengthUnit& unit);
  void choose(std::optional<MapPlace> place);
  const OffsetMap& map() const { return map_; }
  /// The middle of a point's cell, px.
  QPointF place_of(const MapPlace& place) const;
  QSize sizeHint() const override { return {240, 240}; }
  QSize minimumSizeHint() const override { return {200, 190}; }

 signals:
  void asked(const MapPlace& place);

 protected:
  void arrange(double ratio) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  struct Map;
  /// Of the cells, px.
  QRectF area() const;

  std::unique_ptr<Map> drawn_;
  ChartLegend* legend_;
  OffsetMap map_;
  std::optional<MapPlace> chosen_;
};

}  // namespace sonde::ui
