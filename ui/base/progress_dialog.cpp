// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/progress_dialog.hpp"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

namespace sonde::ui {
namespace {

constexpr int steps = 1000;

}  // namespace

ProgressDialog::ProgressDialog(const QString& what, QWidget* parent)
    : QDialog(parent), bar_(new QProgressBar(this)) {
  setObjectName(QStringLiteral("progress_dialog"));
  setWindowTitle(QStringLiteral("Sonde at work"));
  setWindowModality(Qt::WindowModal);
  setMinimumWidth(360);
  auto* label = new QLabel(what, this);
  label->setTextFormat(Qt::PlainText);  // file names
  bar_->setRange(0, steps);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(label);
  layout->addWidget(bar_);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ProgressDialog::set_fraction(double fraction) {
  bar_->setValue(static_cast<int>(fraction * steps));
}

}  // namespace sonde::ui
