// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/export_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

#include "ui/export/image_file.hpp"

namespace sonde::ui {

ExportDialog::ExportDialog(Of of, const QSize& size, QWidget* parent)
    : QDialog(parent),
      width_(new QSpinBox(this)),
      height_(new QSpinBox(this)),
      frames_(new QSpinBox(this)),
      transparent_(new QCheckBox(QStringLiteral("Transparent background"), this)),
      overlays_(new QCheckBox(QStringLiteral("Arrows, contacts and text"), this)),
      film_(new QCheckBox(QStringLiteral("A film beside the pictures"), this)) {
  setObjectName(QStringLiteral("export_dialog"));
  setWindowTitle(of == Of::picture ? QStringLiteral("Export a picture")
                                   : QStringLiteral("Export the separation as pictures"));
  auto* form = new QFormLayout(this);
  for (QSpinBox* box : {width_, height_}) {
    box->setRange(16, Viewport::largest_picture);
    box->setSuffix(QStringLiteral(" pixels"));
  }
  width_->setObjectName(QStringLiteral("picture_width"));
  height_->setObjectName(QStringLiteral("picture_height"));
  frames_->setObjectName(QStringLiteral("picture_frames"));
  transparent_->setObjectName(QStringLiteral("picture_transparent"));
  overlays_->setObjectName(QStringLiteral("picture_overlays"));
  film_->setObjectName(QStringLiteral("picture_film"));
  width_->setValue(size.width());
  height_->setValue(size.height());
  overlays_->setChecked(true);
  frames_->setRange(2, 1000);
  frames_->setValue(PictureWanted{}.frames);
  form->addRow(QStringLiteral("&Width"), width_);
  form->addRow(QStringLiteral("&Height"), height_);
  form->addRow(transparent_);
  form->addRow(overlays_);
  if (of == Of::animation) {
    form->addRow(QStringLiteral("&Pictures"), frames_);
    form->addRow(film_);
    film_->setEnabled(!film_maker().isEmpty());
    if (!film_->isEnabled()) film_->setToolTip(QStringLiteral("needs ffmpeg on this system"));
  } else {
    frames_->hide();
    film_->hide();
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

PictureWanted ExportDialog::wanted() const {
  PictureWanted wanted;
  wanted.options.size = {width_->value(), height_->value()};
  wanted.options.transparent = transparent_->isChecked();
  wanted.options.overlays = overlays_->isChecked();
  wanted.frames = frames_->value();
  wanted.film = film_->isChecked() && film_->isEnabled();
  return wanted;
}

}  // namespace sonde::ui
