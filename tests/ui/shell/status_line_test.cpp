// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_line.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class StatusLineTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    bar = std::make_unique<QStatusBar>();
    bar->resize(1000, 30);
    line = std::make_unique<StatusLine>(*bar);
  }
  QLabel& label(const char* name) const { return *bar->findChild<QLabel*>(name); }
  static std::unique_ptr<Session> session() {
    const auto cube = [] { return sonde::test::body(sonde::test::box({0.1, 0.1, 0.1})); };
    LoadedScene loaded{.pair = Pair(cube(), cube())};
    loaded.start.p = Vec3(0.3, 0, 0);
    loaded.servo.real_time = false;
    return std::make_unique<Session>(std::move(loaded));
  }
  static Instant live() {
    Instant now;
    now.snapshot.rate_hz = 999.6;
    now.snapshot.tick_us = 21.4;
    return now;
  }
  std::unique_ptr<QStatusBar> bar;
  std::unique_ptr<StatusLine> line;
};

TEST_F(StatusLineTest, says_what_happens_in_the_words_it_is_given) {
  line->show_happening("Free, 1.2 mm clear.");
  EXPECT_EQ(label("what_happens").text(), "Free, 1.2 mm clear.");
}

TEST_F(StatusLineTest, rates_are_those_of_the_loop_and_the_view) {
  const auto open = session();
  line->show_rates(live(), *open, 59.8, false);
  EXPECT_EQ(label("rates").text(), "servo 1000 Hz, tick 21 µs, view 60 frames/s");
  line->show_rates(live(), *open, 30, true);
  EXPECT_TRUE(label("rates").text().endsWith("30 frames/s, simplified while moving"));
  EXPECT_FALSE(label("rates").toolTip().isEmpty()) << "how the deadlines are kept";
}

TEST_F(StatusLineTest, a_pause_has_no_rate_and_what_ran_without_a_clock_says_so) {
  const auto open = session();
  Instant now = live();
  now.snapshot.paused = true;
  line->show_rates(now, *open, 60, false);
  EXPECT_TRUE(label("rates").text().startsWith("servo 0 Hz,"));
  now = live();
  now.live = false;
  line->show_rates(now, *open, 60, false);
  EXPECT_TRUE(label("rates").text().startsWith("servo 1000 Hz,")) << "a recording knows its times";
  now.snapshot.tick_us = 0;
  line->show_rates(now, *open, 60, false);
  EXPECT_EQ(label("rates").text(), "run with no clock");
  now.live = true;
  line->show_rates(now, *open, 60, false);
  EXPECT_TRUE(label("rates").text().startsWith("servo 1000 Hz, tick 0 µs"));
}

TEST_F(StatusLineTest, what_holds_the_probe_has_its_name) {
  line->show_source(MouseSource{}, {});
  EXPECT_EQ(label("device_status").text(), QString::fromStdString(name_of(MouseSource{})));
}

TEST_F(StatusLineTest, a_connected_device_says_its_state_its_clutch_and_its_reason) {
  const ConnectedSource device{.choice = {}, .name = "SpaceMouse"};
  SourceReport report;
  report.device.state = DeviceState::ready;
  line->show_source(device, report);
  const QString ready = "SpaceMouse: " + QString::fromLatin1(name_of(DeviceState::ready));
  EXPECT_EQ(label("device_status").text(), ready);
  report.clutch_open = true;
  line->show_source(device, report);
  EXPECT_EQ(label("device_status").text(), ready + ", clutch open");
  report = {};
  report.device.state = DeviceState::refused;
  report.device.reason = "permission denied";
  line->show_source(device, report);
  EXPECT_EQ(label("device_status").text(), QStringLiteral("SpaceMouse: %1 (permission denied)")
                                               .arg(QLatin1String(name_of(DeviceState::refused))));
}

/// A device names itself, and may call itself anything.
TEST_F(StatusLineTest, a_name_is_plain_text_cut_where_it_is_long_and_whole_in_the_tooltip) {
  const std::string name = "<img src=x>" + std::string(100, 'n') + "end";
  line->show_source(ConnectedSource{.choice = {}, .name = name}, {});
  const QLabel& shown = label("device_status");
  EXPECT_EQ(shown.textFormat(), Qt::PlainText);
  EXPECT_EQ(shown.text().size(), 70);
  EXPECT_TRUE(shown.text().startsWith("<img src=x>nnn"));
  EXPECT_TRUE(shown.text().endsWith("n…"));
  EXPECT_TRUE(shown.toolTip().startsWith("<p>&lt;img src=x&gt;nnn"));
  EXPECT_TRUE(shown.toolTip().contains("end: "));
}

}  // namespace
}  // namespace sonde::ui::test
