// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>

#include "ui/opening.hpp"

class QComboBox;
class QLabel;

namespace sonde::ui {

/// Asks what unit two mesh files are in. Starts with the likely one, and shows how large both
/// bodies are in the unit chosen: a person knows at once whether a cup is 90 mm or 90 m tall.
class UnitDialog : public QDialog {
 public:
  UnitDialog(const MeshPair& pair, QWidget* parent);
  double metres() const;

 private:
  void show_sizes();
  Vec3 probe_size_, fixed_size_;
  QComboBox* unit_;
  QLabel* sizes_;
};

}  // namespace sonde::ui
