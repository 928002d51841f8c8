// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QLabel>
#include <vector>

namespace sonde::ui {

/// What is drawn in a chart, and what it stands for.
struct LegendEntry {
  QString mark;  ///< letters that look like it: "■"
  QColor colour;
  QString words;
  QColor behind = {};  ///< what it is drawn on; not valid: the window
};

/// The legend at the foot of a chart, as high as its width requires. No entry is broken.
class ChartLegend : public QLabel {
 public:
  explicit ChartLegend(QWidget* chart);
  void set_entries(std::vector<LegendEntry> entries);
  /// Px that it needs at the foot of the chart.
  double room() const;
  /// Takes its place there, and the theme's colours.
  void arrange();

 private:
  std::vector<LegendEntry> entries_;
};

}  // namespace sonde::ui
