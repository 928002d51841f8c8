// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/dhd_arm.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;
using dhd::Model;

constexpr auto period = 1ms;
constexpr auto force_pause = 1s;  // after the controller switched its force off
constexpr int status_every = 50;  // readings

std::atomic<int>& open_arms() {
  static std::atomic<int> count{0};
  return count;
}

/// From the library's axes to ours.
Mat3 dhd_to_base() {
  Mat3 R;
  R << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  return R;
}

constexpr double least_force = 8;  // N

struct ModelLimits {
  double force, torque, radius, stiffness;
};
/// From the same source as the profiles in resources/devices: CHAI3D's CDeltaDevices.cpp; lambda.7
/// as its xth-2. An unknown model gets the least force of all, the Falcon's, and no torque.
ModelLimits limits_of(int type) {
  switch (static_cast<Model>(type)) {
    case Model::sigma7_right:
    case Model::sigma7_left:
      return {12, 0.2, 0.09, 4000};
    case Model::lambda7_right:
    case Model::lambda7_left:
      return {12, 0.2, 0.1125, 8000};
    case Model::delta3:
      return {20, 0, 0.15, 5000};
    case Model::falcon:
      return {least_force, 0, 0.04, 3000};
    case Model::omega3:
    case Model::omega6_right:
    case Model::omega6_left:
    case Model::omega7_right:
    case Model::omega7_left:
      return {12, 0, 0.075, 5000};
  }
  return {least_force, 0, 0.075, 0};
}

const char* words_of(dhd::ForceOff cause) {
  switch (cause) {
    case dhd::ForceOff::not_off:
      return "";
    case dhd::ForceOff::button:
      return "its force was switched off by its button";
    case dhd::ForceOff::velocity:
      return "it has switched its force off: its velocity limit was exceeded";
    case dhd::ForceOff::watchdog:
      return "it has switched its force off: nothing came from the program in time";
    case dhd::ForceOff::software:
      return "";  // requested by this program
    case dhd::ForceOff::usb:
      return "it has switched its force off: its cable was unplugged";
    case dhd::ForceOff::dead_man:
      return "it has switched its force off: its handle was let go";
  }
  return "it has switched its force off";
}

}  // namespace

const VendorLibraryName& DhdLibrary::name() {
  static constexpr const char* files[] = {"libdhd.so", "libdhd.so.3", "libdrd.so", "libdrd.so.3"};
  static constexpr VendorLibraryName name{.name = "libdhd",
                                          .maker = "Force Dimension",
                                          .files = files,
                                          .variable = "SONDE_LIBDHD",
                                          .source = "Force Dimension's SDK (forcedimension.com)"};
  return name;
}

DhdLibrary::DhdLibrary(const std::filesystem::path& file) {
  const VendorLibrary library(file);
  dhd::bind(api_, library);
  int major = 0, minor = 0, release = 0, revision = 0;
  api_.dhdGetSDKVersion(&major, &minor, &release, &revision);
  for (const int number : {major, minor, release, revision})
    version_.append(version_.empty() ? "" : ".").append(std::to_string(number));
  if (major != 3 || minor < 3)
    throw InputError::in(file.string(),
                         "its version is " + version_ + "; this program knows 3.3 to below 4");
}

int DhdLibrary::count() const { return std::max(0, api_.dhdGetDeviceCount()); }

DhdArm::DhdArm(std::shared_ptr<const DhdLibrary> library, int index)
    : library_(std::move(library)) {
  const dhd::Api& api = library_->api();
  const std::string path = "libdhd/" + std::to_string(index);
  if (index < 0 || index > 127) throw InputError::in(path, "there is no such device");
  const int id = api.dhdOpenID(static_cast<char>(index));
  if (id < 0 || id > 127)
    throw InputError::in(path,
                         "libdhd cannot open it: " + words_or_empty(api.dhdErrorGetLastStr()));
  id_ = static_cast<char>(id);
  wrist_ = api.dhdHasWrist(id_);
  const ModelLimits limits = limits_of(api.dhdGetSystemType(id_));
  identity_.name = words_or_empty(api.dhdGetSystemName(id_));
  if (unsigned short serial = 0; api.dhdGetSerialNumber(&serial, id_) >= 0)
    identity_.serial = std::to_string(serial);
  identity_.capabilities = {.position = true,
                            .force = true,
                            .buttons = 1,
                            .max_force = limits.force,
                            .max_torque = limits.torque,
                            .max_stiffness = limits.stiffness,
                            .rate_hz = 1000,
                            .reach = Vec3::Constant(limits.radius)};
  // The origin of the axes is not the middle of the volume; twice the radius is still a bound.
  identity_.farthest = Vec3::Constant(2 * limits.radius);
  api.dhdSetGravityCompensation(1, id_);
  next_ = DeviceClock::now();
  ++open_arms();
}

int DhdArm::open() { return open_arms(); }

DhdArm::~DhdArm() {
  write({}, false);
  library_->api().dhdStop(id_);
  library_->api().dhdClose(id_);
  --open_arms();
}

ArmReading DhdArm::read() {
  next_ = std::max(next_ + period, DeviceClock::now() - period);
  std::this_thread::sleep_until(next_);
  if (until_status_-- <= 0) {
    until_status_ = status_every;
    if (ArmReading status = checked_status(); status.kind != ArmReading::Kind::nothing) {
      until_status_ = 0;
      return status;
    }
  }
  return pose();
}

ArmReading DhdArm::pose() const {
  const dhd::Api& api = library_->api();
  Vec3 p = Vec3::Zero();
  double rows[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int result = wrist_
                         ? api.dhdGetPositionAndOrientationFrame(&p.x(), &p.y(), &p.z(), rows, id_)
                         : api.dhdGetPosition(&p.x(), &p.y(), &p.z(), id_);
  if (result < 0) return failure();
  if (result == dhd::timeguard) return {};
  Mat3 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = rows[i][j];
  const Mat3 S = dhd_to_base();
  const std::optional<Quat> q = rotation_of(S * R * S.transpose());
  if (!q) return {.kind = ArmReading::Kind::fault, .words = no_rotation};
  return {
      .kind = ArmReading::Kind::pose, .X_BH = {*q, S * p}, .buttons = api.dhdGetButtonMask(id_)};
}

ArmReading DhdArm::failure() const {
  const int code = library_->api().dhdErrorGetLast();
  const bool gone =
      code == dhd::error_com || code == dhd::error_no_device || code == dhd::error_timeout;
  return {.kind = gone ? ArmReading::Kind::gone : ArmReading::Kind::fault,
          .words = "libdhd: " + words_or_empty(library_->api().dhdErrorGetLastStr())};
}

ArmReading DhdArm::checked_status() {
  std::array<int, 2 * dhd::status_words> word{};  // a later version may write more words
  if (library_->api().dhdGetStatus(word.data(), id_) < 0) return failure();
  const auto fault = [](const char* words) {
    return ArmReading{.kind = ArmReading::Kind::fault, .words = words};
  };
  if (word[dhd::status_connected] == 0)
    return {.kind = ArmReading::Kind::gone, .words = "it was unplugged"};
  if (word[dhd::status_power] == 0) return fault("it has no power");
  if (word[dhd::status_reset] != 0)
    return fault("it is not calibrated: run the maker's HapticInit, or press its reset button");
  if (word[dhd::status_error] != 0) return fault("it reports an error of its own");
  const char* const off = words_of(static_cast<dhd::ForceOff>(word[dhd::status_force_off_cause]));
  if (force_enabled_ && *off != 0) {
    force_enabled_ = false;
    force_again_ = DeviceClock::now() + force_pause;
    return fault(off);
  }
  return {};
}

bool DhdArm::write(const DeviceWrench& wrench, bool on) {
  const dhd::Api& api = library_->api();
  if (on && !force_enabled_) {
    if (DeviceClock::now() < force_again_) return true;
    force_enabled_ = api.dhdEnableForce(1, id_) >= 0;
  }
  const DeviceWrench most = on ? limited(wrench, identity_.capabilities) : DeviceWrench{};
  const Vec3 force = dhd_to_base().transpose() * most.force;
  const Vec3 torque = dhd_to_base().transpose() * most.torque;
  return api.dhdSetForceAndTorque(force.x(), force.y(), force.z(), torque.x(), torque.y(),
                                  torque.z(), id_) >= 0;
}

}  // namespace sonde
