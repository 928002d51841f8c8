// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_owner.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "engine/platform/writable_file.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

constexpr const char* daemons[] = {"spacenavd", "3dxsrv", "3dxserver"};

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::string command_of(const fs::path& process) {
  std::ifstream file(process / "comm");
  std::string name;
  std::getline(file, name);
  return name;
}

bool has_open(const fs::path& process, const std::string& path) {
  std::error_code error;
  for (fs::directory_iterator link(process / "fd", error), end; !error && link != end;
       link.increment(error)) {
    std::error_code unreadable;
    if (fs::read_symlink(link->path(), unreadable) == path) return true;
  }
  return false;
}

std::string described(const std::string& name, const std::string& number) {
  std::string text = name;
  return text.append(" (process ").append(number).append(")");
}

std::string advice(const std::string& name) {
  return name == "spacenavd" ? "; 'systemctl stop spacenavd' stops it" : "";
}

}  // namespace

std::string other_owner(const std::string& path, const fs::path& proc) {
  std::string maybe;
  std::error_code error;
  for (fs::directory_iterator process(proc, error), end; !error && process != end;
       process.increment(error)) {
    const std::string number = process->path().filename().string();
    if (!is_number(number) || number == std::to_string(process_number())) continue;
    const std::string name = command_of(process->path());
    const std::string who = described(name, number);
    if (has_open(process->path(), path)) return who + " has it open" + advice(name);
    if (std::ranges::find(daemons, name) != std::end(daemons))
      maybe = who + " runs, and may hold it" + advice(name);
  }
  return maybe;
}

}  // namespace sonde
