// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/devices/connection.hpp"

namespace sonde {

/// Lists the connected 6-DoF devices once a second, in its own thread, without opening them.
class HotplugMonitor {
 public:
  HotplugMonitor();
  ~HotplugMonitor();
  HotplugMonitor(const HotplugMonitor&) = delete;
  HotplugMonitor& operator=(const HotplugMonitor&) = delete;

  /// The last list; empty before the first look is finished.
  std::vector<ConnectedDevice> connected() const;

 private:
  void run();

  mutable std::mutex mutex_;  // guards the members below
  std::condition_variable stop_;
  bool stopping_ = false;
  std::vector<ConnectedDevice> connected_;

  std::thread thread_;  // last, since it uses the others
};

}  // namespace sonde
