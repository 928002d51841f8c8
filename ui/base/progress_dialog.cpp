// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/progress_dialog.hpp"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include "ui/base/time_left.hpp"

namespace sonde::ui {
namespace {

constexpr int steps = 1000;

}  // namespace

ProgressDialog::ProgressDialog(const QString& what, QWidget* parent)
    : QDialog(parent), bar_(new QProgressBar(this)), left_(new QLabel(this)) {
  setObjectName(QStringLiteral("progress_dialog"));
  setWindowTitle(what);
  setWindowModality(Qt::WindowModal);
  setMinimumWidth(360);
  auto* label = new QLabel(what, this);
  label->setTextFormat(Qt::PlainText);  // file names
  bar_->setRange(0, steps);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(label);
  layout->addWidget(bar_);
  left_->setObjectName(QStringLiteral("time_left"));
  layout->addWidget(left_);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ProgressDialog::show_progress(double fraction, double elapsed) {
  bar_->setValue(static_cast<int>(fraction * steps));
  left_->setText(time_left_text(elapsed, fraction));
}

}  // namespace sonde::ui
