// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for OpenHaptics' libHD: the same C interface, as far as Sonde calls it, with a
// scheduler of its own at 1 kHz. Written from the same public descriptions
// (engine/devices/hd_api.hpp says which), and none of it from the adapter: parameters and codes are
// numbers here.
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "tests/engine/devices/standins/standin.hpp"

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

using Callback = unsigned (*)(void*);

sonde::test::Standin state;
std::atomic<unsigned> error{0};
std::atomic<bool> running{false}, in_frame{false};
Callback callback = nullptr;
void* callback_data = nullptr;
std::thread scheduler;
std::thread::id scheduler_id;

void run() {
  scheduler_id = std::this_thread::get_id();
  while (running) {
    if (callback && !state.frozen) callback(callback_data);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// An older library does not know these parameters.
void tell_nominal(unsigned parameter, double& value) {
  const double own = parameter == 0x2602 ? state.stiffest : state.most_damped;
  if (own == 0)
    error = 0x0100;  // invalid enum
  else
    value = own;
}

void in_a_frame(const char* words) {
  state.rule(in_frame && std::this_thread::get_id() == scheduler_id, words);
}

}  // namespace

EXPORTED sonde::test::Standin* standin() { return &state; }

struct Error {
  unsigned code;
  int internal;
  unsigned device;
};

EXPORTED unsigned hdInitDevice(const char* name) {
  const bool second = name && std::strcmp(name, "Second") == 0;
  state.rule(!running, "a device was initialised while the scheduler ran");
  if (state.unplugged || (name && !second) || (second && state.arms < 2)) {
    error = state.unplugged ? 0x0302 : 0x0303;  // no answer, no such configuration
    return 0xFFFFFFFF;
  }
  if (state.open > 0) {
    error = 0x0301;  // initiated already
    return 0xFFFFFFFF;
  }
  ++state.open;
  ++state.opened;
  state.which = second ? 1 : 0;
  return second ? 1 : 0;
}
EXPORTED void hdDisableDevice(unsigned device) {
  state.rule(!running, "disabled while the scheduler ran");
  state.rule(static_cast<int>(device) == state.which, "another device was disabled");
  --state.open;
  state.force_on = false;
}
EXPORTED void hdMakeCurrentDevice(unsigned device) {
  state.rule(static_cast<int>(device) == state.which, "another device was made current");
}
EXPORTED void hdBeginFrame(unsigned) {
  state.rule(!in_frame && std::this_thread::get_id() == scheduler_id, "a frame begun elsewhere");
  in_frame = true;
}
EXPORTED void hdEndFrame(unsigned) {
  in_a_frame("a frame ended elsewhere");
  in_frame = false;
  ++state.frames;
  if (const int fault = state.fault.exchange(0); fault != 0) error = static_cast<unsigned>(fault);
  if (state.unplugged) error = 0x0302;  // communication
}
EXPORTED void hdEnable(unsigned capability) {
  state.rule(capability == 0x4000 && state.open > 0, "something else than the force enabled");
  state.force_on = true;
}
EXPORTED void hdDisable(unsigned) { state.force_on = false; }
EXPORTED Error hdGetError() { return {error.exchange(0), 0, 0}; }
EXPORTED const char* hdGetErrorString(unsigned code) {
  return code == 0x0302   ? "communication error"
         : code == 0x0303 ? "no such configuration"
                          : "error";
}
EXPORTED void hdGetIntegerv(unsigned parameter, int* values) {
  if (parameter == 0x2000) {  // buttons
    in_a_frame("buttons asked for outside a frame");
    *values = static_cast<int>(state.buttons.load());
  } else if (parameter == 0x2554) {  // degrees of freedom of the output
    *values = state.model == 6 ? 6 : 3;
  } else if (parameter == 0x2555) {  // style of calibration: inkwell
    *values = 4;
  }
}
EXPORTED void hdGetDoublev(unsigned parameter, double* values) {
  if (parameter == 0x2602 || parameter == 0x2609) return tell_nominal(parameter, *values);
  if (parameter == 0x2603) *values = 3.3;  // N
  if (parameter == 0x2550) {               // mm
    const double volume[6] = {-210, -110, -85, 210, 205, 130};
    std::memcpy(values, volume, sizeof volume);
  }
  if (parameter != 0x2052) return;
  in_a_frame("a pose asked for outside a frame");
  double r[3][3];
  state.rotation(r);
  const double first = state.nan ? std::numeric_limits<double>::quiet_NaN() : state.p[0].load();
  const double columns[16] = {r[0][0], r[1][0], r[2][0], 0, r[0][1], r[1][1],    r[2][1],    0,
                              r[0][2], r[1][2], r[2][2], 0, first,   state.p[1], state.p[2], 1};
  std::memcpy(values, columns, sizeof columns);
}
EXPORTED const char* hdGetString(unsigned parameter) {
  if (parameter == 0x2500) return state.major == 3 ? "3.4.0" : "2.0.0";
  if (parameter == 0x2501) return state.model == 6 ? "Premium 6DOF" : "Touch";
  return state.which == 1 ? "S2" : "S1";
}
EXPORTED void hdSetDoublev(unsigned parameter, const double* values) {
  in_a_frame("a force set outside a frame");
  state.rule(parameter != 0x2701 || state.model == 6, "a torque for a model that takes none");
  for (int i = 0; i < 3; ++i) {
    state.rule(std::isfinite(values[i]), "a wrench that is no number");
    (parameter == 0x2701 ? state.torque : state.force)[i] = values[i];
  }
}
EXPORTED unsigned hdCheckCalibration() { return state.uncalibrated ? 0x5002 : 0x5000; }
EXPORTED void hdUpdateCalibration(unsigned style) { state.rule(style == 4, "another calibration"); }
EXPORTED unsigned long hdScheduleAsynchronous(Callback function, void* data, unsigned short) {
  state.rule(!running, "scheduled while the scheduler ran");
  callback = function;
  callback_data = data;
  return 77;
}
EXPORTED void hdUnschedule(unsigned long scheduled) {
  state.rule(scheduled == 77, "something else was taken off the schedule");
  callback = nullptr;
}
EXPORTED void hdStartScheduler() {
  if (running.exchange(true)) return;
  scheduler = std::thread(run);
}
EXPORTED void hdStopScheduler() {
  if (!running.exchange(false)) return;
  scheduler.join();
}
