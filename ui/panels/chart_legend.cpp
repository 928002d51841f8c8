// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_legend.hpp"

#include <utility>

#include "ui/base/theme.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

constexpr int legend_edge = 4;  // px

QString unbroken(QString text) { return text.replace(QLatin1Char(' '), QStringLiteral("&nbsp;")); }

QString text_of(const LegendEntry& entry) {
  QString style = QStringLiteral("color:") + entry.colour.name();
  QString mark = entry.mark;
  if (entry.behind.isValid()) {
    style.prepend(QStringLiteral("background:%1;").arg(entry.behind.name()));
    mark = QStringLiteral(" %1 ").arg(mark);
  }
  return QStringLiteral("<span style='%1'>%2</span>&nbsp;%3")
      .arg(style, unbroken(mark), unbroken(entry.words));
}

QString text_of(const std::vector<LegendEntry>& entries, const QPalette& palette) {
  QStringList texts;
  for (const LegendEntry& entry : entries) texts << text_of(entry);
  return QStringLiteral("<span style='color:%1'>%2</span>")
      .arg(faint_text(palette).name(), texts.join(QStringLiteral("&nbsp; ")));
}

}  // namespace

ChartLegend::ChartLegend(QWidget* chart) : QLabel(chart) {
  setFont(chart_font(chart->font()));
  setTextFormat(Qt::RichText);
  setWordWrap(true);
}

void ChartLegend::set_entries(std::vector<LegendEntry> entries) {
  entries_ = std::move(entries);
  setText(text_of(entries_, parentWidget()->palette()));
}

double ChartLegend::room() const {
  return heightForWidth(parentWidget()->width() - 2 * legend_edge) + legend_edge;
}

void ChartLegend::arrange() {
  setText(text_of(entries_, parentWidget()->palette()));
  const QWidget& chart = *parentWidget();
  const int wide = chart.width() - 2 * legend_edge, high = heightForWidth(wide);
  setGeometry(legend_edge, chart.height() - high - legend_edge, wide, high);
}

}  // namespace sonde::ui
