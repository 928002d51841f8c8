// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/study/charts/svg_chart.hpp"
#include "ui/panels/chart_canvas.hpp"

namespace sonde::ui {

class ChartLegend;

/// A chart of a study, on screen as it is on paper: lines and points with their legend. Cells are
/// not drawn.
class StudyChart : public ChartCanvas {
 public:
  explicit StudyChart(QWidget* parent);
  ~StudyChart() override;
  void set_panel(ChartPanel panel);
  QSize sizeHint() const override { return {520, 380}; }
  QSize minimumSizeHint() const override { return {300, 240}; }

 protected:
  void arrange(double ratio) override;

 private:
  struct Drawn;

  ChartPanel panel_;
  std::unique_ptr<Drawn> drawn_;
  ChartLegend* legend_;
};

}  // namespace sonde::ui
