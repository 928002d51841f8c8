// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/curves_dialog.hpp"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/base/format.hpp"
#include "ui/panels/study_chart.hpp"

namespace sonde::ui {

CurvesDialog::CurvesDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("curves_dialog"));
  auto* layout = new QVBoxLayout(this);
  choice_ = new QComboBox(this);
  choice_->setObjectName(QStringLiteral("curves_choice"));
  layout->addWidget(choice_);
  chart_ = new StudyChart(this);
  layout->addWidget(chart_, 1);
  words_ = new QLabel(this);
  words_->setWordWrap(true);
  words_->setText(QStringLiteral(
      "In closed form, of one axis of the device against a linear wall, without friction and, but "
      "for the rise of a force, without a hand. Save… writes these curves with their numbers."));
  layout->addWidget(words_);
  connect(choice_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &CurvesDialog::show_chosen);
}

void CurvesDialog::show_curves(const QString& device, const std::vector<DeviceCurves>& curves) {
  setWindowTitle(QStringLiteral("%1 alone").arg(device));
  const QString before = choice_->currentText();
  panels_.clear();
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const DeviceCurves& each : curves)
      for (const ChartPanel& panel : each.chart.panels) {
        panels_.push_back(panel);
        choice_->addItem(text(panel.title));
      }
    choice_->setCurrentIndex(std::max(choice_->findText(before), panels_.empty() ? -1 : 0));
  }
  show_chosen();
}

void CurvesDialog::show_chosen() {
  const int at = choice_->currentIndex();
  chart_->setVisible(at >= 0);
  if (at >= 0) chart_->set_panel(panels_[static_cast<std::size_t>(at)]);
}

}  // namespace sonde::ui
