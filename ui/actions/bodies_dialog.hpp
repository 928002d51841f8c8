// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/document/loaded_scene.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace sonde::ui {

/// Asks for what mesh files do not state: for each body the unit, the scale, the axis that points
/// up, and whether its inside counts. It shows how large both are with these answers, because a
/// user knows at once whether a cup is 90 mm or 90 m tall, and the defects of each file.
class BodiesDialog : public QDialog {
 public:
  BodiesDialog(const MeshPair& pair, const PairSetup& guess, QWidget* parent);
  PairSetup setup() const;

 private:
  struct Column {
    QComboBox* unit;
    QDoubleSpinBox* scale;
    QComboBox* up;
    QComboBox* model;
    QCheckBox* as_in_file;
    QLabel *size, *found;
  };
  Column add_column(QGridLayout& grid, int at, const char* object, const BodySetup& guess,
                    const Topology& edges);
  BodySetup setup_of(const Column& column) const;
  void show_sizes();

  const MeshPair& pair_;
  Column probe_, fixed_;
  QPushButton* same_size_;
  QLabel* warning_;
};

}  // namespace sonde::ui
