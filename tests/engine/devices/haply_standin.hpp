// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/devices/device_sample.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde::test {

/// Stands in for Haply's Inverse Service: a WebSocket on a free port of this machine, written from
/// the maker's documentation ("WebSocket Protocol": one answer to each message; the first message
/// lists everything). SONDE_HAPLY_PORT names it as long as it lives.
class HaplyStandin {
 public:
  enum class Manner {
    usual,
    silent,  ///< reads, and does not answer
    deaf,    ///< neither reads nor answers
    late,    ///< answers after 30 ms
    slow,    ///< answers after 5 ms
    pings,   ///< asks without an end whether the other side is there, and does not answer
    floods,  ///< answers a thousand times
    closes,  ///< ends the connection
    mute,    ///< accepts the connection, and does not even shake hands
    no_web,  ///< answers as something that is no WebSocket
  };

  HaplyStandin();
  ~HaplyStandin();
  HaplyStandin(const HaplyStandin&) = delete;
  HaplyStandin& operator=(const HaplyStandin&) = delete;

  std::uint16_t port() const;

  // What the arm does, and how the service behaves.
  void move_to(const Vec3& p);
  void turn_to(const Quat& q);
  void add_arm(const std::string& id);  ///< beside the first, "049D", and as it is then
  void behave(Manner manner);
  /// Takes the place of every answer; empty: the usual ones.
  void say(const std::string& text);
  /// Replaces a member of what is said of the arm or the grip, by JSON Pointer:
  /// "/inverse3/0/status/calibrated" with "false"; for one of the lists, "null" takes it away.
  void set(const std::string& pointer, const std::string& json);

  // What it was told.
  Vec3 force() const;              ///< the newest
  std::uint64_t asked() const;     ///< messages that came
  std::uint64_t answered() const;  ///< messages that went out, but for the first of a connection
  int connections() const;         ///< that are open
  /// From when the manner changed to when a force of zero came; none: not yet.
  std::optional<DeviceClock::duration> until_zero() const;
  /// The number of the connection that it came by, from 1.
  int connection_of_zero() const;
  int connections_so_far() const;
  std::string broken() const;  ///< the first rule of the protocol that was broken

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde::test
