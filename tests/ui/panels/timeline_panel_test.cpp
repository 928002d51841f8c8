// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline_panel.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QToolButton>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/document/playback.hpp"

namespace sonde::ui::test {
namespace {

class TimelinePanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<TimelinePanel>();
    const auto flag = [this](const char* what) {
      return [this, what](bool on) { told << QString(what) + (on ? " on" : " off"); };
    };
    QObject::connect(panel.get(), &TimelinePanel::played, flag("play"));
    QObject::connect(panel.get(), &TimelinePanel::looped, flag("loop"));
    QObject::connect(panel.get(), &TimelinePanel::recorded, flag("record"));
    QObject::connect(panel.get(), &TimelinePanel::replay_shown, flag("replay"));
    QObject::connect(panel.get(), &TimelinePanel::live_wanted, [this] { told << "live"; });
    QObject::connect(panel.get(), &TimelinePanel::sought,
                     [this](double time) { told << QStringLiteral("seek %1").arg(time); });
    QObject::connect(panel.get(), &TimelinePanel::stepped,
                     [this](int ticks) { told << QStringLiteral("step %1").arg(ticks); });
    QObject::connect(panel.get(), &TimelinePanel::speed_changed,
                     [this](double speed) { told << QStringLiteral("× %1").arg(speed); });
  }
  template <class T>
  T* find(const char* name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  QToolButton* button(const char* name) const { return find<QToolButton>(name); }
  std::string text() const { return find<ElidedLabel>("timeline_text")->text().toStdString(); }
  /// From 10 to 30 s, looked back on at 15 s.
  static TimelineState looked_back() {
    TimelineState state;
    state.any = state.looking = true;
    state.from = 10;
    state.to = 30;
    state.time = 15;
    state.tick = 5000;
    return state;
  }

  std::unique_ptr<TimelinePanel> panel;
  QStringList told;
};

TEST_F(TimelinePanelTest, says_where_in_time_the_picture_is) {
  EXPECT_EQ(text(), "nothing kept yet");
  TimelineState state = looked_back();
  panel->show_state(state);
  EXPECT_EQ(text(), "15.000 s, tick 5000, 15.000 s before the end");
  EXPECT_EQ(find<QSlider>("timeline")->value(), find<QSlider>("timeline")->maximum() / 4);
  state.of = "run.sonde-ticks";
  panel->show_state(state);
  EXPECT_EQ(text(), "run.sonde-ticks: 15.000 s, tick 5000, 15.000 s before the end");
  state.looking = false;
  panel->show_state(state);
  EXPECT_EQ(text(), "Live. 20.0 s kept");
  EXPECT_EQ(find<QSlider>("timeline")->value(), find<QSlider>("timeline")->maximum());
  state.recording = true;
  state.since = "12:30:00";
  panel->show_state(state);
  EXPECT_EQ(text(), "Live, recording since 12:30:00. 20.0 s kept");
  EXPECT_TRUE(told.isEmpty()) << "showing is no wish";
}

TEST_F(TimelinePanelTest, the_slider_seeks_within_what_is_kept) {
  panel->show_state(looked_back());
  auto* track = find<QSlider>("timeline");
  track->setValue(track->maximum() / 2);
  track->setValue(0);
  EXPECT_EQ(told, QStringList({"seek 20", "seek 10"}));
}

TEST_F(TimelinePanelTest, every_control_tells_what_it_is_for) {
  panel->show_state(looked_back());
  for (const char* name : {"play", "step_back", "step_on", "record_button", "live"})
    button(name)->click();
  find<QCheckBox>("loop")->click();
  find<QCheckBox>("show_replay")->click();
  auto* speed = find<QDoubleSpinBox>("play_speed");
  speed->setValue(0.5);
  EXPECT_EQ(told, QStringList({"play on", "step -1", "step 1", "record on", "live", "loop on",
                               "replay on", "× 0.5"}));
  speed->setValue(1e9);
  EXPECT_EQ(speed->value(), Playback::fastest);
}

TEST_F(TimelinePanelTest, what_means_nothing_now_is_off_or_hidden) {
  panel->show_state({});
  for (const char* name : {"play", "step_back", "step_on", "record_button", "live"})
    EXPECT_FALSE(button(name)->isEnabled()) << name;
  TimelineState state = looked_back();
  state.playing = state.recording = true;
  panel->show_state(state);
  for (const char* name : {"play", "step_back", "step_on", "record_button", "live"})
    EXPECT_TRUE(button(name)->isEnabled()) << name;
  EXPECT_TRUE(button("play")->isChecked() && button("record_button")->isChecked());
  EXPECT_EQ(button("record_button")->text(), "■ Stop");
  EXPECT_FALSE(find<QCheckBox>("show_replay")->isVisibleTo(panel.get()));
  state.replayed = state.shows_replay = true;
  panel->show_state(state);
  EXPECT_TRUE(find<QCheckBox>("show_replay")->isVisibleTo(panel.get()));
  EXPECT_TRUE(find<QCheckBox>("show_replay")->isChecked());
  state.looking = false;
  panel->show_state(state);
  EXPECT_FALSE(button("live")->isEnabled()) << "it is live";
}

}  // namespace
}  // namespace sonde::ui::test
