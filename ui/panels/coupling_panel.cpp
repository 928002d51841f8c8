// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/coupling_panel.hpp"

#include <QButtonGroup>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QUndoCommand>
#include <QUndoStack>
#include <QVBoxLayout>
#include <chrono>
#include <string_view>
#include <utility>

#include "engine/settings/settings.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/panels/slider_row.hpp"
#include "ui/tuning/gains_text.hpp"

namespace sonde::ui {

using Clock = std::chrono::steady_clock;

/// A change of gains. Changes of one setting in quick succession, as a slider makes them, are one.
class CouplingChange : public QUndoCommand {
 public:
  CouplingChange(CouplingPanel& panel, const Coupling& wanted, const char* what)
      : QUndoCommand(QString::fromUtf8(what)),
        panel_(panel),
        what_(what),
        before_(panel.coupling()),
        after_(wanted),
        made_(Clock::now()) {}
  void redo() override { panel_.apply(after_); }
  void undo() override { panel_.apply(before_); }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const CouplingChange&>(*other);
    if (next.what_ != what_ || next.made_ - made_ > std::chrono::milliseconds(700)) return false;
    after_ = next.after_;
    made_ = next.made_;
    return true;
  }

 private:
  CouplingPanel& panel_;
  std::string_view what_;
  Coupling before_, after_;
  Clock::time_point made_;
};

namespace {

/// The one setting that is the window's own: it never reaches the engine.
constexpr Setting mouse_gain{
    "mouse_gain",
    "Mouse gain",
    "",
    0.02,
    5,
    1,
    true,
    "How far the probe goes for a drag: at 1 it follows the cursor; less is finer."};

}  // namespace

CouplingPanel::CouplingPanel(QUndoStack& undo, QWidget* parent)
    : QDockWidget(QStringLiteral("Coupling"), parent), undo_(undo) {
  setObjectName(QStringLiteral("coupling_panel"));
  build();
  take(Coupling{});
}

void CouplingPanel::build() {
  const auto [scroll, content, layout] = scrolled(*this);
  modes_ = new QButtonGroup(this);
  auto* mode_row = new QHBoxLayout;
  int index = 0;
  for (const Choice& choice : coupling_modes()) {
    auto* button = new QRadioButton(text(choice.label), content);
    button->setObjectName(QStringLiteral("mode_") + text(choice.key));
    button->setToolTip(text(choice.doc));
    modes_->addButton(button, index++);
    mode_row->addWidget(button);
  }
  layout->addLayout(mode_row);
  mode_doc_ = new QLabel(content);
  mode_doc_->setWordWrap(true);
  mode_doc_->setEnabled(false);  // dim: it explains, and is read once
  layout->addWidget(mode_doc_);
  waiting_ = new QLabel(content);
  waiting_->setObjectName(QStringLiteral("gains_waiting"));
  waiting_->setWordWrap(true);
  waiting_->setTextFormat(Qt::RichText);
  waiting_->hide();
  layout->addWidget(waiting_);
  for (const Setting& setting : coupling_settings()) {
    auto* row = new SliderRow(setting, content);
    connect(row, &SliderRow::changed, this, [this, row](double value) {
      Coupling wanted = coupling_;
      set(wanted, row->setting().key, value);
      request(wanted, row->setting().label);
    });
    rows_.push_back(row);
    layout->addWidget(row);
  }
  auto* defaults = new QPushButton(QStringLiteral("Gains as opened"), content);
  defaults->setObjectName(QStringLiteral("gains_as_opened"));
  layout->addWidget(defaults);
  origin_ = new QLabel(content);
  origin_->setObjectName(QStringLiteral("gains_origin"));
  origin_->setWordWrap(true);
  origin_->setTextFormat(Qt::PlainText);
  origin_->setEnabled(false);
  layout->addWidget(origin_);
  auto* mouse = new QGroupBox(QStringLiteral("Probe"), content);
  auto* mouse_layout = new QVBoxLayout(mouse);
  mouse_layout->setContentsMargins(0, 4, 0, 0);
  auto* gain = new SliderRow(mouse_gain, mouse);
  connect(gain, &SliderRow::changed, this, &CouplingPanel::mouse_gain_changed);
  mouse_layout->addWidget(gain);
  layout->addWidget(mouse);
  layout->addStretch();
  connect(defaults, &QPushButton::clicked, this, [this] { request(defaults_, "Gains as opened"); });
  connect(modes_, &QButtonGroup::idClicked, this, [this](int id) {
    Coupling wanted = coupling_;
    wanted.mode = static_cast<Coupling::Mode>(id);
    request(wanted, "Mode");
  });
}

void CouplingPanel::take(const Coupling& coupling) {
  defaults_ = coupling;
  coupling_ = coupling;
  show_values();
}

void CouplingPanel::show_origin(std::function<QString(const Coupling&)> words) {
  origin_words_ = std::move(words);
  show_values();
}

void CouplingPanel::show_rendered(const std::optional<GainGlide::Blend>& instead) {
  waiting_->setVisible(instead.has_value());
  if (!instead) return;
  waiting_->setText(in_colour(
      colour::force, QStringLiteral("Felt now: %1. What is set below waits until this contact is "
                                    "left, in which it would be unstable.")
                         .arg(gains_text(*instead).replace('\n', QStringLiteral(", ")))));
}

void CouplingPanel::request(const Coupling& wanted, const char* what) {
  undo_.push(new CouplingChange(*this, wanted, what));
}

void CouplingPanel::apply(const Coupling& coupling) {
  coupling_ = coupling;
  show_values();
  emit changed(coupling_);
}

void CouplingPanel::show_values() {
  const auto mode = static_cast<int>(coupling_.mode);
  modes_->button(mode)->setChecked(true);
  mode_doc_->setText(text(coupling_modes()[static_cast<std::size_t>(mode)].doc));
  for (SliderRow* row : rows_) {
    row->setVisible(is_used(row->setting(), coupling_.mode));
    const double value = get(coupling_, row->setting().key);
    if (row->value() != value) row->set_value(value);
  }
  if (origin_words_) origin_->setText(origin_words_(coupling_));
}

}  // namespace sonde::ui
