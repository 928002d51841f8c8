// SPDX-License-Identifier: GPL-3.0-or-later
// References: pulses whose samples are counted by hand.
#include "engine/study/identification/pulse_windows.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

/// Samples a millisecond apart, with this force along y from and to these.
Response with_pulses(std::size_t size, const std::vector<std::array<std::size_t, 2>>& pulses) {
  Response out;
  for (std::size_t i = 0; i < size; ++i) {
    ResponseSample s{.t = 1e-3 * static_cast<double>(i), .command = {}, .X_BH = {}};
    for (const auto& [first, last] : pulses)
      if (i >= first && i < last) s.command.force.y() = -0.5 - 1e-3 * static_cast<double>(i);
    s.X_BH.p.y() = 1 + 0.01 * static_cast<double>(i);
    out.push_back(s);
  }
  return out;
}

/// The windows of such a response along y.
std::vector<PulseWindow> windows_of(const Response& response) {
  return pulse_windows(axis_response(response, 1));
}
using Spans = std::vector<std::array<std::size_t, 2>>;
Spans spans(const std::vector<PulseWindow>& windows) {
  Spans out;
  for (const PulseWindow& w : windows) out.push_back({w.begin, w.end});
  return out;
}

TEST(PulseWindows, begin_before_a_pulse_and_end_as_long_after_it) {
  const auto windows = windows_of(with_pulses(300, {{50, 80}, {200, 220}}));
  ASSERT_EQ(spans(windows), (Spans{{40, 110}, {190, 240}}));
  EXPECT_EQ(windows[0].first, 50u);
  EXPECT_EQ(windows[0].last, 80u);
  EXPECT_DOUBLE_EQ(windows[0].amplitude, 0.579);
}

TEST(PulseWindows, end_where_the_next_pulse_begins_and_with_the_recording) {
  EXPECT_EQ(spans(windows_of(with_pulses(130, {{3, 40}, {65, 110}}))), (Spans{{0, 65}, {55, 130}}));
}

TEST(PulseWindows, a_short_pause_is_a_part_of_the_pulse) {
  const auto windows = windows_of(with_pulses(300, {{50, 60}, {75, 90}}));
  ASSERT_EQ(windows.size(), 1u);
  EXPECT_EQ(windows[0].last, 90u);
}

TEST(PulseWindows, end_and_begin_with_the_commands_of_another_axis) {
  Response response = with_pulses(300, {{100, 150}});
  response[95].command.torque.x() = response[170].command.force.z() = 1;
  EXPECT_EQ(spans(windows_of(response)), (Spans{{96, 170}}));
}

TEST(PulseWindows, another_axis_has_none) {
  const Response response = with_pulses(300, {{50, 60}});
  EXPECT_TRUE(pulse_windows(axis_response(response, 0)).empty());
  EXPECT_TRUE(pulse_windows(axis_response(response, 4)).empty());
}

TEST(PulseWindows, positions_are_from_the_first_pose_and_turns_are_rotation_vectors) {
  Response response = with_pulses(10, {});
  response[9].X_BH.q = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  const AxisResponse y = axis_response(response, 1), about_z = axis_response(response, 5);
  EXPECT_EQ(y.positions[0], 0);
  EXPECT_NEAR(y.positions[9], 0.09, 1e-12);
  EXPECT_NEAR(about_z.positions[9], 0.3, 1e-12);
  EXPECT_NEAR(excursion(y.positions, {.begin = 2, .end = 8}), 0.05, 1e-12);
}

}  // namespace
}  // namespace sonde
