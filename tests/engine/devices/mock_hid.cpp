// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/engine/devices/mock_hid.hpp"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <vector>

namespace sonde::test {
namespace {

std::string hex(std::uint32_t value, int digits) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%0*X", digits, value);
  return text.data();
}

std::string hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += hex(byte, 2);
  return text;
}

[[noreturn]] void fail(const std::string& what, GError* error) {
  throw std::runtime_error(what + (error ? std::string(": ") + error->message : ""));
}

std::string usb_folder(const MockHid& device) {
  return "/devices/pci0000:00/usb1/1-" + std::to_string(device.number);
}
std::string interface_folder(const MockHid& device) {
  return usb_folder(device) + "/1-" + std::to_string(device.number) + ":1." +
         std::to_string(device.interface);
}
std::string hid_folder(const MockHid& device) {
  return interface_folder(device) + "/0003:" + hex(device.vendor, 4) + ":" +
         hex(device.product, 4) + "." + hex(static_cast<std::uint32_t>(device.number), 4);
}
std::string node_folder(const MockHid& device) {
  return hid_folder(device) + "/hidraw/hidraw" + std::to_string(device.number);
}

/// In umockdev's own format, parents first.
std::string description(const MockHid& device) {
  const std::string number = std::to_string(device.number);
  const std::string ids = "0003:0000" + hex(device.vendor, 4) + ":0000" + hex(device.product, 4);
  const std::string descriptor =
      device.descriptor_in_sysfs ? "H: report_descriptor=" + hex(device.descriptor) + "\n" : "";
  return "P: " + usb_folder(device) +
         "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + hex(device.vendor, 4) +
         "\\n\nA: idProduct=" + hex(device.product, 4) +
         "\\n\nA: manufacturer=Maker\\n\nA: product=" + device.name +
         "\\n\nA: serial=" + device.serial +
         "\\n\nA: bcdDevice=0100\\n\n\nP: " + interface_folder(device) +
         "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=" +
         hex(static_cast<std::uint32_t>(device.interface), 2) + "\\n\n\nP: " + hid_folder(device) +
         "\nE: SUBSYSTEM=hid\nE: HID_ID=" + ids + "\nE: HID_NAME=Maker " + device.name + "\n" +
         descriptor + "A: uevent=HID_ID=" + ids + "\\nHID_NAME=Maker " + device.name +
         "\\nHID_PHYS=" + device.place() + "\\nHID_UNIQ=" + device.serial +
         "\\n\n\nP: " + node_folder(device) + "\nN: hidraw" + number + "\nE: DEVNAME=/dev/hidraw" +
         number + "\nE: SUBSYSTEM=hidraw\nE: MAJOR=242\nE: MINOR=" + number +
         "\nA: dev=242:" + number + "\\n\nL: device=../../../" +
         hid_folder(device).substr(hid_folder(device).rfind('/') + 1) + "\n\n";
}

/// Answers the questions hidapi asks a node.
gboolean answer_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data) {
  const auto& device = *static_cast<const MockHid*>(data);
  const gulong request = umockdev_ioctl_client_get_request(client);
  const auto reply = [&](std::span<const std::uint8_t> bytes, std::size_t room, int result) {
    UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
    UMockdevIoctlData* to = umockdev_ioctl_data_resolve(arg, 0, room, nullptr);
    umockdev_ioctl_data_update(to, 0, const_cast<guint8*>(bytes.data()),
                               static_cast<gint>(bytes.size()));
    umockdev_ioctl_data_unref(to);
    umockdev_ioctl_client_complete(client, result, 0);
  };
  const bool size_asked = request == static_cast<gulong>(HIDIOCGRDESCSIZE);
  const bool feature_asked = _IOC_TYPE(request) == 'H' && _IOC_NR(request) == 0x07;
  if (size_asked) {
    const Bytes size{static_cast<std::uint8_t>(device.descriptor.size()),
                     static_cast<std::uint8_t>(device.descriptor.size() >> 8), 0, 0};
    reply(size, size.size(), 0);
  } else if (feature_asked && !device.feature.empty()) {
    const std::size_t bytes = std::min<std::size_t>(device.feature.size(), _IOC_SIZE(request));
    reply(std::span(device.feature).first(bytes), bytes, static_cast<int>(bytes));
  } else {
    umockdev_ioctl_client_complete(client, -1, EPIPE);
  }
  return TRUE;
}

/// What the bed leaves of a node it removes, and would stumble over when its pty is used again.
void forget_node(UMockdevTestbed* bed, const MockHid& device) {
  gchar* text = umockdev_testbed_get_root_dir(bed);
  const std::filesystem::path root(text);
  g_free(text);
  std::string pty = std::filesystem::read_symlink(root / device.path().substr(1)).string();
  std::ranges::replace(pty, '/', '_');
  std::filesystem::remove(root / "dev/.ptymap" / pty);
}

}  // namespace

struct MockSystem::State {
  struct Plugged {
    MockHid device;
    UMockdevIoctlBase* handler = nullptr;
    int fd = -1;  ///< the device's end of its node; the test bed's to close
  };
  UMockdevTestbed* bed = nullptr;
  std::map<int, Plugged> plugged;
  /// The bed's own thread may still answer for what is unplugged: it stays where it was.
  std::vector<std::map<int, Plugged>::node_type> gone;

  int fd(int number) const { return plugged.at(number).fd; }
};

MockSystem::MockSystem() : state_(std::make_unique<State>()) {
  ::setenv("SONDE_HAPLY_PORT", "0", 0);  // nor an arm of the machine, unless a test plays one
  state_->bed = umockdev_testbed_new();  // before the question: the first answer is kept
  if (!umockdev_in_mock_environment()) {
    g_object_unref(state_->bed);
    throw std::runtime_error("to be run as: umockdev-wrapper PROGRAM (Debian package umockdev)");
  }
}

MockSystem::~MockSystem() {
  while (!state_->plugged.empty()) unplug(state_->plugged.begin()->first);
  g_object_unref(state_->bed);
}

void MockSystem::plug(const MockHid& device) {
  State::Plugged& plugged = state_->plugged[device.number];
  plugged.device = device;
  GError* error = nullptr;
  if (device.answers_ioctl) {
    plugged.handler = umockdev_ioctl_base_new();
    g_signal_connect_after(plugged.handler, "handle-ioctl", G_CALLBACK(answer_ioctl),
                           &plugged.device);
    if (!umockdev_testbed_attach_ioctl(state_->bed, device.path().c_str(), plugged.handler, &error))
      fail("attach_ioctl", error);
  }
  if (!umockdev_testbed_add_from_string(state_->bed, description(device).c_str(), &error))
    fail("add_from_string", error);
  plugged.fd = umockdev_testbed_get_dev_fd(state_->bed, device.path().c_str());
}

void MockSystem::unplug(int number) {
  State::Plugged& plugged = state_->plugged.at(number);
  forget_node(state_->bed, plugged.device);
  // The bed keeps its end of the node open, and the host would hear nothing of it.
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, plugged.fd);
  ::close(nothing);
  if (plugged.handler)
    umockdev_testbed_detach_ioctl(state_->bed, plugged.device.path().c_str(), nullptr);
  for (const auto folder : {node_folder, hid_folder, interface_folder, usb_folder})
    umockdev_testbed_remove_device(state_->bed, ("/sys" + folder(plugged.device)).c_str());
  if (plugged.handler) g_object_unref(plugged.handler);
  state_->gone.push_back(state_->plugged.extract(number));
}

void MockSystem::send(int number, std::span<const std::uint8_t> report) {
  if (::write(state_->fd(number), report.data(), report.size()) !=
      static_cast<ssize_t>(report.size()))
    throw std::runtime_error("the mock device cannot send");
}

Bytes MockSystem::written(int number, int milliseconds) {
  pollfd ready{.fd = state_->fd(number), .events = POLLIN, .revents = 0};
  Bytes bytes;
  std::array<std::uint8_t, 4096> some{};
  // A read stops at the ends of the pty's own buffers: not all at once, and not at a report's end.
  while (::poll(&ready, 1, bytes.empty() ? milliseconds : 0) > 0 && (ready.revents & POLLIN) != 0) {
    const ssize_t count = ::read(ready.fd, some.data(), some.size());
    if (count <= 0) break;
    bytes.insert(bytes.end(), some.begin(), some.begin() + count);
  }
  return bytes;
}

}  // namespace sonde::test
