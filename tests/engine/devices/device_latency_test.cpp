// SPDX-License-Identifier: GPL-3.0-or-later
// From the arrival of a device's sample to the force that answers it, over the whole way. The
// figures are printed, for the manual; what is tested is that they measure what they say.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/engine/devices/controller_descriptors.hpp"
#include "tests/engine/devices/makers.hpp"
#include "tests/engine/devices/pressed_block.hpp"

namespace sonde::test {
namespace {

/// Samples to be answered.
constexpr std::uint64_t some = 300, many = 20000;

void print(const char* what, const PressedBlock& loop) {
  const LatencySummary latency = loop.device->status().latency;
  std::printf("%-28s %6llu samples: median %.2f ms, 99.9 %% %.2f ms\n", what,
              static_cast<unsigned long long>(latency.samples), 1e-3 * latency.median,
              1e-3 * latency.p999);
  EXPECT_GT(latency.median, 0);
  EXPECT_LE(latency.median, latency.p999);
}

/// Lets the device sample until enough are answered.
template <class Sample>
void measure(const char* what, PressedBlock& loop, std::uint64_t samples, const Sample& sample) {
  const auto end = DeviceClock::now() + std::chrono::minutes(5);
  while (loop.device->status().latency.samples < samples) {
    ASSERT_LT(DeviceClock::now(), end) << loop.device->status().reason;
    sample();
  }
  print(what, loop);
}

/// By its status: the newest sample is the servo's alone to take.
bool is_ready(const PressedBlock& loop) {
  return loop.device->status().state == DeviceState::ready;
}
bool gets_ready(const PressedBlock& loop) {
  return comes_true([&] { return is_ready(loop); });
}

void wait_1ms() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

struct ArmLatency : testing::TestWithParam<Maker> {
  const Maker& maker = GetParam();
  MockSystem system;  ///< no HID device of the machine takes part
  LoadedStandin standin{maker.library};
  ArmLatency() {
    forget_makers();
    ::setenv(maker.variable, maker.library, 1);
  }
  ~ArmLatency() override { forget_makers(); }

  void run(std::uint64_t samples) {
    PressedBlock loop({.path = maker.path});
    ASSERT_TRUE(gets_ready(loop));
    standin.move_to(maker.place(Vec3(0, 0, -0.003)));
    measure(maker.name, loop, samples, wait_1ms);
  }
};
TEST_P(ArmLatency, is_measured) { run(some); }
TEST_P(ArmLatency, Soak_is_measured) { run(many); }

/// A hand that takes 20 ms from its sample to its wrench: no answer can be out earlier.
TEST_P(ArmLatency, is_no_less_than_a_delay_that_is_put_in) {
  PressedBlock loop({.path = maker.path});
  ASSERT_TRUE(gets_ready(loop));
  loop.servo.stop();
  const Hand inner = loop.hand.hand();
  loop.servo.start(PressedBlock::at_depth(-0.001),
                   {.sample =
                        [&](double dt) {
                          HandSample sample = inner.sample(dt);
                          std::this_thread::sleep_for(std::chrono::milliseconds(20));
                          return sample;
                        },
                    .render = inner.render});
  const std::uint64_t before = loop.device->status().latency.samples;
  ASSERT_TRUE(comes_true([&] { return loop.device->status().latency.samples > 4 * before + 40; }));
  EXPECT_GT(loop.device->status().latency.median, 20000);
  loop.servo.stop();
}

INSTANTIATE_TEST_SUITE_P(Makers, ArmLatency, testing::Values(force_dimension, three_d),
                         [](const auto& info) { return std::string(info.param.name); });

struct ForceDeviceLatency : ForceTest {
  void run(std::uint64_t samples) {
    plug();
    PressedBlock loop({.vendor = 0x1209});
    ASSERT_TRUE(comes_true([&] { return loop.device->status().connections > 0; }));
    ASSERT_TRUE(comes_true([&] {
      step(*loop.device);
      return is_ready(loop);
    }));
    pose.X_BH.p.z() = -0.003;
    measure("force device (HID)", loop, samples, [&] {
      step(*loop.device);
      wait_1ms();
    });
  }
};
TEST_F(ForceDeviceLatency, is_measured) { run(some); }
TEST_F(ForceDeviceLatency, Soak_is_measured) { run(many); }

struct PuckLatency : PuckTest {
  void run(const char* what, std::uint64_t samples, const Bytes& one, const Bytes& other) {
    plug();
    PressedBlock loop({.vendor = puck.vendor});
    ASSERT_TRUE(gets_ready(loop));
    bool odd = false;
    measure(what, loop, samples, [&] {
      send(*loop.device, (odd = !odd) ? one : other);
      wait_1ms();
    });
  }
  void run_puck(std::uint64_t samples) {
    run("SpaceMouse (HID)", samples, words(1, {100, 0, 0}), words(1, {-100, 0, 0}));
  }
  void run_pad(std::uint64_t samples) {
    puck.vendor = 0x046d;
    puck.product = 0xc216;
    puck.descriptor = f310_descriptor();
    run("game pad (HID)", samples, {200, 128, 128, 128, 8, 0, 0, 0},
        {100, 128, 128, 128, 8, 0, 0, 0});
  }
};
TEST_F(PuckLatency, of_a_space_mouse_is_measured) { run_puck(some); }
TEST_F(PuckLatency, of_a_game_pad_is_measured) { run_pad(some); }
TEST_F(PuckLatency, Soak_of_a_space_mouse_is_measured) { run_puck(many); }
TEST_F(PuckLatency, Soak_of_a_game_pad_is_measured) { run_pad(many); }

}  // namespace
}  // namespace sonde::test
