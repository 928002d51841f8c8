// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_arm.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "engine/devices/connection.hpp"
#include "engine/devices/input_device.hpp"
#include "tests/engine/devices/makers.hpp"
#include "tests/engine/devices/over_hid.hpp"

namespace sonde::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Libraries : testing::Test {
  MockSystem system;  ///< no HID device of the machine takes part
  Libraries() { forget_makers(); }
  ~Libraries() override { forget_makers(); }
};

/// The same of both makers: what is wrong with an arm ends its force, and the program goes on.
struct Arms : Libraries, testing::WithParamInterface<Maker> {
  const Maker& maker = GetParam();
  LoadedStandin standin{maker.library};
  Arms() { ::setenv(maker.variable, maker.library, 1); }

  static bool pushes(InputDevice& device, const LoadedStandin& standin) {
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
    return device.latest().state == DeviceState::ready && standin.force().norm() > 0.99;
  }
  /// A force, then the fault: no force, the state, and the reason.
  /// A library that calls back no more cannot be told a force of zero: it is closed.
  template <class Fault, class Mend>
  void expect_let_go(const char* reason, DeviceState state, const Fault& fault, const Mend& mend) {
    InputDevice device({.path = maker.path});
    ASSERT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
    fault();
    std::string said;
    ASSERT_TRUE(comes_true([&] {
      device.set_wrench({{1, 0, 0}, {0, 0, 0}});
      const DeviceStatus status = device.status();
      if (status.state == state && said.empty()) said = status.reason;
      return !said.empty() && (standin.force().isZero(0) || !standin->force_on);
    })) << device.status().reason;
    EXPECT_THAT(said, HasSubstr(reason));
    mend();
    EXPECT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
  }
};

TEST_P(Arms, is_listed_and_opens_with_what_it_can) {
  const auto all = list_devices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].info.path, maker.path);
  EXPECT_EQ(all[0].kind, DeviceKind::arm);
  EXPECT_TRUE(all[0].opens) << all[0].reason;
  EXPECT_THAT(all[0].name, testing::AnyOf("sigma.7 right-handed", "Touch"));
  EXPECT_GT(all[0].capabilities.max_force, 3);
}

TEST_P(Arms, the_loop_is_closed_pose_in_wrench_out) {
  InputDevice device({.path = maker.path});
  ASSERT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
  for (int i = 1; i <= 20; ++i) {
    standin.move_to(Vec3(0, 0.001 * i, 0) / maker.unit);
    ASSERT_TRUE(comes_true([&] {
      const DeviceSample sample = device.latest();
      device.set_wrench({-50 * sample.X_BH.p, Vec3::Zero()});
      return sample.X_BH.p.norm() > 0.001 * i - 1e-9 &&
             std::abs(standin.force().norm() - 0.05 * i) < 1e-9;
    })) << i
        << ' ' << device.status().reason;
    // Towards the origin, in the library's own axes: whatever they are called.
    EXPECT_LT(standin.force().y(), 0);
  }
}

TEST_P(Arms, a_number_that_is_none) {
  expect_let_go(
      "finite", DeviceState::faulty, [&] { standin->nan = true; }, [&] { standin->nan = false; });
}

TEST_P(Arms, a_jump) {
  expect_let_go(
      "jumped", DeviceState::faulty, [&] { standin.move_to(Vec3(0, 0.06, 0) / maker.unit); },
      [] {});
}

TEST_P(Arms, a_handle_outside_the_volume) {
  expect_let_go(
      "working volume", DeviceState::faulty, [&] { standin.move_to(Vec3(0, 0.9, 0) / maker.unit); },
      [&] { standin.move_to(Vec3::Zero()); });
}

TEST_P(Arms, a_clock_that_stands) {
  expect_let_go(
      "nothing of use heard", DeviceState::silent, [&] { standin->frozen = true; },
      [&] { standin->frozen = false; });
}

TEST_P(Arms, a_velocity_limit_that_was_exceeded) {
  expect_let_go(
      "velocity limit was exceeded", DeviceState::faulty, [&] { standin->fault = maker.too_fast; },
      [] {});
}

TEST_P(Arms, a_calibration_that_was_lost) {
  expect_let_go(
      "not calibrated", DeviceState::faulty, [&] { standin->uncalibrated = true; },
      [&] { standin->uncalibrated = false; });
}

TEST_P(Arms, a_plug_that_was_pulled) {
  InputDevice device({.path = maker.path});
  ASSERT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
  const std::uint32_t session = device.latest().session;
  standin->unplugged = true;
  ASSERT_TRUE(comes_true([&] { return device.latest().state != DeviceState::ready; }));
  ASSERT_TRUE(comes_true([&] { return standin->open == 0; }));
  standin->unplugged = false;
  ASSERT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
  EXPECT_GT(device.latest().session, session) << "what came before is no neighbour";
}

TEST_P(Arms, a_wrench_that_nobody_renews_is_none) {
  InputDevice device({.path = maker.path});
  ASSERT_TRUE(comes_true([&] { return pushes(device, standin); })) << device.status().reason;
  EXPECT_TRUE(comes_true([&] { return standin.force().isZero(0); }));
}

INSTANTIATE_TEST_SUITE_P(Makers, Arms, testing::Values(force_dimension, three_d),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Libraries, two_of_force_dimensions_are_told_apart_by_their_serial_numbers) {
  const LoadedStandin standin(STANDIN_DHD);
  ::setenv("SONDE_LIBDHD", STANDIN_DHD, 1);
  standin->arms = 2;
  const std::vector<HidInfo> both = list_arms();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].serial, "4000");
  EXPECT_EQ(both[1].serial, "4001");
  InputDevice device({.serial = both[1].serial});
  ASSERT_TRUE(reaches(device, DeviceState::ready)) << device.status().reason;
  EXPECT_EQ(standin->which, 1);
  const int opened = standin->opened;
  EXPECT_EQ(list_arms().size(), 2U);
  EXPECT_EQ(standin->opened, opened) << "looked at while one is in use";
}

TEST_F(Libraries, open_haptics_knows_its_arms_by_the_names_that_are_listed) {
  const LoadedStandin standin(STANDIN_HD);
  ::setenv("SONDE_LIBHD", STANDIN_HD, 1);
  ::setenv("SONDE_HD_DEVICES", "Default Device,,Second", 1);
  const auto all = list_devices();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].opens);
  EXPECT_FALSE(all[1].opens);
  EXPECT_THAT(all[1].reason, AllOf(HasSubstr("libHD/Second"), HasSubstr("no such configuration")));
}

TEST_F(Libraries, a_library_that_is_missing_or_unfit_is_named_and_takes_nothing_else_along) {
  const auto listing = [](const char* name) {
    const auto all = list_vendor_libraries();
    return *std::ranges::find(all, name, &VendorLibraryListing::name);
  };
  EXPECT_FALSE(listing("libdhd").usable);
  EXPECT_THAT(listing("libdhd").reason,
              AllOf(HasSubstr("not installed"), HasSubstr("forcedimension.com"),
                    HasSubstr("SONDE_LIBDHD")));
  EXPECT_THAT(listing("libHD").reason, HasSubstr("OpenHaptics"));
  EXPECT_TRUE(list_arms().empty());
  ::setenv("SONDE_LIBDHD", STANDIN_DHD_WITHOUT, 1);
  ::setenv("SONDE_LIBHD", STANDIN_HD, 1);
  EXPECT_THAT(listing("libdhd").reason, HasSubstr("dhdErrorGetLastStr"));
  EXPECT_TRUE(listing("libHD").usable);
  EXPECT_EQ(listing("libHD").version, "3.4.0");
  EXPECT_EQ(list_arms().size(), 1U);
  EXPECT_THAT(refusal([] { ForceArm("libdhd/0"); }), HasSubstr("dhdErrorGetLastStr"));
  forget_makers();
  EXPECT_THAT(refusal([] { ForceArm("libHD/Default Device"); }),
              AllOf(HasSubstr("libHD/Default Device: "), HasSubstr("not installed")));
}

}  // namespace
}  // namespace sonde::test
