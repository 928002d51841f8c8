// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/slider_row.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ui/panels/typed_value.hpp"

namespace sonde::ui {
namespace {

constexpr int positions = 1000;

}  // namespace

SliderRow::SliderRow(const Setting& setting, QWidget* parent)
    : QWidget(parent),
      setting_(setting),
      slider_(new QSlider(Qt::Horizontal, this)),
      typed_(new TypedValue(setting, this)) {
  const QString key = QString::fromUtf8(setting.key);
  setObjectName(key + QStringLiteral("_row"));
  setToolTip(QString::fromUtf8(setting.doc));
  slider_->setObjectName(key + QStringLiteral("_slider"));
  slider_->setRange(0, positions);
  slider_->setPageStep(positions / 20);
  typed_->setObjectName(key + QStringLiteral("_value"));
  typed_->setFixedWidth(132);
  auto* label = new QLabel(QString::fromUtf8(setting.label), this);
  label->setBuddy(typed_);
  label->setWordWrap(true);  // in a dock of a small screen, beside its scroll bar
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 2, 0, 2);
  layout->setVerticalSpacing(1);
  layout->addWidget(label, 0, 0);
  layout->addWidget(typed_, 0, 1);
  layout->addWidget(slider_, 1, 0, 1, 2);
  set_value(setting.fallback);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const QSignalBlocker quiet(typed_);
    typed_->setValue(value_at(position));
    emit changed(value());
  });
  connect(typed_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(position_of(value));
    emit changed(value);
  });
}

double SliderRow::value() const { return typed_->value(); }

void SliderRow::set_value(double value) {
  const QSignalBlocker quiet_slider(slider_), quiet_typed(typed_);
  typed_->setValue(value);
  slider_->setValue(position_of(value));
}

int SliderRow::position_of(double value) const {
  const double low = setting_.minimum, high = setting_.maximum;
  const double inside = std::clamp(value, low, high);
  const double part = setting_.logarithmic ? std::log(inside / low) / std::log(high / low)
                                           : (inside - low) / (high - low);
  return static_cast<int>(std::lround(part * positions));
}

double SliderRow::value_at(int position) const {
  const double low = setting_.minimum, high = setting_.maximum;
  const double part = double(position) / positions;
  const double value =
      setting_.logarithmic ? low * std::pow(high / low, part) : low + (high - low) * part;
  return setting_.integer ? std::round(value) : value;
}

}  // namespace sonde::ui
