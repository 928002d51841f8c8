// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/meshes_dialog.hpp"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

namespace sonde::ui {

QString mesh_filter() {
  return QStringLiteral("Meshes (*.off *.obj *.ply *.stl *.glb *.gltf *.3mf *.dae)");
}

QString last_folder() { return QSettings().value(QStringLiteral("last_folder")).toString(); }

void remember_folder_of(const QString& file) {
  QSettings().setValue(QStringLiteral("last_folder"), QFileInfo(file).absolutePath());
}

MeshesDialog::MeshesDialog(QWidget* parent, const QString& probe) : QDialog(parent) {
  setObjectName(QStringLiteral("meshes_dialog"));
  setWindowTitle(QStringLiteral("Open two meshes"));
  setMinimumWidth(520);
  new QFormLayout(this);
  probe_ = add_row(QStringLiteral("Probe, which moves"), "probe_file");
  fixed_ = add_row(QStringLiteral("Fixed body"), "fixed_file");
  auto* swap = new QPushButton(QStringLiteral("Swap"), this);
  swap->setObjectName(QStringLiteral("swap_meshes"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  buttons->addButton(swap, QDialogButtonBox::ActionRole);
  static_cast<QFormLayout*>(layout())->addRow(buttons);
  QPushButton* open = buttons->button(QDialogButtonBox::Open);
  const auto check = [this, open] {
    open->setEnabled(!probe_->text().isEmpty() && !fixed_->text().isEmpty());
  };
  connect(probe_, &QLineEdit::textChanged, this, check);
  connect(fixed_, &QLineEdit::textChanged, this, check);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(swap, &QPushButton::clicked, this, [this] {
    const QString probe = probe_->text();
    probe_->setText(fixed_->text());
    fixed_->setText(probe);
  });
  probe_->setText(probe);
  check();
}

QString MeshesDialog::probe() const { return probe_->text(); }
QString MeshesDialog::fixed() const { return fixed_->text(); }

QLineEdit* MeshesDialog::add_row(const QString& label, const char* object) {
  auto* edit = new QLineEdit(this);
  edit->setObjectName(QLatin1String(object));
  auto* browse = new QPushButton(QStringLiteral("Browse…"), this);
  browse->setObjectName(QLatin1String(object) + QStringLiteral("_browse"));
  auto* row = new QHBoxLayout;
  row->addWidget(edit);
  row->addWidget(browse);
  static_cast<QFormLayout*>(layout())->addRow(label, row);
  connect(browse, &QPushButton::clicked, this, [this, edit, label] {
    const QString file = QFileDialog::getOpenFileName(this, label, last_folder(), mesh_filter());
    if (file.isEmpty()) return;
    remember_folder_of(file);
    edit->setText(file);
  });
  return edit;
}

}  // namespace sonde::ui
