// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The functions of Force Dimension's libdhd that are called, declared anew from public
/// descriptions of its C interface. Sources:
///   [C] CHAI3D (BSD), github.com/chai3d/chai3d, src/devices/CDeltaDevices.cpp, which declares the
///       functions that it loads at run time and gives the models' limits;
///   [P] forcedimension_core (MIT), github.com/EmDash00/forcedimension_core-python, dhd/__init__.py
///       and constants.py: argument and result types of each function, units, enumerations;
///   [R] forcedimension_ros2 (Apache-2.0), github.com/ICube-Robotics/forcedimension_ros2,
///       fd_hardware/src/fd_effort_hi.cpp: the order of calls on opening and closing.
/// Lengths are in metres, forces in N, torques in N·m [P] [C]. Axes: x towards the user, y to the
/// right, z up: [C] takes positions, frames and forces into its own axes unchanged, and converts
/// OpenHaptics' axes (hd_api.hpp) to the same ones. The origin is not the middle of the volume: [C]
/// shifts a sigma's by (-0.01, ±0.02, 0) m. Enabling the force needs no expert mode, though [C]
/// enters it: the maker's own examples do not. A device is identified by the number that opening it
/// returns. Results: 0 done, below 0 failed, above 0 done with a remark [P].
namespace sonde::dhd {

/// Called again too early: the last pose is returned again [P].
inline constexpr int timeguard = 1;

// Indices of the words that dhdGetStatus writes [P]; the second source of the names and numbers is
// the status class of a ROS driver, which lists them in this order.
inline constexpr int status_words = 17;  ///< DHD_MAX_STATUS of 3.14 [P]; 16 before
inline constexpr int status_power = 0;
inline constexpr int status_connected = 1;
inline constexpr int status_reset = 3;
inline constexpr int status_error = 9;
inline constexpr int status_force_off_cause = 14;

/// Why the controller has switched its force off: word 14 of the status [P].
enum class ForceOff { not_off, button, velocity, watchdog, software, usb, dead_man };

// Results of dhdErrorGetLast [P]: the connection is lost.
inline constexpr int error_com = 2;
inline constexpr int error_no_device = 5;
inline constexpr int error_timeout = 7;

/// System types, of dhdGetSystemType [P], [C].
enum class Model {
  omega3 = 33,
  omega6_right = 34,
  omega7_right = 35,
  omega6_left = 36,
  omega7_left = 37,
  falcon = 60,
  delta3 = 63,
  sigma7_right = 104,
  sigma7_left = 105,
  lambda7_right = 108,
  lambda7_left = 109,
};

/// The functions, bound by bind() to a loaded library.
struct Api {
  // [P]; for the library of the program, before anything is open.
  void (*dhdGetSDKVersion)(int* major, int* minor, int* release, int* revision);
  int (*dhdGetDeviceCount)();  // [C] [P]
  // The argument is the index in the order of the system, from 0; returns the device's number, or
  // below 0 on failure [C] [P].
  int (*dhdOpenID)(char index);
  int (*dhdClose)(char id);                                         // [C] [P] [R]
  int (*dhdStop)(char id);                                          // no force, brakes on [P] [R]
  int (*dhdGetSystemType)(char id);                                 // [C] [P]
  const char* (*dhdGetSystemName)(char id);                         // [P] [R]
  int (*dhdGetSerialNumber)(unsigned short* number, char id);       // [P]
  bool (*dhdHasWrist)(char id);                                     // [P] [R]
  int (*dhdGetStatus)(int* words, char id);                         // [P]
  int (*dhdEnableForce)(unsigned char on, char id);                 // [C] [P] [R]
  int (*dhdSetGravityCompensation)(int on, char id);                // [P] [R]
  unsigned (*dhdGetButtonMask)(char id);                            // [C] [P]
  int (*dhdGetPosition)(double* x, double* y, double* z, char id);  // m [C] [P] [R]
  // Position, m, and the handle's axes as columns, in the base [P].
  int (*dhdGetPositionAndOrientationFrame)(double* x, double* y, double* z, double rows[3][3],
                                           char id);
  // Force, N, and torque, N·m, in the base [C] [P].
  int (*dhdSetForceAndTorque)(double fx, double fy, double fz, double tx, double ty, double tz,
                              char id);
  int (*dhdErrorGetLast)();             // for the calling thread [P]
  const char* (*dhdErrorGetLastStr)();  // [P] [R]
};

template <class Library>
void bind(Api& api, const Library& library) {
  library.bind(api.dhdGetSDKVersion, "dhdGetSDKVersion");
  library.bind(api.dhdGetDeviceCount, "dhdGetDeviceCount");
  library.bind(api.dhdOpenID, "dhdOpenID");
  library.bind(api.dhdClose, "dhdClose");
  library.bind(api.dhdStop, "dhdStop");
  library.bind(api.dhdGetSystemType, "dhdGetSystemType");
  library.bind(api.dhdGetSystemName, "dhdGetSystemName");
  library.bind(api.dhdGetSerialNumber, "dhdGetSerialNumber");
  library.bind(api.dhdHasWrist, "dhdHasWrist");
  library.bind(api.dhdGetStatus, "dhdGetStatus");
  library.bind(api.dhdEnableForce, "dhdEnableForce");
  library.bind(api.dhdSetGravityCompensation, "dhdSetGravityCompensation");
  library.bind(api.dhdGetButtonMask, "dhdGetButtonMask");
  library.bind(api.dhdGetPosition, "dhdGetPosition");
  library.bind(api.dhdGetPositionAndOrientationFrame, "dhdGetPositionAndOrientationFrame");
  library.bind(api.dhdSetForceAndTorque, "dhdSetForceAndTorque");
  library.bind(api.dhdErrorGetLast, "dhdErrorGetLast");
  library.bind(api.dhdErrorGetLastStr, "dhdErrorGetLastStr");
}

}  // namespace sonde::dhd
