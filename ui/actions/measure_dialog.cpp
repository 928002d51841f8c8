// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/measure_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/study/identification/identified_profile.hpp"
#include "engine/text/number_text.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

// Pages, in their order.
constexpr int consent = 0, running = 1, outcome = 2;
constexpr int bar_steps = 1000;
constexpr qint64 same_key_ms = 300;

QLabel* paragraph(const char* object, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(object));
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  return label;
}

/// "96 pulses, at most 2.00 N and 0.0500 N·m".
QString words_of(const PulsePlan& plan, const PulseBounds& bounds) {
  QString out =
      QStringLiteral("%1 pulses of at most %2 N").arg(plan.pulses.size()).arg(number(bounds.force));
  if (bounds.torque > 0) out += QStringLiteral(" and %1 N·m").arg(number(bounds.torque));
  return out;
}

QString ways(double travel, double turn, bool turns) {
  const QString way = QStringLiteral("%1 mm").arg(number(1e3 * travel));
  const double degrees = turn * 180 / std::numbers::pi;
  return turns ? way + QStringLiteral(" or %1°").arg(std::round(degrees)) : way;
}

void set_limit(QDoubleSpinBox& box, double least, double most, double value) {
  const QSignalBlocker quiet(&box);
  box.setRange(std::min(least, most), most);
  box.setSingleStep(most / 20);
  box.setValue(value);
}

/// As large as what it holds.
void show_whole(QTableWidget& table) {
  table.resizeColumnsToContents();
  table.resizeRowsToContents();
  const int frame = 2 * table.frameWidth();
  table.setMinimumSize(
      table.horizontalHeader()->length() + frame,
      table.verticalHeader()->length() + table.horizontalHeader()->sizeHint().height() + frame);
  table.horizontalHeader()->setStretchLastSection(true);
}

}  // namespace

MeasureDialog::MeasureDialog(QWidget* parent) : QDialog(parent), pages_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("measure_dialog"));
  setWindowTitle(QStringLiteral("Measure the device"));
  setWindowModality(Qt::WindowModal);
  setMinimumWidth(520);
  pages_->addWidget(consent_page());
  pages_->addWidget(progress_page());
  pages_->addWidget(result_page());
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(pages_);
}

QDoubleSpinBox* MeasureDialog::limit(const char* name, const char* object, const char* suffix,
                                     int decimals) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QLatin1String(object));
  box->setDecimals(decimals);
  box->setSuffix(QString::fromUtf8(suffix));
  form_->addRow(QString::fromUtf8(name), box);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &MeasureDialog::describe);
  return box;
}

QWidget* MeasureDialog::consent_page() {
  auto* page = new QWidget(this);
  ended_ = paragraph("measure_ended", page);
  what_ = paragraph("measure_what", page);
  form_ = new QFormLayout;
  profiles_ = new QComboBox(page);
  profiles_->setObjectName(QStringLiteral("measure_profile"));
  profiles_->setToolTip(QStringLiteral(
      "Its mass and inertia say how long a pulse takes; what is not measured is kept from it."));
  form_->addRow(QStringLiteral("Begin with the profile"), profiles_);
  connect(profiles_, qOverload<int>(&QComboBox::activated), this,
          [this] { emit profile_chosen(profiles_->currentText()); });
  force_ = limit("Largest force", "measure_force", " N", 2);
  torque_ = limit("Largest torque", "measure_torque", " N·m", 3);
  travel_ = limit("Travel of a pulse", "measure_travel", " mm", 1);
  turn_ = limit("Turn of a pulse", "measure_turn", " rad", 2);
  auto* buttons = new QDialogButtonBox(page);
  auto* start = buttons->addButton(QStringLiteral("Start"), QDialogButtonBox::ActionRole);
  start->setObjectName(QStringLiteral("measure_start"));
  auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
  // A key that is still down from before is no consent.
  start->setAutoDefault(false);
  cancel->setDefault(true);
  connect(start, &QPushButton::clicked, this, &MeasureDialog::start_asked);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(page);
  for (QWidget* widget : {ended_, what_}) layout->addWidget(widget);
  layout->addLayout(form_);
  layout->addStretch();
  layout->addWidget(buttons);
  return page;
}

QWidget* MeasureDialog::progress_page() {
  auto* page = new QWidget(this);
  now_ = paragraph("measure_now", page);
  bar_ = new QProgressBar(page);
  bar_->setObjectName(QStringLiteral("measure_bar"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, page);
  buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("measure_cancel"));
  connect(buttons, &QDialogButtonBox::rejected, this, &MeasureDialog::reject);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(now_);
  layout->addWidget(bar_);
  layout->addStretch();
  layout->addWidget(buttons);
  return page;
}

QWidget* MeasureDialog::result_page() {
  auto* page = new QWidget(this);
  found_ = paragraph("measure_found", page);
  saved_ = paragraph("measure_saved", page);
  table_ = new QTableWidget(0, 5, page);
  table_->setObjectName(QStringLiteral("measure_table"));
  table_->setHorizontalHeaderLabels({QStringLiteral("Figure"), QStringLiteral("Measured"),
                                     QStringLiteral("Between"), QStringLiteral("Unit"),
                                     QStringLiteral("Profile said")});
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, page);
  auto* save = buttons->addButton(QStringLiteral("Save profile…"), QDialogButtonBox::ActionRole);
  save->setObjectName(QStringLiteral("measure_save"));
  use_ = buttons->addButton(QStringLiteral("Use it"), QDialogButtonBox::ActionRole);
  use_->setObjectName(QStringLiteral("measure_use"));
  use_->setToolTip(QStringLiteral("Simulate the device from the saved profile from now on."));
  connect(save, &QPushButton::clicked, this, &MeasureDialog::save_asked);
  connect(use_, &QPushButton::clicked, this, &MeasureDialog::use_asked);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(table_, 1);
  layout->addWidget(found_);
  layout->addWidget(saved_);
  layout->addWidget(buttons);
  return page;
}

void MeasureDialog::show_consent(const MeasureSubject& subject) {
  subject_ = subject;
  ended_->hide();
  const QSignalBlocker quiet(profiles_);
  profiles_->clear();
  profiles_->addItems(subject_.profiles);
  profiles_->setCurrentText(text(subject_.profile.id));
  const auto show_row = [this](QWidget* field, bool on) {
    form_->labelForField(field)->setVisible(on);
    field->setVisible(on);
  };
  show_row(profiles_, !subject_.profiles.isEmpty());
  show_row(torque_, turns());
  show_row(turn_, turns());
  show_limits();
  pages_->setCurrentIndex(consent);
}

void MeasureDialog::show_limits() {
  const PulseLimits usual, most = most_allowed(subject_.profile);
  set_limit(*force_, 0.05, most.force, usual.force);
  set_limit(*torque_, 0.001, most.torque, usual.torque);
  set_limit(*travel_, 1, 1e3 * most.travel, 1e3 * usual.travel);
  set_limit(*turn_, 0.03, most.turn, usual.turn);
  describe();
}

bool MeasureDialog::turns() const { return subject_.profile.max_torque.value > 0; }

PulseLimits MeasureDialog::limits() const {
  PulseLimits limits;
  limits.force = force_->value();
  if (turns()) limits.torque = torque_->value();
  limits.travel = 1e-3 * travel_->value();
  limits.turn = turn_->value();
  return limits;
}

void MeasureDialog::describe() {
  const PulseLimits wanted = limits();
  const PulsePlan plan = plan_pulses(subject_.profile, wanted, subject_.sample_time);
  const PulseBounds bounds = bounds_of(plan, wanted);
  what_->setText(
      QStringLiteral(
          "<p><b>%1</b> will be pushed: %2, along one axis after the other, in at least %3 s. The "
          "largest move the handle by about %4 to either side.</p><ul>"
          "<li><b>Take your hand off the handle</b>, let it rest, and keep clear: nothing within "
          "5 cm of it.</li>"
          "<li>Contacts are not felt meanwhile.</li>"
          "<li>It ends where the handle is held, does not rest between pulses, or is more than %5 "
          "from where it began. <b>Esc</b> and Cancel end the force at once.</li></ul>")
          .arg(subject_.device.toHtmlEscaped(), words_of(plan, bounds),
               QString::number(std::ceil(time_of(plan))), ways(wanted.travel, wanted.turn, turns()),
               ways(bounds.travel, bounds.turn, turns())));
}

void MeasureDialog::show_ended(const QString& reason) {
  ended_->setText(in_colour(colour::force, QStringLiteral("It ended: ") + reason.toHtmlEscaped()));
  ended_->show();
  if (pages_->currentIndex() == running) since_end_.start();
  pages_->setCurrentIndex(consent);
}

void MeasureDialog::show_progress(const PulsePlan& plan, const PulseProgress& progress) {
  const double left =
      static_cast<double>(progress.samples - progress.sample) * subject_.sample_time;
  const std::size_t axis =
      plan.pulses.empty() ? 0 : plan.pulses[std::max<std::size_t>(progress.pulse, 1) - 1].axis;
  now_->setText(
      QStringLiteral("<p><b>Keep your hand off the handle.</b> Esc ends the force at once.</p>"
                     "<p>Pulse %1 of %2, %3; %4 s left</p>")
          .arg(progress.pulse)
          .arg(progress.pulses)
          .arg(text(name_of_axis(axis)))
          .arg(std::ceil(left)));
  bar_->setRange(0, bar_steps);
  bar_->setValue(
      static_cast<int>(bar_steps * progress.sample / std::max<std::size_t>(progress.samples, 1)));
  pages_->setCurrentIndex(running);
}

void MeasureDialog::show_computing(double fraction) {
  now_->setText(QStringLiteral("<p>The handle may be held again.</p><p>Computing …</p>"));
  bar_->setRange(0, 100);
  bar_->setValue(static_cast<int>(100 * fraction));
  pages_->setCurrentIndex(running);
}

void MeasureDialog::show_result(const Identification& found, const DeviceProfile& before) {
  const auto values = identified_values(found);
  table_->setRowCount(static_cast<int>(values.size()));
  int row = 0;
  for (const auto& [value, e] : values) {
    const ProfileKey& key = key_of(value);
    const ProfileValue& said = before.*value;
    const QStringList cells{
        text(key.key).replace('_', ' '), text(number_text(e.value, 4)),
        text(number_text(e.low, 4)) + QStringLiteral(" – ") + text(number_text(e.high, 4)),
        QString::fromUtf8(key.unit),
        text(number_text(said.value, 4)) +
            (said.assumed ? QStringLiteral(", assumed") : QString())};
    for (int column = 0; column < cells.size(); ++column) {
      auto* cell = new QTableWidgetItem(cells[column]);
      cell->setToolTip(QString::fromUtf8(key.doc));
      table_->setItem(row, column, cell);
    }
    ++row;
  }
  show_whole(*table_);
  QString words = QStringLiteral("The intervals are 99 %, where the model of a free handle holds.");
  for (const RefusedAxis& axis : found.refused)
    words += QStringLiteral("<br>Not identified: %1: %2")
                 .arg(text(name_of_axis(axis.axis)), text(axis.reason).toHtmlEscaped());
  found_->setText(words);
  saved_->hide();
  use_->setEnabled(false);
  pages_->setCurrentIndex(outcome);
  adjustSize();
}

void MeasureDialog::show_saved(const QString& file, bool usable) {
  saved_->setText(QStringLiteral("Saved: ") + file.toHtmlEscaped());
  saved_->show();
  use_->setVisible(usable);
  use_->setEnabled(usable);
}

void MeasureDialog::reject() {
  if (since_end_.isValid() && since_end_.elapsed() < same_key_ms) return;
  if (pages_->currentIndex() != running) return QDialog::reject();
  emit cancel_asked();
}

}  // namespace sonde::ui
