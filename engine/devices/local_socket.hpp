// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/devices/device_sample.hpp"

namespace sonde {

/// A WebSocket (RFC 6455) to a service on this machine: to 127.0.0.1 and nowhere else, in the
/// clear. Nothing waits longer than it is told to. One thread at a time.
class LocalSocket {
 public:
  /// A longer message is not one of a device's: the connection ends.
  static constexpr std::size_t longest_message = 256 * 1024;  // bytes

  /// Connects within the time. Throws InputError "ws://127.0.0.1:PORT: reason".
  LocalSocket(std::uint16_t port, DeviceClock::duration limit);
  ~LocalSocket();
  LocalSocket(const LocalSocket&) = delete;
  LocalSocket& operator=(const LocalSocket&) = delete;

  static std::string address(std::uint16_t port);

  /// Begins to send a text. Returns false if the one before it is still on its way, since the
  /// service does not read, or the connection has ended.
  bool send(std::string text);
  /// The next message, in the order of their arrival; no value if none comes until then, or the
  /// connection has ended.
  std::optional<std::string> receive(DeviceClock::time_point until);
  /// Whether everything sent is out; waits until then at most.
  bool flush(DeviceClock::time_point until);

  /// Why the connection has ended; empty while it lasts.
  const std::string& ended() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
