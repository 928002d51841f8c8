// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/hid_node.hpp"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace sonde {
namespace {

/// The folder of the HID device that has this node.
std::filesystem::path device_folder(const std::string& path) {
  return "/sys/class/hidraw/" + std::filesystem::path(path).filename().string() + "/device";
}

/// Closes with the object.
struct Descriptor {
  explicit Descriptor(int number) : number(number) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int number;
};

}  // namespace

HidNodeCheck check_hid_node(const std::string& path) {
  HidNodeCheck out;
  const Descriptor node(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  int size = 0;
  if (node.number < 0)
    out.opening = errno;
  else if (::ioctl(node.number, HIDIOCGRDESCSIZE, &size) < 0)
    out.asking = errno;
  return out;
}

std::string hid_port(const std::string& path) {
  constexpr std::string_view key = "HID_PHYS=";
  std::ifstream file(device_folder(path) / "uevent");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return line.substr(key.size());
  return "";
}

std::vector<std::uint8_t> hid_report_descriptor(const std::string& path) {
  std::ifstream file(device_folder(path) / "report_descriptor", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace sonde
