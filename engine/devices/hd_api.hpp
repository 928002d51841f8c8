// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The functions of OpenHaptics' HD API (3D Systems, libHD.so) that are called, declared anew from
/// public descriptions of its C interface. Sources:
///   [M] ManagedPhantom (MIT) by Kirurobo, HdAPI.cs: signatures and numbers;
///   [Y] pyOpenHaptics (MIT), github.com/mikelitu/pyOpenHaptics, hd.py and hd_define.py: C types
///       and numbers;
///   [S] OpenHaptics4CSharp, github.com/huangmin007/OpenHaptics4CSharp, whose comments give units,
///       the number of values of each parameter, and axes;
///   [C] CHAI3D (BSD), github.com/chai3d/chai3d, CPhantomDevices.cpp and hdPhantom: the order of
///       calls, the columns of the transform, the use of the Cartesian torque;
///   [H] HAPI (GPL), of the H3D API by SenseGraphics, PhantomHapticsDevice.cpp: the unit of the
///       torque.
/// Axes: x to the right, y up, z towards the user [S]; [C] converts them accordingly to its own (x
/// towards the user, y to the right, z up). Lengths are in mm [S] [C], forces in N [S]. Torques are
/// in mN·m: [S] says so where they are read, and [H] multiplies N·m by a thousand ("torque in
/// OpenHaptics is in Nmm"). Contrary sources are [S] where they are set ("Nm"), and [C], which
/// passes N·m on unchanged. This has not been verified on hardware. Functions of a frame are called
/// on the scheduler's thread, between hdBeginFrame and hdEndFrame [Y] [C].
namespace sonde::hd {

using Handle = unsigned;                    // HHD [M] [Y]
using SchedulerHandle = unsigned long;      // [M] [Y]
using Callback = unsigned (*)(void* data);  // [M]

struct ErrorInfo {  // [M] [Y]
  unsigned code;
  int internal;
  Handle device;
};

inline constexpr Handle no_handle = 0xFFFFFFFF;             // [M] [Y]
inline constexpr unsigned callback_continue = 1;            // [M] [Y]
inline constexpr unsigned short highest_priority = 0xFFFF;  // [M] [Y]

// Parameters [M] [Y].
inline constexpr unsigned current_buttons = 0x2000;    // one int, a bit for each
inline constexpr unsigned current_transform = 0x2052;  // 16 doubles by columns, mm [S] [C]
inline constexpr unsigned version = 0x2500;
inline constexpr unsigned model_type = 0x2501;
inline constexpr unsigned serial_number = 0x2504;
inline constexpr unsigned max_workspace = 0x2550;  // least x, y, z, largest x, y, z, mm [S]
inline constexpr unsigned output_dof = 0x2554;     // 3: forces only; 6: torques too [S]
inline constexpr unsigned calibration_style = 0x2555;
inline constexpr unsigned nominal_max_stiffness = 0x2602;  // N/mm, as the maker's examples use it
inline constexpr unsigned nominal_max_force = 0x2603;      // N [S]
inline constexpr unsigned nominal_max_damping = 0x2609;    // N per mm/s, likewise
inline constexpr unsigned current_force = 0x2700;          // N, x right, y up, z to the user [S]
// mN·m, the same axes [Y] [S] [H]. The maker's later headers call it deprecated, in favour of the
// torques of joints and gimbal, which need the arm's kinematics.
inline constexpr unsigned current_torque = 0x2701;
inline constexpr unsigned force_output = 0x4000;  // must be enabled

// Calibration [M] [Y].
inline constexpr unsigned calibration_ok = 0x5000;
inline constexpr unsigned calibration_needs_update = 0x5001;
inline constexpr unsigned calibration_needs_hand = 0x5002;

// Errors [M] [Y].
inline constexpr unsigned success = 0;
inline constexpr unsigned warm_motors = 0x0200;
inline constexpr unsigned exceeded_max_force = 0x0201;
inline constexpr unsigned exceeded_force_impulse = 0x0202;
inline constexpr unsigned exceeded_max_velocity = 0x0203;
inline constexpr unsigned force_error = 0x0204;
inline constexpr unsigned device_fault = 0x0300;
inline constexpr unsigned already_initiated = 0x0301;
inline constexpr unsigned comm_error = 0x0302;
inline constexpr unsigned comm_config_error = 0x0303;
inline constexpr unsigned timer_error = 0x0304;

/// The functions, bound by bind() to a loaded library.
struct Api {
  Handle (*hdInitDevice)(const char* name);        // null: the default device [M] [Y]
  void (*hdDisableDevice)(Handle device);          // [M] [Y]
  void (*hdMakeCurrentDevice)(Handle device);      // [M] [Y] [C]
  void (*hdBeginFrame)(Handle device);             // [M] [Y] [C]
  void (*hdEndFrame)(Handle device);               // [M] [Y] [C]
  void (*hdEnable)(unsigned capability);           // [M] [Y] [C]
  void (*hdDisable)(unsigned capability);          // [M]
  ErrorInfo (*hdGetError)();                       // removes the newest from a stack [M] [Y]
  const char* (*hdGetErrorString)(unsigned code);  // [M]
  void (*hdGetIntegerv)(unsigned parameter, int* values);          // [M] [Y]
  void (*hdGetDoublev)(unsigned parameter, double* values);        // [M] [Y]
  const char* (*hdGetString)(unsigned parameter);                  // [M] [Y]
  void (*hdSetDoublev)(unsigned parameter, const double* values);  // [M] [Y]
  unsigned (*hdCheckCalibration)();                                // [M]
  void (*hdUpdateCalibration)(unsigned style);                     // [M]
  SchedulerHandle (*hdScheduleAsynchronous)(Callback callback, void* data,
                                            unsigned short priority);  // [M] [C]
  void (*hdUnschedule)(SchedulerHandle scheduled);                     // [M]
  void (*hdStartScheduler)();                                          // [M] [Y] [C]
  void (*hdStopScheduler)();                                           // [M] [Y] [C]
};

template <class Library>
void bind(Api& api, const Library& library) {
  library.bind(api.hdInitDevice, "hdInitDevice");
  library.bind(api.hdDisableDevice, "hdDisableDevice");
  library.bind(api.hdMakeCurrentDevice, "hdMakeCurrentDevice");
  library.bind(api.hdBeginFrame, "hdBeginFrame");
  library.bind(api.hdEndFrame, "hdEndFrame");
  library.bind(api.hdEnable, "hdEnable");
  library.bind(api.hdDisable, "hdDisable");
  library.bind(api.hdGetError, "hdGetError");
  library.bind(api.hdGetErrorString, "hdGetErrorString");
  library.bind(api.hdGetIntegerv, "hdGetIntegerv");
  library.bind(api.hdGetDoublev, "hdGetDoublev");
  library.bind(api.hdGetString, "hdGetString");
  library.bind(api.hdSetDoublev, "hdSetDoublev");
  library.bind(api.hdCheckCalibration, "hdCheckCalibration");
  library.bind(api.hdUpdateCalibration, "hdUpdateCalibration");
  library.bind(api.hdScheduleAsynchronous, "hdScheduleAsynchronous");
  library.bind(api.hdUnschedule, "hdUnschedule");
  library.bind(api.hdStartScheduler, "hdStartScheduler");
  library.bind(api.hdStopScheduler, "hdStopScheduler");
}

}  // namespace sonde::hd
