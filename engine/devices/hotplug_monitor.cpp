// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hotplug_monitor.hpp"

#include <chrono>
#include <utility>

namespace sonde {

HotplugMonitor::HotplugMonitor() : thread_([this] { run(); }) {}

HotplugMonitor::~HotplugMonitor() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

std::vector<ConnectedDevice> HotplugMonitor::connected() const {
  const std::lock_guard lock(mutex_);
  return connected_;
}

void HotplugMonitor::run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    std::vector<ConnectedDevice> now = connected_devices();
    lock.lock();
    connected_ = std::move(now);
    stop_.wait_for(lock, std::chrono::seconds(1), [this] { return stopping_; });
  }
}

}  // namespace sonde
