// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sonde::test {

using Bytes = std::vector<std::uint8_t>;

/// A USB HID device as the system shows it.
struct MockHid {
  int number = 7;  ///< of /dev/hidraw7
  std::uint16_t vendor = 0x256f, product = 0xc635;
  std::string name = "SpaceMouse Compact";
  std::string serial = "A1";
  int interface = 0;
  std::string port{};  ///< where it is plugged in; empty: one of its own for each number
  Bytes descriptor;
  Bytes feature{};  ///< the answer to any question for a feature report
  bool descriptor_in_sysfs = true;
  bool answers_ioctl = true;

  /// As the system names it.
  std::string place() const {
    return "usb-0000:00:14.0-" + (port.empty() ? std::to_string(number) : port) + "/input" +
           std::to_string(interface);
  }
  std::string path() const { return "/dev/hidraw" + std::to_string(number); }
};

/// The system's devices, played by umockdev: sysfs, udev's answers and device nodes, so that the
/// real hidapi opens, reads and writes them. Only under umockdev-wrapper; one at a time.
class MockSystem {
 public:
  MockSystem();  ///< throws where the program does not run under umockdev-wrapper
  ~MockSystem();
  MockSystem(const MockSystem&) = delete;
  MockSystem& operator=(const MockSystem&) = delete;

  /// Each time under another number: umockdev cannot give one twice.
  void plug(const MockHid& device);
  /// Whoever has it open is told by the next read or write, as on real hardware.
  void unplug(int number);

  /// The device sends a report. The node joins two into one where the host has not read the first
  /// yet: wait until it has.
  void send(int number, std::span<const std::uint8_t> report);
  /// What the host has written since the last call; waits up to the time for something.
  Bytes written(int number, int milliseconds = 2000);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde::test
