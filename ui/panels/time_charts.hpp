// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "engine/recording/curves.hpp"
#include "ui/base/format.hpp"
#include "ui/panels/chart_canvas.hpp"

namespace sonde::ui {

/// The name and the style of a curve.
struct CurveStyle {
  Curve curve;
  QString name;
  QString unit;
  double scale;  ///< from SI to the unit
  QColor colour;
};
/// In the order of Curve.
std::vector<CurveStyle> curve_styles(const LengthUnit& unit);

/// A curve to draw.
struct ChartLine {
  enum class Stroke { solid, dashed, dotted };
  const Curves* of;
  Curve curve;
  Stroke stroke = Stroke::solid;
};

/// What the charts show.
struct ChartView {
  std::vector<ChartLine> lines;
  double from = 0, to = 1;  ///< s
  double cursor = 0;        ///< s
  LengthUnit unit;
};

/// Curves over one time axis, a chart for each unit, drawn by VTK. However many ticks there are, it
/// draws as many points as there are pixels: the lowest and the highest of each column.
class TimeCharts : public ChartCanvas {
  Q_OBJECT
 public:
  explicit TimeCharts(QWidget* parent);
  ~TimeCharts() override;

  void draw(const ChartView& view);
  /// How many points the last picture has of all lines.
  std::size_t points() const;
  /// The time at a place in Qt's pixels from the left; s.
  double time_at(double x) const;

 signals:
  void clicked(double time);
  void hovered(double time);
  void dragged(double seconds);             ///< the picture is to move so far
  void zoomed(double factor, double time);  ///< about that time

 protected:
  void arrange(double ratio) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  double pressed_ = -1;  ///< pixels from the left; below zero: not
  double last_ = 0;
  bool moved_ = false;
};

}  // namespace sonde::ui
