// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_owner.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/support/temp_folder.hpp"

namespace sonde::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A folder of processes as the kernel shows it.
struct Processes {
  TempFolder proc;
  void add(const std::string& number, const std::string& command, const std::string& open = "") {
    fs::create_directories(proc / number / "fd");
    proc.write(number + "/comm", command + "\n");
    if (!open.empty()) fs::create_symlink(open, proc / number / "fd" / "5");
  }
};

TEST(DeviceHolder, nobody) {
  Processes processes;
  processes.add("12", "bash", "/dev/tty1");
  processes.add("irq", "spacenavd");
  EXPECT_EQ(other_owner("/dev/hidraw3", processes.proc.path()), "");
  EXPECT_EQ(other_owner("/dev/hidraw3", processes.proc / "none"), "");
}

TEST(DeviceHolder, who_has_it_open_is_named) {
  Processes processes;
  processes.add("12", "steam", "/dev/hidraw3");
  EXPECT_THAT(other_owner("/dev/hidraw3", processes.proc.path()),
              AllOf(HasSubstr("steam (process 12) has it open")));
  EXPECT_EQ(other_owner("/dev/hidraw33", processes.proc.path()), "");
}

TEST(DeviceHolder, a_daemon_whose_files_are_not_ours_to_see_is_named_with_what_to_do) {
  Processes processes;
  processes.add("812", "spacenavd");
  fs::remove_all(processes.proc / "812" / "fd");
  EXPECT_THAT(other_owner("/dev/hidraw3", processes.proc.path()),
              AllOf(HasSubstr("spacenavd (process 812) runs, and may hold it"),
                    HasSubstr("systemctl stop spacenavd")));
}

TEST(DeviceHolder, this_program_does_not_count) {
  Processes processes;
  processes.add(std::to_string(::getpid()), "sonde", "/dev/hidraw3");
  EXPECT_EQ(other_owner("/dev/hidraw3", processes.proc.path()), "");
}

}  // namespace
}  // namespace sonde::test
