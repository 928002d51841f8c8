// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/work_row.hpp"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace sonde::ui {
namespace {

constexpr int bar_steps = 1000;

}  // namespace

WorkRow::WorkRow(const QString& text, const QString& object, QWidget* parent)
    : QWidget(parent),
      start_(new QPushButton(text, this)),
      stop_(new QPushButton(QStringLiteral("Stop"), this)),
      bar_(new QProgressBar(this)) {
  start_->setObjectName(object);
  stop_->setObjectName(object + QStringLiteral("_stop"));
  bar_->setRange(0, bar_steps);
  bar_->setTextVisible(false);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(start_);
  row->addWidget(bar_, 1);
  row->addWidget(stop_);
  connect(start_, &QPushButton::clicked, this, &WorkRow::start_wanted);
  connect(stop_, &QPushButton::clicked, this, &WorkRow::stop_wanted);
  show_progress({});
}

void WorkRow::show_progress(std::optional<double> fraction) {
  bar_->setVisible(fraction.has_value());
  stop_->setVisible(fraction.has_value());
  start_->setVisible(!fraction.has_value());
  bar_->setValue(static_cast<int>(fraction.value_or(0) * bar_steps));
}

void WorkRow::set_startable(bool on) { start_->setEnabled(on); }

}  // namespace sonde::ui
