// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/work_row.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/base/time_left.hpp"

namespace sonde::ui {
namespace {

constexpr int bar_steps = 1000;

}  // namespace

WorkRow::WorkRow(const QString& text, const QString& object, QWidget* parent)
    : QWidget(parent),
      start_(new QPushButton(text, this)),
      stop_(new QPushButton(QStringLiteral("Stop"), this)),
      bar_(new QProgressBar(this)),
      left_(new QLabel(this)) {
  start_->setObjectName(object);
  stop_->setObjectName(object + QStringLiteral("_stop"));
  bar_->setRange(0, bar_steps);
  left_->setObjectName(object + QStringLiteral("_left"));
  left_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->addWidget(start_);
  row->addWidget(bar_, 1);
  row->addWidget(stop_);
  layout->addLayout(row);
  layout->addWidget(left_);
  connect(start_, &QPushButton::clicked, this, &WorkRow::start_wanted);
  connect(stop_, &QPushButton::clicked, this, &WorkRow::stop_wanted);
  show_progress({});
}

void WorkRow::show_progress(std::optional<double> fraction, double elapsed) {
  bar_->setVisible(fraction.has_value());
  stop_->setVisible(fraction.has_value());
  start_->setVisible(!fraction.has_value());
  bar_->setValue(static_cast<int>(fraction.value_or(0) * bar_steps));
  const QString left = fraction ? time_left_text(elapsed, *fraction) : QString();
  left_->setText(left);
  left_->setVisible(!left.isEmpty());
}

void WorkRow::set_startable(bool on) { start_->setEnabled(on); }

}  // namespace sonde::ui
