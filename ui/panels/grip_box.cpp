// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/grip_box.hpp"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/slider_row.hpp"

namespace sonde::ui {

GripBox::GripBox(QWidget* parent)
    : QGroupBox(QStringLiteral("Hand on the simulated device"), parent) {
  setObjectName(QStringLiteral("grip_box"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 4, 0, 0);
  auto* buttons = new QHBoxLayout;
  for (const NamedGrip& named : named_grips()) {
    auto* button = new QPushButton(QString::fromUtf8(named.name), this);
    button->setObjectName(QStringLiteral("grip_") + named.name);
    button->setToolTip(QString::fromUtf8(named.doc));
    button->setCheckable(true);
    button->setMinimumWidth(40);  // three beside each other in a narrow dock
    connect(button, &QPushButton::clicked, this, [this, grip = named.grip] { change(grip); });
    buttons->addWidget(button);
    named_.push_back(button);
  }
  box->addLayout(buttons);
  for (const Setting& setting : grip_settings()) {
    auto* row = new SliderRow(setting, this);
    connect(row, &SliderRow::changed, this, [this, row](double value) {
      SimulatedGrip grip = grip_;
      set(grip, row->setting().key, value);
      change(grip);
    });
    rows_.push_back(row);
    box->addWidget(row);
  }
  show_grip({});
}

void GripBox::change(const SimulatedGrip& grip) {
  show_grip(grip);
  emit changed(grip);
}

void GripBox::show_grip(const SimulatedGrip& grip) {
  grip_ = grip;
  for (SliderRow* row : rows_) {
    const double value = get(grip_, row->setting().key);
    if (row->value() != value) row->set_value(value);
  }
  for (std::size_t i = 0; i < named_.size(); ++i)
    named_[i]->setChecked(named_grips()[i].grip == grip_);
}

}  // namespace sonde::ui
