// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/devices/arm_reading.hpp"
#include "engine/devices/haply_protocol.hpp"
#include "engine/devices/local_socket.hpp"

namespace sonde {

/// Haply's Inverse Service as it is found on this machine.
struct HaplyService {
  std::string address;  ///< "ws://127.0.0.1:10001"
  bool answers = false;
  std::string reason{};            ///< why it is not usable
  std::vector<haply::Arm> arms{};  ///< that are connected to it
};

/// Looks for the service, for 0.3 s at most, and leaves it alone again. The environment variable
/// SONDE_HAPLY_PORT holds its port, 10001 if there is none; 0: it is not looked for.
HaplyService find_haply_service();

/// An open Inverse3 of Haply, by the Inverse Service; its VerseGrip, if there is one, gives the
/// orientation and the buttons; of several, one that is awake and that no other arm of this program
/// follows. Closes with the object, with its force off. It takes no torque.
///
/// The service answers each message with one, so the force goes out and the pose comes back once a
/// millisecond. Without an answer for 10 ms the service is told that the force is zero; without one
/// for 100 ms, or if it does not take what it is told, the connection is closed. A service that
/// hangs may hold its last force until its own watch acts.
class HaplyArm {
 public:
  /// Opens an arm by the id that the service gives it. Throws InputError "haply/ID: reason", also
  /// if this program has it open already.
  explicit HaplyArm(const std::string& id);
  ~HaplyArm();
  HaplyArm(const HaplyArm&) = delete;
  HaplyArm& operator=(const HaplyArm&) = delete;

  /// The number of arms that this program has open.
  static int open();
  const ArmIdentity& identity() const { return identity_; }
  /// Waits until the next message may go out: a wrench that is taken after this is the newest.
  void pace() const;
  /// Waits for the answer to the last message, at most 2 ms; sends one if none is on its way.
  ArmReading read();
  /// Sends the wrench, or keeps it for the next message while one is not answered. If `on` is
  /// false: no force. Returns false if the service does not take it.
  bool write(const DeviceWrench& wrench, bool on);
  /// From the newest message to its answer.
  std::chrono::duration<double, std::micro> round_trip() const { return round_trip_; }

 private:
  ArmReading heard(const std::string& text);
  ArmReading silent();
  ArmReading gone(const std::string& words) const;
  DeviceClock::time_point waits_since() const;
  void take(const haply::Message& message, const haply::Arm& arm);
  bool choose_grip(const std::vector<haply::Grip>& grips);
  std::string fault() const;
  bool send(const DeviceWrench& wrench);

  std::string id_;
  std::unique_ptr<LocalSocket> socket_;
  ArmIdentity identity_;
  haply::Arm arm_;    ///< the newest of each member
  haply::Grip grip_;  ///< the same; an empty id: there is none
  DeviceWrench wanted_;
  DeviceClock::time_point next_{}, heard_{}, sent_{};
  DeviceClock::time_point asked_{};      ///< when the oldest message without an answer went out
  DeviceClock::time_point caught_up_{};  ///< when every message was answered
  DeviceClock::duration round_trip_{};
  DeviceClock::time_point answers_{};  ///< the sample that the wrench on its way answers
  bool pushed_ = false;                ///< a force was told
  int unanswered_ = 0;                 ///< messages
  int without_ = 0;                    ///< messages in a row that do not mention the arm
  int without_grip_ = 0;               ///< the same of its grip
  int until_everything_ = 0;           ///< messages
};

}  // namespace sonde
