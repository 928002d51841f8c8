// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "engine/haptics/hand/awaited_hand.hpp"

namespace sonde::ui {

class Session;

/// Ends sessions in threads of their own: a search that is on its way, and the memory of large
/// meshes, take longer than a window may wait. Its own end waits for theirs.
class Endings {
 public:
  Endings();
  ~Endings();
  /// It is to be added soon, and counts until then. Null: nothing.
  void expect(Session* session);
  /// Lets go of what holds the probe, whose force falls gradually. Null: nothing.
  void add(std::unique_ptr<Session> session);
  /// No force any more from any of them.
  void stop_force();
  /// Of those that may still ask a device.
  std::vector<LoopEnded> unended() const;

 private:
  struct Ending {
    std::weak_ptr<Session> session;
    LoopEnded ended;
    std::future<void> over;
  };
  std::vector<Session*> expected_;
  std::vector<Ending> running_;
};

}  // namespace sonde::ui
