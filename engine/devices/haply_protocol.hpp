// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/pose.hpp"

/// What Haply's Inverse Service and its clients say to each other: JSON over a WebSocket, formats
/// 3.1 to 3.5 (https://docs.haply.co/inverseSDK/service, "WebSocket Protocol", "Basis Permutation",
/// "Mount & Workspace Transforms"). Its frame is ours: x to the right, y away from the user, z up;
/// m, N. No socket, no clock.
namespace sonde::haply {

/// What a message says of an Inverse3; a member is empty where the message does not mention it.
struct Arm {
  std::string id;
  std::optional<std::string> model;  ///< "inverse3", "inverse3x", "minverse"
  std::optional<Vec3> position;      ///< of the cursor, m
  std::optional<bool> calibrated, powered;
  std::optional<std::string> basis;  ///< the order of the axes: "XYZ" is the service's own
  /// Lengths are not those of the hand: by its mount, or by its place in a scene.
  std::optional<bool> mount_scaled, place_scaled;
};

/// What a message says of a VerseGrip, wired or not.
struct Grip {
  std::string id;
  std::optional<Quat> orientation;  ///< as sent, not yet normalised
  std::optional<bool> ready;        ///< connected and awake
  std::uint32_t buttons = 0;        ///< bit 0: the first by its name
};

struct Message {
  std::vector<Arm> arms;
  std::vector<Grip> grips;
};

/// A message of the service. No value if it is not one: no JSON, or something of the wrong type.
/// What this program does not know is passed over.
std::optional<Message> decode(std::string_view text);

struct Command {
  Vec3 force = Vec3::Zero();    ///< N
  bool ask_everything = false;  ///< the reply shall hold configuration and status too
  bool set_basis = false;       ///< the axes shall be the service's own
};
/// A message for the arm. The service answers each with one.
std::string encode(const std::string& arm, const Command& command);

}  // namespace sonde::haply
