// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for Force Dimension's libdhd: the same C interface, as far as Sonde calls it. Written
// from the same public descriptions (engine/devices/dhd_api.hpp says which), and none of it from
// the adapter: the enumerations are numbers here.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <thread>

#include "tests/engine/devices/standins/standin.hpp"

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

sonde::test::Standin state;
thread_local int last_error = 0;
std::thread::id owner;  // who opened, and alone may exchange

bool works(char id) {
  state.rule(state.open > 0, "a call before the device was opened");
  state.rule(id == state.which, "a call with another device's number");
  state.rule(std::this_thread::get_id() == owner, "a call from a thread that did not open it");
  if (state.unplugged) last_error = 2;  // DHD_ERROR_COM
  return state.open > 0 && !state.unplugged;
}

int fail(int error) {
  last_error = error;
  return -1;
}

/// Where STANDIN_FREE_MASS (kg) is set, an omega.3 whose handle nobody holds: it moves by the force
/// that it is given, against 2 N·s/m and steps of 2 µm, in real time.
class FreeHandle {
 public:
  FreeHandle() {
    const char* const mass = std::getenv("STANDIN_FREE_MASS");
    if (!mass) return;
    mass_ = std::atof(mass);
    state.model = 33;
  }
  void move() {
    if (mass_ == 0) return;
    const auto now = std::chrono::steady_clock::now();
    const double dt = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    if (dt > 1) return;  // the first time
    const double rate = 2 / mass_, kept = std::exp(-rate * dt);
    for (int i = 0; i < 3; ++i) {
      const double steady = state.force[i] / 2;  // m/s
      x_[i] += steady * dt + (v_[i] - steady) * (1 - kept) / rate;
      v_[i] = steady + (v_[i] - steady) * kept;
      state.p[i] = 2e-6 * std::round(x_[i] / 2e-6);
    }
  }

 private:
  double mass_ = 0;
  double x_[3] = {}, v_[3] = {};
  std::chrono::steady_clock::time_point last_;
} handle;

}  // namespace

EXPORTED sonde::test::Standin* standin() { return &state; }

EXPORTED void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = state.major;
  *minor = state.minor;
  *release = 1;
  *revision = 0;
}
EXPORTED int dhdGetDeviceCount() { return state.unplugged ? 0 : state.arms.load(); }

EXPORTED int dhdOpenID(char index) {
  if (index < 0 || index >= dhdGetDeviceCount()) return fail(5);  // DHD_ERROR_NO_DEVICE_FOUND
  if (state.open > 0) return fail(20);                            // DHD_ERROR_DEVICE_IN_USE
  owner = std::this_thread::get_id();
  state.which = index;
  ++state.open;
  ++state.opened;
  return index;
}
EXPORTED int dhdStop(char id) {
  works(id);
  state.force_on = false;
  return 0;
}
EXPORTED int dhdClose(char id) {
  works(id);
  state.rule(!state.force_on, "closed with its force on");
  --state.open;
  return 0;
}
EXPORTED int dhdGetSystemType(char id) { return works(id) ? state.model.load() : -1; }
EXPORTED const char* dhdGetSystemName(char id) {
  works(id);
  return state.model == 104 ? "sigma.7 right-handed" : "omega.7 right-handed";
}
EXPORTED int dhdGetSerialNumber(unsigned short* number, char id) {
  if (!works(id)) return -1;
  *number = static_cast<unsigned short>(4000 + id);
  return 0;
}
EXPORTED bool dhdHasWrist(char id) { return works(id); }

EXPORTED int dhdGetStatus(int* words, char id) {
  if (!works(id)) return -1;
  std::memset(words, 0, 17 * sizeof(int));
  words[0] = words[1] = words[2] = 1;     // power, connected, started
  words[3] = state.uncalibrated ? 1 : 0;  // reset
  words[5] = state.force_on ? 1 : 0;
  words[10] = state.gravity ? 1 : 0;
  words[14] = state.fault;  // why the force is off
  if (state.fault != 0) state.force_on = false;
  return 0;
}
EXPORTED int dhdEnableForce(unsigned char on, char id) {
  if (!works(id)) return -1;
  if (on != 0) state.fault = 0;
  state.force_on = on != 0;
  return 0;
}
EXPORTED int dhdSetGravityCompensation(int on, char id) {
  if (!works(id)) return -1;
  state.gravity = on != 0;
  return 0;
}
EXPORTED unsigned dhdGetButtonMask(char id) { return works(id) ? state.buttons.load() : 0; }

EXPORTED int dhdGetPosition(double* x, double* y, double* z, char id) {
  if (!works(id)) return -1;
  handle.move();
  *x = state.nan ? std::numeric_limits<double>::quiet_NaN() : state.p[0].load();
  *y = state.p[1];
  *z = state.p[2];
  ++state.frames;
  return state.frozen ? 1 : 0;  // DHD_TIMEGUARD
}
EXPORTED int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double rows[3][3],
                                               char id) {
  const int result = dhdGetPosition(x, y, z, id);
  if (result < 0) return result;
  state.rotation(rows);
  return result;
}
EXPORTED int dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty, double tz,
                                  char id) {
  if (!works(id)) return -1;
  handle.move();  // by the force of before
  const double given[6] = {fx, fy, fz, tx, ty, tz};
  for (int i = 0; i < 3; ++i) {
    state.rule(std::isfinite(given[i]) && std::isfinite(given[3 + i]),
               "a wrench that is no number");
    state.force[i] = given[i];
    state.torque[i] = given[3 + i];
  }
  const bool any = fx != 0 || fy != 0 || fz != 0 || tx != 0 || ty != 0 || tz != 0;
  state.rule(!any || state.force_on || state.fault != 0, "a force before it was enabled");
  state.rule(std::hypot(fx, fy, fz) <= 12.0001, "a force above the model's limit");
  state.rule(std::hypot(tx, ty, tz) <= (state.model == 104 ? 0.20001 : 0), "a torque above it");
  return 0;
}
EXPORTED int dhdErrorGetLast() { return last_error; }
#ifndef STANDIN_WITHOUT_ERRORS
EXPORTED const char* dhdErrorGetLastStr() {
  return last_error == 2    ? "communication error"
         : last_error == 20 ? "device in use"
         : last_error == 5  ? "no device found"
                            : "no error";
}
#endif
