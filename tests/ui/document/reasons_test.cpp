// SPDX-License-Identifier: GPL-3.0-or-later
// Each reason for which the hand gets no force, brought about in the running loop of a window: its
// words are on screen and in the log.

#include <gtest/gtest.h>

#include <QLabel>
#include <QStringList>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

QStringList reason_log_lines;

/// A hand in the contact of the two cubes, of which something is wrong.
using Sample = std::function<HandSample(const Pose& X_FM, double dt)>;

struct Cause {
  Withheld why;
  std::function<void(MainWindow&)> act;
};

std::function<void(MainWindow&)> by_hand(Sample sample) {
  return [sample = std::move(sample)](MainWindow& window) {
    const Pose X_FM = window.session()->device_pose();
    window.session()->hold_by(std::make_shared<const Hand>(
        Hand{.sample = [sample, X_FM](double dt) { return sample(X_FM, dt); }, .render = {}}));
  };
}

/// To and fro at 3 m/s; `way` in m so far.
HandSample fast_along_the_face(const Pose& X_FM, double dt, double& way) {
  constexpr double speed = 3, length = 0.18;
  way += speed * dt;
  const double y = std::abs(std::fmod(way, 2 * length) - length) - length / 2;
  return {.X_FM = {X_FM.q, {X_FM.p.x(), y, X_FM.p.z()}}, .device = DeviceTraits{}};
}

const Cause causes[] = {
    {Withheld::stopped, [](MainWindow& window) { window.set_force(false); }},
    {Withheld::paused, [](MainWindow& window) { window.set_paused(true); }},
    {Withheld::let_go,
     by_hand([](const Pose& X_FM, double) { return HandSample{.X_FM = X_FM, .held = false}; })},
    {Withheld::changed,
     by_hand([](const Pose& X_FM, double) { return HandSample{.X_FM = X_FM, .changed = true}; })},
    {Withheld::untrusted,
     by_hand([](const Pose& X_FM, double) { return HandSample{.X_FM = X_FM, .trusted = false}; })},
    {Withheld::not_finite, by_hand([](const Pose& X_FM, double) {
       return HandSample{.X_FM = {X_FM.q, Vec3::Constant(std::numeric_limits<double>::infinity())}};
     })},
    {Withheld::failed, by_hand([](const Pose& X_FM, double) {
       return HandSample{.X_FM = {X_FM.q, Vec3(1e12, 0, 0)}};  // too far to compute with
     })},
    {Withheld::stalled, by_hand([](const Pose& X_FM, double) {
       std::this_thread::sleep_for(std::chrono::milliseconds(40));  // and the rows grow old
       return HandSample{.X_FM = X_FM};
     })},
    {Withheld::diverged, by_hand([way = 0.0](const Pose& X_FM, double dt) mutable {
       return fast_along_the_face(X_FM, dt, way);
     })},
};

class ReasonTest : public WindowTest, public testing::WithParamInterface<std::size_t> {
 protected:
  void SetUp() override {
    reason_log_lines.clear();
    before = qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) {
      reason_log_lines << text;
    });
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    // By then the mouse has taken over, which is of no interest at a start.
    ASSERT_TRUE(wait_until([this] { return shown().wrench.force.x() > 0 && shown().time > 0.6; }));
    reason_log_lines.clear();
  }
  void TearDown() override {
    window.reset();
    qInstallMessageHandler(before);
  }
  /// As a fault, or as what somebody wanted.
  static QStringList logged(Withheld why) {
    const QString reason = QString::fromUtf8(words(why));
    return reason_log_lines.filter("no force: " + reason) +
           reason_log_lines.filter(reason + ", so no force");
  }
  static bool is_logged(Withheld why) { return !logged(why).isEmpty(); }
  QString status() const { return window->findChild<QLabel*>("what_happens")->text(); }

  QtMessageHandler before = nullptr;
};

TEST_P(ReasonTest, is_on_screen_and_in_the_log) {
  const Cause& cause = causes[GetParam()];
  const QString reason = QString::fromUtf8(words(cause.why));
  cause.act(*window);
  EXPECT_TRUE(wait_until([&] { return status().contains(reason, Qt::CaseInsensitive); }))
      << status().toStdString();
  EXPECT_TRUE(wait_until([&] { return is_logged(cause.why); }))
      << reason_log_lines.join('\n').toStdString();
}
INSTANTIATE_TEST_SUITE_P(Each, ReasonTest, testing::Range<std::size_t>(0, std::size(causes)));

TEST_F(ReasonTest, the_end_of_the_loop_is_logged_at_a_reset_with_another_scene_and_at_the_end) {
  const auto next = [&] {
    const bool there = !reason_log_lines.filter(words(Withheld::shut_down)).isEmpty();
    reason_log_lines.clear();
    return there;
  };
  window->reset();
  EXPECT_TRUE(next());
  ASSERT_TRUE(wait_until([&] { return window->shown() && shown().tick > 50; }));
  open_cubes();
  EXPECT_TRUE(next());
  window.reset();
  EXPECT_TRUE(next());
}

TEST_F(ReasonTest, a_pause_is_logged_once_and_so_is_its_end) {
  window->set_paused(true);
  ASSERT_TRUE(wait_until([&] { return is_logged(Withheld::paused); }));
  wait(100);
  reason_log_lines = logged(Withheld::paused);
  window->set_paused(false);
  ASSERT_TRUE(wait_until([&] { return !reason_log_lines.filter("may come in again").isEmpty(); }));
  EXPECT_EQ(reason_log_lines.filter(QString::fromUtf8(words(Withheld::paused))).size(), 1)
      << reason_log_lines.join('\n').toStdString();
}

}  // namespace
}  // namespace sonde::ui::test
