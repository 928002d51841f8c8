// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline_panel.hpp"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/base/elided_label.hpp"
#include "ui/document/playback.hpp"
#include "ui/panels/jump_slider.hpp"

namespace sonde::ui {
namespace {

constexpr int places = 100'000;  ///< of the slider: finer than any screen

QString text_of(const TimelineState& state) {
  if (!state.any) return QStringLiteral("nothing kept yet");
  const QString span = QStringLiteral("%1 s kept").arg(state.to - state.from, 0, 'f', 1);
  if (!state.looking)
    return state.recording ? QStringLiteral("Live, recording since %1. %2").arg(state.since, span)
                           : QStringLiteral("Live. %1").arg(span);
  const QString where = QStringLiteral("%1 s, tick %2, %3 s before the end")
                            .arg(state.time, 0, 'f', 3)
                            .arg(state.tick)
                            .arg(state.to - state.time, 0, 'f', 3);
  return state.of.isEmpty() ? where : QStringLiteral("%1: %2").arg(state.of, where);
}

}  // namespace

TimelinePanel::TimelinePanel(QWidget* parent) : QDockWidget(QStringLiteral("Timeline"), parent) {
  setObjectName(QStringLiteral("timeline_panel"));
  auto* content = new QWidget(this);
  auto* row = new QHBoxLayout(content);
  row->setContentsMargins(6, 1, 6, 1);
  track_ = new JumpSlider(content);
  track_->setObjectName(QStringLiteral("timeline"));
  track_->setRange(0, places);
  track_->setToolTip(QStringLiteral("Looks back: the picture and the numbers show that moment"));
  connect(track_, &QSlider::valueChanged, this, &TimelinePanel::seek_to);
  track_->setMinimumWidth(120);
  record_ = button(*row, "record_button", QStringLiteral("● Record"),
                   QStringLiteral("Writes the kept minutes and everything that follows"));
  record_->setCheckable(true);
  connect(record_, &QToolButton::clicked, this, &TimelinePanel::recorded);
  back_ = button(*row, "step_back", QStringLiteral("◀|"), QStringLiteral("One tick back"));
  connect(back_, &QToolButton::clicked, this, [this] { emit stepped(-1); });
  play_ = button(*row, "play", QStringLiteral("▶"), QStringLiteral("Plays from here"));
  play_->setCheckable(true);
  connect(play_, &QToolButton::clicked, this, &TimelinePanel::played);
  on_ = button(*row, "step_on", QStringLiteral("|▶"), QStringLiteral("One tick on"));
  connect(on_, &QToolButton::clicked, this, [this] { emit stepped(1); });
  for (QToolButton* step : {back_, on_}) step->setAutoRepeat(true);
  speed_ = new QDoubleSpinBox(content);
  speed_->setObjectName(QStringLiteral("play_speed"));
  speed_->setPrefix(QStringLiteral("× "));
  speed_->setDecimals(2);
  speed_->setRange(Playback::slowest, Playback::fastest);
  speed_->setSingleStep(0.1);
  speed_->setValue(1);
  speed_->setToolTip(QStringLiteral("How fast it plays, of the time it took"));
  connect(speed_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          &TimelinePanel::speed_changed);
  row->addWidget(speed_);
  loop_ = new QCheckBox(QStringLiteral("Loop"), content);
  loop_->setObjectName(QStringLiteral("loop"));
  connect(loop_, &QCheckBox::toggled, this, &TimelinePanel::looped);
  row->addWidget(loop_);
  replay_ = new QCheckBox(QStringLiteral("Run again"), content);
  replay_->setObjectName(QStringLiteral("show_replay"));
  replay_->setToolTip(QStringLiteral("Shows the run with other gains instead of the recorded one"));
  connect(replay_, &QCheckBox::toggled, this, &TimelinePanel::replay_shown);
  row->addWidget(replay_);
  row->addWidget(track_, 1);
  text_ = new ElidedLabel(content);
  text_->setObjectName(QStringLiteral("timeline_text"));
  row->addWidget(text_);
  live_ = button(*row, "live", QStringLiteral("Live"), QStringLiteral("Back to the servo"));
  connect(live_, &QToolButton::clicked, this, &TimelinePanel::live_wanted);
  content->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setTitleBarWidget(new QWidget(this));  // a row is all that it takes from the view
  setWidget(content);
  show_state({});
}

QToolButton* TimelinePanel::button(QHBoxLayout& row, const char* object, const QString& text,
                                   const QString& doc) {
  auto* made = new QToolButton(this);
  made->setObjectName(QLatin1String(object));
  made->setText(text);
  made->setToolTip(doc);
  row.addWidget(made);
  return made;
}

void TimelinePanel::seek_to(int place) {
  emit sought(state_.from + (state_.to - state_.from) * place / places);
}

void TimelinePanel::show_state(const TimelineState& state) {
  state_ = state;
  const QSignalBlocker quiet(track_), quiet_replay(replay_);
  for (QWidget* widget : {static_cast<QWidget*>(track_), static_cast<QWidget*>(back_),
                          static_cast<QWidget*>(play_), static_cast<QWidget*>(on_)})
    widget->setEnabled(state.any);
  const double length = state.to - state.from;
  const double part = state.looking && length > 0 ? (state.time - state.from) / length : 1;
  if (!track_->isSliderDown()) track_->setValue(static_cast<int>(std::lround(part * places)));
  record_->setEnabled(state.any || state.recording);
  record_->setChecked(state.recording);
  record_->setText(state.recording ? QStringLiteral("■ Stop") : QStringLiteral("● Record"));
  play_->setChecked(state.playing);
  play_->setText(state.playing ? QStringLiteral("❚❚") : QStringLiteral("▶"));
  replay_->setVisible(state.replayed);
  replay_->setChecked(state.shows_replay);
  live_->setEnabled(state.looking);
  text_->show_text(text_of(state));
}

}  // namespace sonde::ui
