// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "engine/devices/axis_map.hpp"

class QCheckBox;
class QComboBox;

namespace sonde::ui {

class TypedValue;

/// The six axes of a device, a row each: the device axis that drives it, whether it is inverted,
/// gain, dead zone and curve. Object names: axis_KEY_from, _inverted, _gain, _dead_zone, _expo.
class AxisTable : public QWidget {
  Q_OBJECT
 public:
  explicit AxisTable(QWidget* parent);

  /// Shows the axes without reporting them. Dead zones and curves are for deflections.
  void show_axes(const AxisMap& axes, bool deflections);

 signals:
  /// With each change.
  void changed(const AxisMap& axes);

 private:
  struct Row {
    QComboBox* from;
    QCheckBox* inverted;
    TypedValue* gain;
    TypedValue* dead_zone;
    TypedValue* expo;
  };
  void report();

  std::array<Row, 6> rows_{};
};

}  // namespace sonde::ui
