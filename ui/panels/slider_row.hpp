// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "engine/settings/settings.hpp"

class QSlider;

namespace sonde::ui {

class TypedValue;

/// One setting for the user: its name, a slider, and a box for the exact value, all made from its
/// line in the table of settings. Object names: KEY_row, KEY_slider, KEY_value.
class SliderRow : public QWidget {
  Q_OBJECT
 public:
  SliderRow(const Setting& setting, QWidget* parent);

  double value() const;
  /// Shows a value without reporting it.
  void set_value(double value);
  const Setting& setting() const { return setting_; }

 signals:
  /// The new value, while the slider moves and when a typed value is accepted.
  void changed(double value);

 private:
  int position_of(double value) const;
  double value_at(int position) const;

  Setting setting_;
  QSlider* slider_;
  TypedValue* typed_;
};

}  // namespace sonde::ui
