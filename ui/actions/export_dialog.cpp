// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/export_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "ui/export/image_file.hpp"

namespace sonde::ui {
namespace {

using Of = ExportDialog::Of;

QString title_of(Of of) {
  switch (of) {
    case Of::picture:
      return QStringLiteral("Export a picture");
    case Of::animation:
      return QStringLiteral("Export the separation as pictures");
    case Of::recording:
      return QStringLiteral("Export the recording as pictures");
    case Of::recording_steps:
      return QStringLiteral("Export the recording for ParaView");
  }
  return {};
}

}  // namespace

std::vector<double> Span::times() const {
  const double length = std::max(to - from, 0.0);
  const auto steps = static_cast<std::size_t>(std::max(std::floor(length * rate + 1e-9), 0.0));
  std::vector<double> all;
  for (std::size_t i = 0; i <= steps; ++i) all.push_back(from + double(i) / rate);
  if (all.back() < to - 1e-9) all.push_back(to);
  return all;
}

ExportDialog::ExportDialog(Of of, const QSize& size, const Span& all, QWidget* parent)
    : QDialog(parent),
      width_(new QSpinBox(this)),
      height_(new QSpinBox(this)),
      frames_(new QSpinBox(this)),
      from_(new QDoubleSpinBox(this)),
      to_(new QDoubleSpinBox(this)),
      rate_(new QDoubleSpinBox(this)),
      count_(new QLabel(this)),
      transparent_(new QCheckBox(QStringLiteral("Transparent background"), this)),
      overlays_(new QCheckBox(QStringLiteral("Arrows, contacts and text"), this)),
      film_(new QCheckBox(QStringLiteral("A film beside the pictures"), this)) {
  setObjectName(QStringLiteral("export_dialog"));
  setWindowTitle(title_of(of));
  for (QWidget* widget : std::initializer_list<QWidget*>{
           width_, height_, frames_, from_, to_, rate_, count_, transparent_, overlays_, film_})
    widget->hide();
  auto* form = new QFormLayout(this);
  if (of == Of::recording || of == Of::recording_steps) add_span(*form, all);
  if (of != Of::recording_steps) add_picture(of, *form, size);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::add_picture(Of of, QFormLayout& form, const QSize& size) {
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
  const auto add = [&form](const QString& name, QWidget* widget) {
    widget->show();
    name.isEmpty() ? form.addRow(widget) : form.addRow(name, widget);
  };
  add(QStringLiteral("&Width"), width_);
  add(QStringLiteral("&Height"), height_);
  add({}, transparent_);
  add({}, overlays_);
  if (of == Of::animation) add(QStringLiteral("&Pictures"), frames_);
  if (of == Of::picture) return;
  add({}, film_);
  film_->setEnabled(!find_ffmpeg().isEmpty());
  if (!film_->isEnabled()) film_->setToolTip(QStringLiteral("needs ffmpeg on this system"));
}

void ExportDialog::add_span(QFormLayout& form, const Span& all) {
  const auto add = [&](QDoubleSpinBox* box, const char* object, const char* name, double value) {
    box->setObjectName(QLatin1String(object));
    box->setDecimals(3);
    box->setRange(all.from, all.to);
    box->setSuffix(QStringLiteral(" s"));
    box->setValue(value);
    box->show();
    form.addRow(QLatin1String(name), box);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this] { count_->setText(QStringLiteral("%1 in all").arg(span().times().size())); });
  };
  add(from_, "span_from", "&From", all.from);
  add(to_, "span_to", "&To", all.to);
  add(rate_, "span_rate", "&Each second", all.rate);
  rate_->setRange(0.1, 1000);
  rate_->setSuffix(QString());
  rate_->setValue(all.rate);
  count_->setObjectName(QStringLiteral("span_count"));
  count_->setText(QStringLiteral("%1 in all").arg(span().times().size()));
  count_->show();
  form.addRow(QString(), count_);
}

Span ExportDialog::span() const { return {from_->value(), to_->value(), rate_->value()}; }

PictureWanted ExportDialog::wanted() const {
  PictureWanted wanted;
  wanted.options.size = {width_->value(), height_->value()};
  wanted.options.transparent = transparent_->isChecked();
  wanted.options.overlays = overlays_->isChecked();
  wanted.frames = frames_->value();
  wanted.film = film_->isChecked() && film_->isEnabled();
  wanted.span = span();
  return wanted;
}

}  // namespace sonde::ui
