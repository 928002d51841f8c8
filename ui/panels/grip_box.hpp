// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <vector>

#include "ui/devices/hand_grip.hpp"

class QPushButton;

namespace sonde::ui {

class SliderRow;

/// The hand on a simulated device: a button for each named grip, and a slider for each of its
/// figures. The button of the grip that the sliders have is pressed.
class GripBox : public QGroupBox {
  Q_OBJECT
 public:
  explicit GripBox(QWidget* parent);
  void show_grip(const SimulatedGrip& grip);

 signals:
  /// Immediately, with every change.
  void changed(const SimulatedGrip& grip);

 private:
  void change(const SimulatedGrip& grip);

  SimulatedGrip grip_;
  std::vector<QPushButton*> named_;
  std::vector<SliderRow*> rows_;
};

}  // namespace sonde::ui
