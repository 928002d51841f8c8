// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>
#include <deque>
#include <vector>

#include "engine/recording/curves.hpp"

namespace sonde::ui {

/// A strip of the last ten seconds of one quantity, with its largest value at the upper left. Qt
/// draws it, in the look of the charts: two strips are there from the start, each with 55 pixels of
/// height for its curve, and as a chart of VTK each would take 65 to 110 ms for its first picture
/// (of a processor that draws itself) and 6.5 MB.
class HistoryPlot : public QWidget {
 public:
  HistoryPlot(const QString& title, const QColor& colour, QWidget* parent);
  /// `time` in s, not falling; if it falls, the strip starts over.
  void add(double time, double value);
  /// Only these, in the order of their times (s), with `until` at the right. One that is not a
  /// number breaks the line.
  void show(const std::vector<CurvePoint>& points, double until);
  void clear();
  static constexpr double span = 10;  ///< s
  /// The factor and the unit's name for display.
  void set_unit(double scale, const QString& name);
  QSize sizeHint() const override { return {200, 74}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_;
  QColor colour_;
  double scale_ = 1;
  QString unit_;
  std::deque<CurvePoint> samples_;
  double until_ = 0;  ///< s, at the right
};

}  // namespace sonde::ui
