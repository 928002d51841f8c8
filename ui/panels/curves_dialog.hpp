// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "engine/study/tuning/device_curves.hpp"

class QComboBox;
class QLabel;

namespace sonde::ui {

class StudyChart;

/// What a study says of the device alone: how stiff and damped its walls may be, what limits them,
/// the impedance that is rendered beside the wanted one, and how hard a wall feels. One chart at a
/// time.
class CurvesDialog : public QDialog {
 public:
  explicit CurvesDialog(QWidget* parent);
  /// `device`: its name. The chart that is shown stays, where there is such a one.
  void show_curves(const QString& device, const std::vector<DeviceCurves>& curves);

 private:
  void show_chosen();

  std::vector<ChartPanel> panels_;
  QComboBox* choice_;
  QLabel* words_;
  StudyChart* chart_;
};

}  // namespace sonde::ui
