// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hid_device.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>

#include "engine/base/error.hpp"
#include "engine/devices/space_mouse.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Bytes bytes_of(const std::optional<std::span<const std::uint8_t>>& report) {
  if (!report) throw std::runtime_error("the device is gone");
  return {report->begin(), report->end()};
}

/// What opening it says is wrong.
std::string opening_refusal(const std::string& path) {
  try {
    const HidDevice opened(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "it opened";
}

TEST(HidDevice, what_is_connected_is_listed_with_what_it_says_of_itself) {
  MockSystem system;
  EXPECT_TRUE(list_hid().empty());
  system.plug({.number = 12, .descriptor = split_descriptor()});
  system.plug({.number = 3,
               .vendor = 0x046d,
               .product = 0xc077,
               .name = "Mouse",
               .serial = "Z9",
               .interface = 1,
               .descriptor = mouse_descriptor()});
  const std::vector<HidInfo> all = list_hid();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].path, "/dev/hidraw3");
  EXPECT_EQ(all[0].vendor, 0x046d);
  EXPECT_EQ(all[0].product, 0xc077);
  EXPECT_EQ(all[0].interface, 1);
  EXPECT_EQ(all[0].serial, "Z9");
  EXPECT_TRUE(all[0].has({1, 2}));
  EXPECT_EQ(all[1].path, "/dev/hidraw12");
  EXPECT_EQ(all[1].name, "SpaceMouse Compact");
  EXPECT_EQ(all[1].maker, "Maker");
  EXPECT_TRUE(all[1].has({1, 8}));
  EXPECT_FALSE(all[1].has({1, 2}));
}

TEST(HidDevice, a_build_without_hidapi_says_so_and_another_one_nothing) {
  EXPECT_NE(without_hid(false).find("built without hidapi\n"), std::string::npos);
  EXPECT_EQ(without_hid(true), "");
  EXPECT_EQ(without_hid().empty(), speaks_hid());
}

TEST(HidDevice, reports_go_in_and_out) {
  MockSystem system;
  system.plug({.descriptor = split_descriptor(), .feature = {5, 1, 2, 3}});
  HidDevice device("/dev/hidraw7");
  EXPECT_EQ(device.descriptor().inputs.size(), 8U);
  Bytes buffer(64);
  EXPECT_EQ(bytes_of(device.read(buffer, 0ms)), Bytes{}) << "nothing there yet";
  const Bytes report = words(1, {1, -2, 3});
  system.send(7, report);
  EXPECT_EQ(bytes_of(device.read(buffer, 2000ms)), report);
  const Bytes light{4, 1};
  EXPECT_TRUE(device.write(light));
  EXPECT_EQ(system.written(7), light);
  buffer[0] = 5;
  EXPECT_EQ(bytes_of(device.feature(buffer)), (Bytes{5, 1, 2, 3}));
}

TEST(HidDevice, a_device_that_is_unplugged_is_gone_at_the_next_read) {
  MockSystem system;
  system.plug({.descriptor = split_descriptor()});
  HidDevice device("/dev/hidraw7");
  system.unplug(7);
  EXPECT_TRUE(list_hid().empty());
  Bytes buffer(64);
  EXPECT_FALSE(device.read(buffer, 2000ms));
  buffer[0] = 5;
  EXPECT_FALSE(device.feature(buffer));
  EXPECT_THAT(opening_refusal("/dev/hidraw7"), HasSubstr("/dev/hidraw7: "));
}

TEST(HidDevice, a_device_without_a_readable_descriptor_is_refused) {
  MockSystem system;
  system.plug({.descriptor = split_descriptor(), .descriptor_in_sysfs = false});
  EXPECT_THAT(opening_refusal("/dev/hidraw7"), HasSubstr("/dev/hidraw7: its report descriptor"));
  // hidapi 0.13.1 would write into freed memory here; under AddressSanitizer this would show.
  system.plug({.number = 8, .descriptor = split_descriptor(), .answers_ioctl = false});
  EXPECT_THAT(opening_refusal("/dev/hidraw8"), HasSubstr("/dev/hidraw8: it is no HID device"));
}

/// The rights of a user whom no udev rule knows, where the tests run as root.
class NoPrivileges {
 public:
  NoPrivileges() : root_(::geteuid() == 0) {
    constexpr uid_t nobody = 65534;
    if (root_ && ::seteuid(nobody) != 0) throw std::runtime_error("cannot give up privileges");
  }
  ~NoPrivileges() {
    if (root_ && ::seteuid(0) != 0) std::abort();
  }
  NoPrivileges(const NoPrivileges&) = delete;
  NoPrivileges& operator=(const NoPrivileges&) = delete;

 private:
  bool root_;
};

TEST(HidDevice, without_permission_the_udev_rule_is_named) {
  const TempFolder folder;
  const std::string node = folder.write("hidraw7", "").string();
  std::filesystem::permissions(node, std::filesystem::perms::none);
  const NoPrivileges here;
  EXPECT_THAT(opening_refusal(node),
              AllOf(HasSubstr(node + ": no permission"), HasSubstr(udev_rule_file),
                    HasSubstr("/etc/udev/rules.d")));
}

TEST(HidDevice, the_udev_rule_knows_every_id_and_opens_nothing_to_all) {
  const std::string file = std::string(SONDE_PACKAGING) + "/" + udev_rule_file;
  EXPECT_LT(std::string(udev_rule_file), "73-seat-late.rules");
  const std::string rules = text_of(file);
  EXPECT_THAT(rules, Not(HasSubstr("MODE")));
  // What WakefulProcessors opens, and where it says so.
  EXPECT_THAT(rules, HasSubstr(R"(KERNEL=="cpu_dma_latency", SUBSYSTEM=="misc", TAG+="uaccess")"));
  for (unsigned product = 0; product <= 0xffff; ++product) {
    const auto id = static_cast<std::uint16_t>(product);
    if (!space_mouse_name(0x046d, id)) continue;
    std::ostringstream hex;
    hex << std::hex << product;
    EXPECT_THAT(rules, HasSubstr(hex.str()));
  }
  EXPECT_THAT(rules, HasSubstr(R"(ATTRS{idVendor}=="256f", TAG+="uaccess")"));
}

TEST(HidDevice, other_failures_to_open_say_what_they_are) {
  EXPECT_THAT(open_failure(EPERM), HasSubstr(udev_rule_file));
  EXPECT_THAT(open_failure(EBUSY), HasSubstr("another program"));
  EXPECT_THAT(open_failure(ENODEV), HasSubstr("not there any more"));
  EXPECT_EQ(open_failure(EMFILE), "Too many open files");
}

}  // namespace
}  // namespace sonde::test
