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
/// up, and whether its inside counts; and for the probe by how much it is taken smaller or larger.
/// It shows how large both are with these answers, because a user knows at once whether a cup is 90
/// mm or 90 m tall, and the defects of each file.
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
    QComboBox* offset_way;   // of the probe alone
    QDoubleSpinBox* offset;  // mm
  };
  Column add_column(QGridLayout& grid, int at, const char* object, const BodySetup& guess,
                    const Topology& edges);
  QWidget* add_offset(Column& column, double metres);
  BodySetup setup_of(const Column& column) const;
  void show_sizes();

  const MeshPair& pair_;
  Column probe_, fixed_;
  QPushButton* same_size_;
  QLabel* warning_;
};

}  // namespace sonde::ui
