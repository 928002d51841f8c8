// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps the hand safe, from Haply's service to Haply's service: the reference is the force
// that the stand-in was told.
#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

#include "engine/devices/connection.hpp"
#include "tests/engine/devices/haply_standin.hpp"
#include "tests/engine/devices/pressed_block.hpp"

namespace sonde::test {
namespace {

using Manner = HaplyStandin::Manner;
using namespace std::chrono_literals;

struct HaplySafety : testing::Test {
  MockSystem system;  ///< no HID device of the machine takes part
  HaplyStandin standin;
  std::optional<PressedBlock> loop;

  ~HaplySafety() override {
    loop.reset();
    EXPECT_EQ(standin.broken(), "");
  }
  void begin(const DeviceChoice& choice = {.path = "haply/049D"}) {
    standin.move_to(rest);
    loop.emplace(choice, PressedBlock::settings());
    ASSERT_TRUE(comes_true([&] { return trusted(); })) << loop->device->status().reason;
  }
  bool trusted() { return loop->now().tick > 0 && loop->withheld() == Withheld::nothing; }
  /// Its handle 3 mm down: the probe is 2 mm deep, and the stiffness is 500 N/m by default.
  void press_in() {
    standin.move_to(rest - Vec3(0, 0, 0.003));
    ASSERT_TRUE(comes_true([&] { return pushed_back(); })) << standin.force().transpose();
  }
  bool pushed_back() const { return std::abs(standin.force().z() - 1) < 0.02; }
  bool let_go() const { return standin.force().isZero(0); }

  const Vec3 rest{0, -0.12, 0.15};  ///< as in the maker's example
};

TEST_F(HaplySafety, it_is_listed_opened_and_pushes_back) {
  const std::vector<DeviceListing> devices = list_devices();
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].info.path, "haply/049D");
  EXPECT_EQ(devices[0].kind, DeviceKind::arm);
  EXPECT_TRUE(devices[0].opens) << devices[0].reason;
  EXPECT_EQ(devices[0].name, "Haply Inverse3");
  begin({});
  press_in();
  EXPECT_EQ(loop->device->status().path, "haply/049D");
  EXPECT_EQ(list_devices().size(), 1U) << "listed while it is in use, too";
}

/// The zero comes by the connection that has the force, but for one that the service has closed, or
/// by which it floods and reads nothing.
TEST_F(HaplySafety, whatever_the_service_does_the_force_ends_and_rises_again) {
  for (const Manner manner : {Manner::silent, Manner::late, Manner::floods, Manner::closes}) {
    begin();
    press_in();
    const int now = standin.connections_so_far();
    standin.behave(manner);
    ASSERT_TRUE(comes_true([&] { return standin.until_zero() && let_go(); }))
        << static_cast<int>(manner);
    if (manner == Manner::silent || manner == Manner::late) {
      EXPECT_EQ(standin.connection_of_zero(), now);
    }
    EXPECT_TRUE(comes_true([&] { return loop->withheld() != Withheld::nothing; }));
    standin.behave(Manner::usual);
    EXPECT_TRUE(comes_true([&] { return pushed_back(); })) << static_cast<int>(manner);
    loop.reset();
  }
}

TEST_F(HaplySafety, a_pose_that_cannot_be_true_ends_the_force) {
  begin();
  press_in();
  standin.move_to(rest + Vec3(0, 0, 0.1));
  ASSERT_TRUE(comes_true([&] { return let_go(); })) << "a jump";
  begin();
  press_in();
  standin.move_to({0, 0, 5});
  ASSERT_TRUE(comes_true([&] { return let_go(); }));
  EXPECT_NE(loop->device->status().reason.find("outside its working volume"), std::string::npos)
      << loop->device->status().reason;
  begin();
  press_in();
  standin.say(R"({"inverse3": [{"device_id": "049D", "state": {"cursor_position": "high"}}]})");
  ASSERT_TRUE(comes_true([&] { return let_go(); }));
  standin.say("");
  standin.move_to(rest);
}

/// It is plugged in again: it moves the probe on, and its force rises from zero.
TEST_F(HaplySafety, one_that_is_unplugged_comes_back) {
  begin();
  press_in();
  standin.set("/inverse3/0/device_id", "\"none\"");
  ASSERT_TRUE(comes_true([&] { return loop->device->status().state == DeviceState::absent; }));
  standin.set("/inverse3/0/device_id", "\"049D\"");
  ASSERT_TRUE(comes_true([&] { return trusted(); }));
  EXPECT_EQ(loop->device->status().connections, 2U);
}

/// The service has been stopped: its port does not answer, and no force is left behind.
TEST_F(HaplySafety, the_end_of_the_loop_leaves_no_force) {
  begin();
  press_in();
  loop.reset();
  EXPECT_TRUE(comes_true([&] { return let_go(); }));
}

TEST_F(HaplySafety, Soak_from_a_sample_to_its_force) {
  begin();
  press_in();
  const auto end = DeviceClock::now() + 5min;
  while (loop->device->status().latency.samples < 20000 && DeviceClock::now() < end)
    std::this_thread::sleep_for(1ms);
  const LatencySummary latency = loop->device->status().latency;
  std::printf("%-28s %6llu samples: median %.2f ms, 99.9 %% %.2f ms\n", "Haply's service, played",
              static_cast<unsigned long long>(latency.samples), 1e-3 * latency.median,
              1e-3 * latency.p999);
  EXPECT_GE(latency.samples, 20000U);
  EXPECT_GT(latency.median, 0);
}

}  // namespace
}  // namespace sonde::test
