// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_chart.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/study/charts/svg_elements.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/chart_legend.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

// px
constexpr double chart_left = 64, chart_right = 22, chart_head = 26, chart_foot = 40;
constexpr double mark_size = 5;

QColor colour_of(const ChartPanel& panel, std::size_t series) {
  return QColor(text(svg::series_color(panel.series[series].color.value_or(series))));
}

ChartScale scale_of(const ChartPanel& panel, const ChartAxis& axis,
                    std::vector<double> ChartSeries::*values) {
  std::vector<double> all;
  for (const ChartSeries& series : panel.series)
    all.insert(all.end(), (series.*values).begin(), (series.*values).end());
  return {axis, all};
}

/// Places along both axes, 0 to 1; one that is not a number breaks the line.
std::vector<QPointF> places_of(const ChartSeries& series, const ChartScale& x,
                               const ChartScale& y) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<QPointF> places;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const std::optional<double> across = x.place(series.x[i]), up = y.place(series.y[i]);
    places.emplace_back(across && up ? *across : none, across && up ? *up : none);
  }
  return places;
}

const char* mark_of(ChartSeries::Form form) {
  switch (form) {
    case ChartSeries::Form::line:
      break;
    case ChartSeries::Form::dashed:
      return "– –";
    case ChartSeries::Form::points:
      return "●";
  }
  return "——";
}

void set_scale(vtkAxis& axis, const ChartScale& scale, const std::string& label) {
  std::vector<AxisMark> marks;
  for (const ChartScale::Tick& tick : scale.ticks()) marks.push_back({tick.place, text(tick.text)});
  axis.SetRange(0, 1);
  axis.SetTitle(label);
  set_marks(axis, marks);
}

}  // namespace

struct StudyChart::Drawn {
  explicit Drawn(vtkContextScene& scene) {
    set_up(*chart);
    scene.AddItem(chart);
  }

  void fill(const ChartPanel& panel) {
    chart->ClearPlots();
    plots.clear();
    chart->SetTitle(panel.title);
    const ChartScale x = scale_of(panel, panel.x, &ChartSeries::x);
    const ChartScale y = scale_of(panel, panel.y, &ChartSeries::y);
    set_scale(*chart->GetAxis(vtkAxis::BOTTOM), x, panel.x.label);
    set_scale(*chart->GetAxis(vtkAxis::LEFT), y, panel.y.label);
    for (const ChartSeries& series : panel.series) {
      const bool points = series.form == ChartSeries::Form::points;
      vtkPlot* const plot = points ? add_markers(*chart) : add_line(*chart);
      if (points) vtkPlotPoints::SafeDownCast(plot)->SetMarkerStyle(VTK_MARKER_CIRCLE);
      if (series.form == ChartSeries::Form::dashed) plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
      set_points(*plot, places_of(series, x, y));
      plots.push_back(plot);
    }
  }

  vtkNew<vtkChartXY> chart;
  std::vector<vtkPlot*> plots;  ///< of the series, in their order
};

StudyChart::StudyChart(QWidget* parent)
    : ChartCanvas(parent),
      drawn_(std::make_unique<Drawn>(scene())),
      legend_(new ChartLegend(this)) {
  setObjectName(QStringLiteral("study_chart"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

StudyChart::~StudyChart() = default;

void StudyChart::set_panel(ChartPanel panel) {
  panel_ = std::move(panel);
  drawn_->fill(panel_);
  redraw();
}

void StudyChart::arrange(double ratio) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < panel_.series.size(); ++i) {
    const ChartSeries& series = panel_.series[i];
    const QColor colour = readable(colour_of(panel_, i), palette());
    const bool points = series.form == ChartSeries::Form::points;
    set_pen(*drawn_->plots[i]->GetPen(), colour);
    drawn_->plots[i]->SetWidth(float((points ? mark_size : 1.8) * ratio));
    if (!series.name.empty())
      entries.push_back({QString::fromUtf8(mark_of(series.form)), colour, text(series.name)});
  }
  legend_->set_entries(std::move(entries));
  legend_->arrange();
  const double foot = chart_foot + legend_->room();
  const double wide = std::max(width() - chart_left - chart_right, 1.0);
  const double high = std::max(height() - foot - chart_head, 1.0);
  set_theme(*drawn_->chart, palette());
  place_chart(*drawn_->chart, {chart_left, chart_head, wide, high}, ratio);
  drawn_->chart->RecalculateBounds();
}

}  // namespace sonde::ui
