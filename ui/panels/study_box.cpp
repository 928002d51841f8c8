// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_box.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/base/format.hpp"
#include "ui/tuning/tuning.hpp"

namespace sonde::ui {
namespace {

constexpr int steps = 1000;  // of the bar

}  // namespace

StudyBox::StudyBox(const std::vector<std::string>& device_ids, QWidget* parent)
    : QGroupBox(QStringLiteral("Study"), parent),
      devices_(new QComboBox(this)),
      kinds_(new QComboBox(this)),
      source_(new QLabel(this)) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 4, 0, 0);
  source_->setObjectName(QStringLiteral("tuning_source"));
  source_->setWordWrap(true);
  source_->setTextFormat(Qt::PlainText);
  box->addWidget(source_);
  devices_->setObjectName(QStringLiteral("tuning_device"));
  devices_->setToolTip(QStringLiteral("The device to compute for."));
  for (const std::string& id : device_ids) devices_->addItem(text(id));
  kinds_->setObjectName(QStringLiteral("tuning_kind"));
  kinds_->setToolTip(QStringLiteral("The contacts to compute for. One kind is quicker than all."));
  kinds_->addItem(QStringLiteral("all contacts"));
  for (const std::string& kind : situation_kinds()) kinds_->addItem(text(kind));
  auto* row = new QHBoxLayout;
  row->addWidget(devices_);
  row->addWidget(kinds_);
  box->addLayout(row);
  auto* compute = button(QStringLiteral("Compute"), "compute_tuning",
                         QStringLiteral("Computes as sonde tune does, while everything else goes "
                                        "on. The rows appear as they are found."));
  compute->setEnabled(!device_ids.empty());
  auto* load = button(QStringLiteral("Load…"), "load_tuning",
                      QStringLiteral("A folder that sonde tune has written."));
  save_ = button(QStringLiteral("Save…"), "save_tuning",
                 QStringLiteral("Writes what was computed into a folder, as sonde tune does."));
  connect(compute, &QPushButton::clicked, this, &StudyBox::compute_asked);
  connect(load, &QPushButton::clicked, this, &StudyBox::load_asked);
  connect(save_, &QPushButton::clicked, this, &StudyBox::save_asked);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {compute, load, save_}) buttons->addWidget(each);
  box->addLayout(buttons);
}

QPushButton* StudyBox::button(const QString& text, const char* object, const QString& doc) {
  auto* out = new QPushButton(text, this);
  out->setObjectName(QLatin1String(object));
  out->setToolTip(doc);
  return out;
}

void StudyBox::set_source(const QString& words, const QString& folder) {
  source_->setText(words);
  source_->setToolTip(folder);
}

void StudyBox::set_unsaved(bool unsaved) { save_->setEnabled(unsaved); }

void StudyBox::choose_device(const std::string& id) {
  if (id.empty()) return;
  // One of a file of the user's own.
  if (devices_->findText(text(id)) < 0) devices_->addItem(text(id));
  devices_->setCurrentIndex(devices_->findText(text(id)));
}

std::string StudyBox::device_id() const { return devices_->currentText().toStdString(); }

std::string StudyBox::kind() const {
  return kinds_->currentIndex() > 0 ? kinds_->currentText().toStdString() : std::string();
}

StudyProgressRow::StudyProgressRow(QWidget* parent)
    : QWidget(parent), words_(new QLabel(this)), bar_(new QProgressBar(this)) {
  setObjectName(QStringLiteral("study_progress"));
  words_->setObjectName(QStringLiteral("study_progress_words"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  bar_->setRange(0, steps);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(8);
  auto* stop = new QPushButton(QStringLiteral("Stop"), this);
  stop->setObjectName(QStringLiteral("stop_tuning"));
  stop->setToolTip(QStringLiteral("Finished rows stay; Compute goes on from them."));
  connect(stop, &QPushButton::clicked, this, &StudyProgressRow::stop_asked);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setColumnStretch(0, 1);
  grid->addWidget(words_, 0, 0);
  grid->addWidget(bar_, 1, 0);
  grid->addWidget(stop, 0, 1, 2, 1);
  hide();
}

void StudyProgressRow::show_progress(const std::optional<StudyProgress>& progress) {
  setVisible(progress.has_value());
  if (!progress) return;
  if (words_->text() != progress->words) words_->setText(progress->words);
  bar_->setValue(static_cast<int>(progress->fraction * steps));
}

}  // namespace sonde::ui
