// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <cstdint>

class QCheckBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QSlider;
class QToolButton;

namespace sonde::ui {

class ElidedLabel;

/// What the timeline shows.
struct TimelineState {
  double from = 0, to = 0;  ///< s, the range of kept ticks
  double time = 0;          ///< s, the shown time; live: the end
  std::uint64_t tick = 0;   ///< index among the kept ticks, from 0
  bool any = false;         ///< there is something
  bool looking = false;     ///< false: live
  bool playing = false;
  bool recording = false;
  QString since;          ///< when the recording began, and with how much of what was kept
  QString of;             ///< the recording that was opened; empty: the last minutes of the session
  bool replayed = false;  ///< it was run again with other gains, beside it
  bool shows_replay = false;  ///< that run is on show
};

/// The dock under the view: where in time the picture is, and what moves it.
class TimelinePanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit TimelinePanel(QWidget* parent = nullptr);

  void show_state(const TimelineState& state);

 signals:
  void sought(double time);
  void stepped(int ticks);
  void played(bool on);
  void looped(bool on);
  void recorded(bool on);
  void replay_shown(bool on);
  void speed_changed(double speed);
  void live_wanted();

 private:
  QToolButton* button(QHBoxLayout& row, const char* object, const QString& text,
                      const QString& doc);
  void seek_to(int place);

  TimelineState state_;
  QSlider* track_;
  QToolButton *record_, *back_, *play_, *on_, *live_;
  QCheckBox *loop_, *replay_;
  QDoubleSpinBox* speed_;
  ElidedLabel* text_;
};

}  // namespace sonde::ui
