// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLineEdit;

namespace sonde::ui {

/// Asks for two mesh files: the probe and the fixed body, with a button that swaps them.
class MeshesDialog : public QDialog {
 public:
  explicit MeshesDialog(QWidget* parent, const QString& probe = {});
  QString probe() const;
  QString fixed() const;

 private:
  QLineEdit* add_row(const QString& label, const char* object);
  QLineEdit *probe_, *fixed_;
};

/// What the file dialogs offer as meshes.
QString mesh_filter();
/// The folder the last file was taken from.
QString last_folder();
void remember_folder_of(const QString& file);

}  // namespace sonde::ui
