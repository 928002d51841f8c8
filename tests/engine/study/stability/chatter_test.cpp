// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: a handle of one axis, integrated here in small steps, whose motors do or do not make
// it swing; motions given in closed form; the path of a bundled scene with no loop at all.
#include "engine/study/stability/chatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/scene/poses.hpp"
#include "engine/settings/device_profile.hpp"
#include "tests/engine/study/stability/hands_without_loop.hpp"
#include "tests/engine/study/tuning/tuning_requests.hpp"

namespace sonde {
namespace {

constexpr double T = 1e-3;
constexpr double pi = std::numbers::pi;
using test::draw_setting;
using test::hand_kinds;
using test::HandKind;
using test::HandSetting;
using test::HandWay;
using test::without_loop;
using Force = std::function<double(double x, double v, double t)>;

FeltTick tick_of(double x, double f) {
  FeltTick out;
  out.place.setZero();
  out.wrench.setZero();
  out.place[2] = x;
  out.wrench[2] = f;
  return out;
}

struct Handle {
  double mass = 0.3, damping = 2, hand_stiffness = 200, hand_damping = 1;
};

/// The motors' force is held between samples; `pushed` is the hand's own force.
std::vector<FeltTick> run(const Handle& h, double seconds, const Force& motors,
                          const std::function<double(double)>& pushed) {
  constexpr int steps = 50;
  std::vector<FeltTick> out;
  double x = 1e-6, v = 0;
  for (int i = 0; i < int(seconds / T); ++i) {
    const double f = motors(x, v, i * T);
    out.push_back(tick_of(x, f));
    for (int j = 0; j < steps; ++j) {
      const double dt = T / steps, t = (i + double(j) / steps) * T;
      const double a =
          (f + pushed(t) - h.hand_stiffness * x - (h.damping + h.hand_damping) * v) / h.mass;
      v += a * dt;
      x += v * dt;
    }
  }
  return out;
}

/// Amplitude of the fundamental at a frequency over the last window, by projection.
double amplitude_at(const std::vector<FeltTick>& ticks, double hertz) {
  const auto count = static_cast<std::size_t>(std::round(std::floor(0.3 * hertz) / hertz / T));
  double mean = 0, s = 0, c = 0;
  const std::size_t from = ticks.size() - count;
  for (std::size_t i = from; i < ticks.size(); ++i) mean += ticks[i].wrench[2] / double(count);
  for (std::size_t i = from; i < ticks.size(); ++i) {
    s += (ticks[i].wrench[2] - mean) * std::sin(2 * pi * hertz * double(i) * T);
    c += (ticks[i].wrench[2] - mean) * std::cos(2 * pi * hertz * double(i) * T);
  }
  return 2 * std::hypot(s, c) / double(count);
}

/// A wall that feeds the swing and whose swing is cut to about 1 % of the steady force: the swing
/// grows until the cut lets by as much as the handle takes.
constexpr double feed = 6;  // N·s/m
Force cycle(double mass, double hertz, double steady) {
  const double omega = 2 * pi * hertz, k = mass * omega * omega;
  const double most = 0.01 * steady * pi / 4;  // whose square wave has an amplitude of 1 %
  return [=](double x, double v, double) {
    return steady + std::clamp(-k * x + feed * v, -most, most);
  };
}
/// Of a handle that takes half of what feeds that wall, and of what the sampling gives.
Handle handle_for(double mass, double hertz) {
  return {.mass = mass, .damping = (feed + mass * std::pow(2 * pi * hertz, 2) * T / 2) / 2};
}
/// The same with a slow swing of the hand against a spring, 20 times as large.
void add_slow(std::vector<FeltTick>& ticks, double force) {
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double f = force * std::sin(2 * pi * 2 * double(i) * T);
    ticks[i].wrench[2] += f;
    ticks[i].place[2] -= f / 800;
  }
}

TEST(Chatter, a_limit_cycle_of_one_percent_of_the_force_is_found_in_its_window) {
  for (const double mass : {0.05, 0.3, 1.0})
    for (const double hertz : {45.0, 60.0, 80.0, 120.0, 200.0})
      for (const double steady : {2.0, 6.0}) {
        auto ticks = run(handle_for(mass, hertz), 2, cycle(mass, hertz, steady),
                         [&](double) { return -steady; });
        const auto alone = ticks;
        add_slow(ticks, 0.2 * steady);
        for (const bool known : {true, false}) {
          const Chatter found =
              chatter(std::span(ticks).last(300), T, felt_handle(known ? mass : 0, 0, T / 2), 0.05);
          SCOPED_TRACE(testing::Message() << mass << " kg, " << hertz << " Hz, " << steady << " N");
          EXPECT_TRUE(found.buzzes()) << found.acceleration;
          const double reference = amplitude_at(alone, found.frequency);
          EXPECT_NEAR(found.force / reference, 1, 0.1);
          EXPECT_LT(reference, 0.0101 * steady) << "it is a small one";
        }
      }
}

/// The device does not report so many ticks of each 70: what it said before counts.
void miss(std::vector<FeltTick>& ticks, std::size_t many) {
  for (std::size_t i = 31; i < ticks.size(); ++i)
    if ((i - 31) % 70 < many) ticks[i] = ticks[i - 1];
}

// The jump after a missed report is no step of an encoder: half of these were not found.
TEST(Chatter, a_limit_cycle_is_found_where_the_device_missed_reports) {
  for (const double mass : {0.05, 0.3, 1.0})
    for (const double hertz : {45.0, 80.0, 200.0})
      for (const std::size_t many : {1U, 2U}) {
        auto ticks =
            run(handle_for(mass, hertz), 2, cycle(mass, hertz, 6), [](double) { return -6; });
        add_slow(ticks, 0.2 * 6);
        miss(ticks, many);
        for (const bool known : {true, false})
          EXPECT_TRUE(
              chatter(std::span(ticks).last(300), T, felt_handle(known ? mass : 0, 0, T / 2), 0.05)
                  .buzzes())
              << mass << " kg, " << hertz << " Hz, " << many;
      }
}

TEST(Chatter, the_steady_force_does_not_count) {
  auto ticks = run(handle_for(0.3, 60), 2, cycle(0.3, 60, 3), [](double) { return -3; });
  const FeltHandle handle = felt_handle(0.3, 0, T / 2);
  const Chatter found = chatter(ticks, T, handle, 0.05);
  for (FeltTick& tick : ticks) tick.wrench[2] += 100;
  const Chatter again = chatter(ticks, T, handle, 0.05);
  EXPECT_TRUE(found.buzzes());
  EXPECT_NEAR(again.force, found.force, 1e-6 * found.force);
}

/// Of an unstable wall the swing is that of its eigenvalues, and of a stable one a knock rings out.
TEST(Chatter, a_wall_beyond_its_limit_buzzes_and_a_knock_on_one_below_does_not) {
  const double k = 9000;  // N/m at 0.3 kg: 27.6 Hz without hand and delay
  const auto wall = [&](double stiffness, double most) {
    return [=](double x, double, double) { return std::clamp(-stiffness * x, -most, most); };
  };
  const auto knock = [](double t) { return t > 1.5 && t < 1.52 ? 4.0 : 0; };
  // Passive up to 2 b / T = 6 kN/m.
  const FeltHandle handle = felt_handle(0.3, 0, T / 2);
  const auto loud = run({}, 3, wall(4 * k, 8), knock);
  EXPECT_TRUE(chatter(loud, T, handle, 0.05).buzzes());
  const auto rings = run({}, 3, wall(0.3 * k, 8), knock);
  for (std::size_t end = 1500; end <= rings.size(); end += 20)
    EXPECT_FALSE(chatter(std::span(rings).first(end), T, handle, 0.05).buzzes()) << end;
}

struct Motion {
  const char* name;
  std::function<double(double)> x;
};
const Motion motions[] = {
    {"a tremor", [](double t) { return 1e-3 * std::sin(2 * pi * 9 * t); }},
    {"shaken at 15 Hz", [](double t) { return 5e-3 * std::sin(2 * pi * 15 * t); }},
    {"vibrated at 120 Hz", [](double t) { return 1e-4 * std::sin(2 * pi * 120 * t); }},
    {"a mouse at 60 Hz", [](double t) { return 0.02 * std::floor(60 * t) / 60; }},
    {"a mouse at 125 Hz", [](double t) { return 0.02 * std::floor(125 * t) / 125; }},
    {"one step", [](double t) { return t < 0.5 ? 0.0 : 2e-3; }},
    {"steps", [](double t) { return 1e-3 * std::floor(7 * t); }},
    {"in and out of contact", [](double t) { return 4e-3 * std::sin(2 * pi * 3 * t); }},
};

TEST(Chatter, what_a_hand_a_mouse_or_a_path_does_is_none) {
  for (const Motion& motion : motions)
    for (const double k : {100.0, 400.0, 800.0, 2000.0})
      for (const double mass : {0.05, 0.3, 0.0}) {
        if (mass == 0 && k > 1000) continue;  // at 60 Hz, that is what a handle of 14 g would do
        std::vector<FeltTick> ticks;
        for (int i = 0; i < 1500; ++i) {
          const double x = motion.x(i * T);
          ticks.push_back(tick_of(x, -k * std::max(0.0, x)));
        }
        const FeltHandle handle = felt_handle(mass, 0, T / 2);
        for (std::size_t end = 300; end <= ticks.size(); end += 50)
          ASSERT_FALSE(chatter(std::span(ticks).first(end), T, handle, 0.05).buzzes())
              << motion.name << ' ' << k << ' ' << mass << ' ' << end;
      }
}

/// The share of the windows of hands of one kind that are taken for a buzz.
double flagged_of(const HandKind& kind, double* with_steps = nullptr, std::size_t missed = 0) {
  Random random(11);
  int flagged = 0, all = 0, stepped = 0;
  for (int i = 0; i < 60; ++i) {
    const HandWay way = kind.draw(random);
    const HandSetting setting = draw_setting(random);
    std::vector<FeltTick> ticks = without_loop(way, setting, T, 1.2);
    miss(ticks, missed);
    const FeltHandle handle = felt_handle(setting.mass, 0, 1.5e-3);
    for (std::size_t end = 300; end <= ticks.size(); end += 60, ++all) {
      const bool buzzes = chatter(std::span(ticks).first(end), T, handle, 0.05).buzzes();
      flagged += buzzes;
      stepped += buzzes && setting.step > 0;
    }
  }
  if (with_steps) *with_steps = double(stepped) / all;
  return double(flagged) / all;
}

// Without a look at the encoder's steps, 0.2 to 10 % of the windows of the kinds that it was tried
// on are flagged. Of the others, one window of 2880 is, of a push that fades.
TEST(Chatter, of_hands_without_a_loop_hardly_any_window_buzzes) {
  for (const HandKind& kind : hand_kinds) {
    double with_steps = 0;
    const double share = flagged_of(kind, &with_steps);
    RecordProperty(kind.name, std::to_string(share));
    EXPECT_LE(share, kind.tried ? 0.001 : 0.002) << kind.name;
    EXPECT_EQ(share, with_steps) << kind.name << ": an exact encoder makes no steps";
  }
}

TEST(Chatter, nor_where_the_device_missed_reports) {
  for (const HandKind& kind : hand_kinds) {
    const double share = flagged_of(kind, nullptr, 1);
    RecordProperty(kind.name, std::to_string(share));
    EXPECT_LE(share, kind.tried ? 0.001 : 0.002) << kind.name;
  }
}

/// Of a handle whose position is read in steps, on a wall that feeds the swing.
TEST(Chatter, a_limit_cycle_is_found_through_the_steps_of_the_encoder) {
  for (const double step : {1e-6, 5e-6, 2e-5})
    for (const double hertz : {45.0, 60.0, 120.0}) {
      constexpr double mass = 0.3;
      const double omega = 2 * pi * hertz, k = mass * omega * omega;
      const double steady = 2 * step * k / 0.01;  // 1 % of it swings over two steps
      auto ticks = run(handle_for(mass, hertz), 2, cycle(mass, hertz, steady),
                       [&](double) { return -steady; });
      for (FeltTick& tick : ticks) tick.place[2] = step * std::round(tick.place[2] / step);
      const Chatter found =
          chatter(std::span(ticks).last(300), T, felt_handle(mass, 0, T / 2), 0.05);
      EXPECT_TRUE(found.buzzes()) << step << ' ' << hertz;
    }
}

/// On a circle all second differences are alike, as those of a fine encoder's steps.
TEST(Chatter, a_fast_limit_cycle_on_a_circle_is_found) {
  for (const double hertz : {350.0, 400.0}) {
    constexpr double mass = 0.05, steady = 3;
    auto ticks = run(handle_for(mass, hertz), 2, cycle(mass, hertz, steady),
                     [&](double) { return -steady; });
    const auto quarter = static_cast<std::size_t>(std::lround(1 / (4 * hertz * T)));
    for (std::size_t i = ticks.size() - 1; i >= quarter; --i) {
      ticks[i].place[0] = ticks[i - quarter].place[2];
      ticks[i].wrench[0] = ticks[i - quarter].wrench[2];
    }
    const Chatter found = chatter(std::span(ticks).last(300), T, felt_handle(mass, 0, T / 2), 0.05);
    EXPECT_TRUE(found.buzzes()) << hertz;
  }
}

TEST(Chatter, too_few_ticks_and_no_force_are_none) {
  const FeltHandle handle = felt_handle(0.3, 0, T / 2);
  EXPECT_EQ(chatter({}, T, handle, 0.1).force, 0);
  const std::vector<FeltTick> still(300, tick_of(0, 0));
  EXPECT_EQ(chatter(still, T, handle, 0.1).force, 0);
  EXPECT_EQ(chatter(std::span(still).first(100), T, handle, 0.1).force, 0);
}

/// Every second of the recorded path of the peg, as if each device were in it: nobody made a loop.
TEST(Chatter, the_path_of_the_peg_with_no_loop_has_none) {
  const TuningRequest peg = test::in_scene("peg-in-hole");
  const auto path = read_trajectory(SONDE_RESOURCES "/scenes/peg-in-hole.path.csv");
  const MassProperties& mass = peg.pair.probe().mass;
  HapticLoop loop(peg.pair, Method::pdg, peg.coupling);
  std::vector<FeltTick> ticks;
  loop.reset(path.front().pose, {});
  for (const auto& row : path) {
    loop.tick(row.pose, T, {.steps = 20000});
    const Pose com{row.pose.q, row.pose * mass.com};
    ticks.push_back(felt_tick({.X_WD = com}, loop.wrench(), path.front().pose));
  }
  std::vector<FeltHandle> handles{felt_handle(0, 0, T / 2)};
  const std::filesystem::path folder(SONDE_RESOURCES "/devices");
  for (const std::string& id : device_profile_ids({&folder, 1})) {
    const DeviceProfile p = test::profile(id);
    handles.push_back(felt_handle(p.mass.value, p.inertia.value, T / 2 + p.delay.value));
  }
  ASSERT_EQ(handles.size(), 8u);
  const double length = std::sqrt(mass.inertia.maxCoeff());
  std::size_t windows = 0;
  for (std::size_t end = 1000; end <= ticks.size(); end += 100, ++windows)
    for (const FeltHandle& handle : handles) {
      const Chatter found = chatter(std::span(ticks).first(end), T, handle, length);
      EXPECT_FALSE(found.buzzes()) << end << ": " << found.force << " N, " << found.frequency;
    }
  EXPECT_EQ(windows, 57u);
}

}  // namespace
}  // namespace sonde
