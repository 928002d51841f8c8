// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/axis_table.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "engine/settings/settings.hpp"
#include "ui/base/format.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui {
namespace {

const Setting& setting(const char* key) { return *find_setting(axis_settings(), key); }

}  // namespace

AxisTable::AxisTable(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 4, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  int column = 0;
  for (const char* title : {"", "from", "turned", "gain", "dead", "expo"})
    grid->addWidget(new QLabel(text(title), this), 0, column++);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Choice& axis = device_axes()[i];
    const QString name = QStringLiteral("axis_%1_").arg(text(axis.key));
    const auto number = [&](const char* key) {
      auto* box = new TypedValue(setting(key), this);
      box->setObjectName(name + text(key));
      box->setToolTip(text(setting(key).doc));
      box->setButtonSymbols(QAbstractSpinBox::NoButtons);
      box->setFixedWidth(40);
      connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &AxisTable::report);
      return box;
    };
    Row& row = rows_[i];
    row.from = new QComboBox(this);
    row.from->setObjectName(name + QStringLiteral("from"));
    row.from->setToolTip(QStringLiteral("The device axis that drives it."));
    for (const Choice& source : device_axes()) row.from->addItem(text(source.key));
    row.from->setFixedWidth(52);
    row.inverted = new QCheckBox(this);
    row.inverted->setObjectName(name + QStringLiteral("inverted"));
    row.inverted->setToolTip(QStringLiteral("The other way round."));
    row.gain = number("gain");
    row.dead_zone = number("dead_zone");
    row.expo = number("expo");
    auto* label = new QLabel(text(axis.label), this);
    label->setToolTip(text(axis.doc));
    const int line = static_cast<int>(i) + 1;
    grid->addWidget(label, line, 0);
    grid->addWidget(row.from, line, 1);
    grid->addWidget(row.inverted, line, 2, Qt::AlignCenter);
    grid->addWidget(row.gain, line, 3);
    grid->addWidget(row.dead_zone, line, 4);
    grid->addWidget(row.expo, line, 5);
    connect(row.from, qOverload<int>(&QComboBox::currentIndexChanged), this, &AxisTable::report);
    connect(row.inverted, &QCheckBox::toggled, this, &AxisTable::report);
  }
}

void AxisTable::show_axes(const AxisMap& axes, bool deflections) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const AxisSetting& axis = axes.axes[i];
    const Row& row = rows_[i];
    const QSignalBlocker quiet_from(row.from), quiet_inverted(row.inverted), quiet_gain(row.gain),
        quiet_zone(row.dead_zone), quiet_expo(row.expo);
    row.from->setCurrentIndex(axis.source);
    row.inverted->setChecked(axis.inverted);
    row.gain->setValue(axis.gain);
    row.dead_zone->setValue(axis.dead_zone);
    row.expo->setValue(axis.expo);
    for (TypedValue* curve : {row.dead_zone, row.expo}) curve->setEnabled(deflections);
  }
}

void AxisTable::report() {
  AxisMap axes;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    axes.axes[i] = {.source = rows_[i].from->currentIndex(),
                    .inverted = rows_[i].inverted->isChecked(),
                    .gain = rows_[i].gain->value(),
                    .dead_zone = rows_[i].dead_zone->value(),
                    .expo = rows_[i].expo->value()};
  emit changed(axes);
}

}  // namespace sonde::ui
