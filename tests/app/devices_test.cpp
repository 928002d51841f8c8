// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "engine/devices/hid_device.hpp"
#include "tests/app/app_test.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/haply_standin.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Devices = AppTest;

std::string hex(const std::vector<std::uint8_t>& bytes) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) text.append({digits[byte >> 4], digits[byte & 15]});
  return text;
}

/// A puck in umockdev's format.
std::string puck() {
  return "P: /devices/usb1/1-1\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=256f\\n\n"
         "A: idProduct=c635\\n\nA: manufacturer=3Dconnexion\\n\nA: product=SpaceMouse Compact\\n\n"
         "A: bcdDevice=0437\\n\n\n"
         "P: /devices/usb1/1-1/1-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
         "A: bInterfaceNumber=00\\n\n\n"
         "P: /devices/usb1/1-1/1-1:1.0/0003:256F:C635.0001\nE: SUBSYSTEM=hid\n"
         "E: HID_ID=0003:0000256F:0000C635\nE: HID_NAME=SpaceMouse Compact\n"
         "H: report_descriptor=" +
         hex(split_descriptor()) +
         "\nA: uevent=HID_ID=0003:0000256F:0000C635\\nHID_NAME=SpaceMouse Compact\\n"
         "HID_PHYS=usb\\nHID_UNIQ=\\n\n\n"
         "P: /devices/usb1/1-1/1-1:1.0/0003:256F:C635.0001/hidraw/hidraw7\nN: hidraw7\n"
         "E: DEVNAME=/dev/hidraw7\nE: SUBSYSTEM=hidraw\nE: MAJOR=242\nE: MINOR=7\n"
         "A: dev=242:7\\n\nL: device=../../../0003:256F:C635.0001\n\n";
}

/// `sonde devices ARGUMENTS` where what umockdev plays is connected; `questions` are the answers to
/// hidapi's questions, without which a device does not open.
Outcome devices(const TempFolder& folder, const std::string& connected,
                const std::string& questions, const std::string& arguments) {
  folder.write("connected.umockdev", connected);
  folder.write("questions.ioctl", questions);
  const std::string mock = connected.empty() ? "umockdev-run"
                                             : "umockdev-run --device connected.umockdev "
                                               "--ioctl /dev/hidraw7=questions.ioctl";
  const std::string command = "cd '" + folder.path().string() + "' && " + mock +
                              " -- '" SONDE_PROGRAM "' devices " + arguments + " >out 2>err";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "out"),
          text_of(folder / "err")};
}

const char* const size_of_descriptor = "@DEV /dev/hidraw7\nHIDIOCGRDESCSIZE 0 71000000\n";

TEST_F(Devices, nothing_connected_is_no_error) {
  const Outcome run = devices(folder, "", "", "");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, testing::StartsWith("no 6-DoF device is connected\n" + without_hid() +
                                           "\nmakers' libraries"));
  const json none = json::parse(devices(folder, "", "", "--json").out);
  EXPECT_EQ(none.at("format"), 1);
  EXPECT_EQ(none.at("devices"), json::array());
}

TEST_F(Devices, a_puck_is_listed_with_what_it_can) {
  const Outcome text = devices(folder, puck(), size_of_descriptor, "");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("/dev/hidraw7  256f:c635  SpaceMouse Compact (six-axis puck)\n"
                                  "  opens: deflection, 2 buttons, light\n"));
  const Outcome run = devices(folder, puck(), size_of_descriptor, "--json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json device = json::parse(run.out).at("devices").at(0);
  EXPECT_EQ(device.at("id"), "256f:c635");
  EXPECT_EQ(device.at("kind"), "space_mouse");
  EXPECT_EQ(device.at("opens"), true);
  EXPECT_EQ(device.at("reason"), nullptr);
  EXPECT_EQ(device.at("capabilities").at("force"), false);
  EXPECT_EQ(device.at("capabilities").at("buttons"), 2);
}

TEST_F(Devices, one_that_does_not_open_is_listed_with_the_reason) {
  std::string bare = puck();
  const std::size_t line = bare.find("H: report_descriptor");
  bare.erase(line, bare.find('\n', line) + 1 - line);
  const Outcome text = devices(folder, bare, size_of_descriptor, "");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("does not open: /dev/hidraw7: its report descriptor"));
  const Outcome run = devices(folder, bare, size_of_descriptor, "--json");
  const json device = json::parse(run.out).at("devices").at(0);
  EXPECT_EQ(device.at("opens"), false);
  EXPECT_THAT(device.at("reason").get<std::string>(), HasSubstr("/dev/hidraw7: "));
  EXPECT_EQ(device.at("capabilities"), nullptr);
}

TEST_F(Devices, a_makers_library_that_is_missing_says_how_to_get_it) {
  const Outcome text = devices(folder, "", "", "");
  EXPECT_THAT(text.out, HasSubstr("libdhd (Force Dimension): not installed; install libdhd from"));
  EXPECT_THAT(text.out, HasSubstr("SONDE_LIBHD"));
  const json all = json::parse(devices(folder, "", "", "--json").out).at("libraries");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].at("name"), "libdhd");
  EXPECT_EQ(all[0].at("usable"), false);
  EXPECT_EQ(all[0].at("version"), nullptr);
  EXPECT_THAT(all[0].at("reason").get<std::string>(), HasSubstr("forcedimension.com"));
}

TEST_F(Devices, an_arm_is_listed_with_its_librarys_version) {
  ::setenv("SONDE_LIBDHD", STANDIN_DHD, 1);
  const Outcome text = devices(folder, "", "", "");
  const json all = json::parse(devices(folder, "", "", "--json").out);
  ::setenv("SONDE_LIBDHD", "\x1b[31mrelative.so", 1);
  const Outcome bad = devices(folder, "", "", "");
  ::unsetenv("SONDE_LIBDHD");
  EXPECT_THAT(text.out,
              HasSubstr("libdhd/0  1451:0000  sigma.7 right-handed (force arm)\n  opens: position, "
                        "force to 12 N and 0.2 N·m, stiff to 4000 N/m, 1000 Hz, 1 buttons\n"));
  EXPECT_THAT(text.out, HasSubstr("libdhd (Force Dimension): 3.14.1.0, " STANDIN_DHD "\n"));
  EXPECT_EQ(all.at("devices").at(0).at("kind"), "force_arm");
  EXPECT_EQ(all.at("devices").at(0).at("serial"), "4000");
  EXPECT_EQ(all.at("libraries").at(0).at("version"), "3.14.1.0");
  EXPECT_EQ(bad.exit_code, 0);
  EXPECT_THAT(bad.out,
              HasSubstr("\\x1b[31mrelative.so: the environment variable SONDE_LIBDHD must hold"));
}

TEST_F(Devices, an_arm_of_haply_is_listed_with_its_service) {
  const std::string missing = devices(folder, "", "", "").out;
  EXPECT_THAT(missing, HasSubstr("Inverse Service (Haply): ws://127.0.0.1:"));
  EXPECT_THAT(missing, HasSubstr("efused; it comes with Haply Hub"));
  const HaplyStandin standin;
  const Outcome text = devices(folder, "", "", "");
  EXPECT_THAT(text.out, HasSubstr("haply/049D  0000:0000  Haply Inverse3 (force arm)\n  opens: "
                                  "position, force to 10 N, no torque, 1000 Hz, 3 buttons\n"));
  const std::string address = "ws://127.0.0.1:" + std::to_string(standin.port());
  EXPECT_THAT(text.out, HasSubstr("Inverse Service (Haply): " + address + "\n"));
  const json all = json::parse(devices(folder, "", "", "--json").out);
  EXPECT_EQ(all.at("devices").at(0).at("serial"), "haply-049D");
  EXPECT_EQ(all.at("libraries").at(2).at("path"), address);
}

/// The stand-in with the head of a library for another processor: 32-bit ARM (ELF: bytes 4 and 18).
TEST_F(Devices, a_makers_library_for_another_processor_is_named_and_the_others_work) {
  std::string foreign = text_of(STANDIN_DHD);
  foreign[4] = '\x01';
  foreign[18] = '\x28';
  const auto file = folder.write("libdhd.so", foreign);
  ::setenv("SONDE_LIBDHD", file.c_str(), 1);
  const Outcome run = devices(folder, puck(), size_of_descriptor, "");
  ::unsetenv("SONDE_LIBDHD");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(file.string()));
  EXPECT_THAT(run.out, HasSubstr("another processor"));
  EXPECT_THAT(run.out, HasSubstr("32-bit ARM"));
  EXPECT_THAT(run.out, HasSubstr("SpaceMouse Compact (six-axis puck)\n  opens:"));
}

/// A library of that name in the folder that the program is started in is nobody's word.
TEST_F(Devices, a_makers_library_in_the_current_folder_is_not_loaded) {
  for (const char* name : {"libdhd.so", "libdhd.so.3", "libHD.so"})
    std::filesystem::copy_file(STANDIN_DHD, folder / name);
  const json all = json::parse(devices(folder, "", "", "--json").out).at("libraries");
  for (const json& library : all) EXPECT_EQ(library.at("usable"), false) << library;
}

TEST_F(Devices, it_takes_no_arguments_and_writes_where_it_is_told) {
  expect_refused("devices more", 2, "more");
  expect_refused("devices --out none/there.txt", 3, "none");
  ASSERT_EQ(devices(folder, puck(), size_of_descriptor, "--out list.txt").exit_code, 0);
  EXPECT_THAT(text_of(folder / "list.txt"), HasSubstr("SpaceMouse Compact"));
}

}  // namespace
}  // namespace sonde::test
