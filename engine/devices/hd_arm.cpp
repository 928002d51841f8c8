// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hd_arm.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;

constexpr auto longest_wait = 5ms;
constexpr auto stands_still = 100ms;  // time without a frame
constexpr double metres_of_mm = 0.001;
constexpr double mN_m = 1000;  // per N·m; hd_api.hpp gives the sources
constexpr int calibrated_every = 100;
constexpr double stiffest = 1e5;     // N/m, above that of any model
constexpr double most_damped = 1e3;  // N·s/m, likewise
constexpr const char* default_device = "Default Device";

std::atomic<bool>& in_use() {
  static std::atomic<bool> used{false};
  return used;
}

/// From the library's axes to ours.
Mat3 hd_to_base() {
  Mat3 R;
  R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return R;
}

/// The library does not report the torque in a documented unit. As in the profiles' source,
/// CHAI3D's CPhantomDevices.cpp: 188 mN·m for the Premium 6DOF, the only family with torque.
double largest_torque(const std::string& model, bool six) {
  return six && model.find("Premium") != std::string::npos ? 0.188 : 0;
}

}  // namespace

const VendorLibraryName& HdLibrary::name() {
  static constexpr const char* files[] = {"libHD.so", "libHD.so.3", "libHD.so.3.4"};
  static constexpr VendorLibraryName name{
      .name = "libHD",
      .maker = "3D Systems",
      .files = files,
      .variable = "SONDE_LIBHD",
      .source = "3D Systems' OpenHaptics for Linux and the Touch device driver (3dsystems.com)"};
  return name;
}

HdLibrary::HdLibrary(const std::filesystem::path& file) {
  hd::bind(api_, VendorLibrary(file));
  version_ = words_or_empty(api_.hdGetString(hd::version));
}

HdArm::HdArm(std::shared_ptr<const HdLibrary> library, const std::string& name)
    : library_(std::move(library)) {
  const hd::Api& api = library_->api();
  const std::string path = "libHD/" + name;
  if (in_use().exchange(true))
    throw InputError::in(path, "this program has an OpenHaptics device open already");
  errors();  // clears old errors
  try {
    device_ = api.hdInitDevice(name == default_device ? nullptr : name.c_str());
    if (device_ == hd::no_handle) check(path, "it does not open");
    check(path, "it does not open");
    api.hdMakeCurrentDevice(device_);
    identify(path);
    api.hdEnable(hd::force_output);
    scheduled_ = api.hdScheduleAsynchronous(&HdArm::called_back, this, hd::highest_priority);
    api.hdStartScheduler();
    last_frame_ = DeviceClock::now();
    check(path, "its scheduler does not start");
  } catch (...) {
    if (device_ != hd::no_handle) {
      api.hdStopScheduler();
      if (scheduled_ != 0) api.hdUnschedule(scheduled_);
      api.hdDisableDevice(device_);
    }
    in_use() = false;
    throw;
  }
}

HdArm::~HdArm() {
  const hd::Api& api = library_->api();
  write({}, false);
  while (heard_.try_acquire()) continue;
  // Waits until a frame without force has been sent: the first frame may still have read the last
  // force.
  for (int frame = 0; frame < 2; ++frame) heard_.try_acquire_for(longest_wait);
  api.hdStopScheduler();
  api.hdUnschedule(scheduled_);
  api.hdDisable(hd::force_output);
  api.hdDisableDevice(device_);
  in_use() = false;
}

void HdArm::check(const std::string& path, const char* what) const {
  const unsigned error = library_->api().hdGetError().code;
  if (error != hd::success) throw InputError::in(path, what + (": " + words_of(error)));
  if (device_ == hd::no_handle) throw InputError::in(path, what);
}

void HdArm::identify(const std::string& path) {
  const hd::Api& api = library_->api();
  if (const std::string version = words_or_empty(api.hdGetString(hd::version));
      !version.empty() && std::atoi(version.c_str()) != 3)
    throw InputError::in(path, "the version of libHD is " + version + "; this program knows 3");
  identity_.name = words_or_empty(api.hdGetString(hd::model_type));
  identity_.serial = words_or_empty(api.hdGetString(hd::serial_number));
  int dof = 3;
  api.hdGetIntegerv(hd::output_dof, &dof);
  six_ = dof == 6;
  api.hdGetIntegerv(hd::calibration_style, &style_);
  double force = 0;
  api.hdGetDoublev(hd::nominal_max_force, &force);
  std::array<double, 6> volume{};  // mm
  api.hdGetDoublev(hd::max_workspace, volume.data());
  check(path, "it does not tell what it can");
  constexpr double strongest = 40;  // N, above that of any model
  if (!(force > 0 && force <= strongest))
    throw InputError::in(path, "its largest force cannot be true: " + std::to_string(force) + " N");
  Vec3 reach = Vec3::Zero(), farthest = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    reach[axis] = metres_of_mm * (volume[i + 3] - volume[i]) / 2;
    farthest[axis] = metres_of_mm * std::max(std::abs(volume[i]), std::abs(volume[i + 3]));
  }
  if (!(farthest.minCoeff() > 0 && farthest.maxCoeff() < 2) || !reach.allFinite())
    throw InputError::in(path, "its working volume cannot be true");
  identity_.farthest = (hd_to_base() * farthest).cwiseAbs();
  identity_.capabilities = {.position = true,
                            .force = true,
                            .buttons = 2,
                            .max_force = force,
                            .max_torque = largest_torque(identity_.name, six_),
                            .max_stiffness = nominal(hd::nominal_max_stiffness, stiffest),
                            .max_damping = nominal(hd::nominal_max_damping, most_damped),
                            .rate_hz = 1000,
                            .reach = (hd_to_base() * reach).cwiseAbs()};
}

/// A figure that older libraries do not have; 0 if this one does not tell it, or one that cannot
/// be true.
double HdArm::nominal(unsigned parameter, double most) const {
  constexpr double per_metre = 1000;  // of N/mm and N per mm/s
  double value = 0;
  library_->api().hdGetDoublev(parameter, &value);
  if (errors() != hd::success) return 0;
  value *= per_metre;
  return value > 0 && value <= most ? value : 0;
}

std::string HdArm::words_of(unsigned error) const {
  switch (error) {
    case hd::warm_motors:
      return "its motors are too warm";
    case hd::exceeded_max_force:
    case hd::exceeded_force_impulse:
      return "the library has cut its force: the limit was exceeded";
    case hd::exceeded_max_velocity:
      return "the library has switched its force off: the velocity limit was exceeded";
    case hd::already_initiated:
      return "another program has it open";
    default:
      return "libHD: " + words_or_empty(library_->api().hdGetErrorString(error));
  }
}

unsigned HdArm::called_back(void* self) noexcept {
  static_cast<HdArm*>(self)->frame();
  return hd::callback_continue;
}

/// Called regularly even without errors, since an arm may lose its reference.
void HdArm::calibrate() noexcept {
  const hd::Api& api = library_->api();
  if (raw_.calibration == hd::calibration_ok && raw_.count % calibrated_every != 0) return;
  raw_.calibration = api.hdCheckCalibration();
  if (raw_.calibration == hd::calibration_needs_update)
    api.hdUpdateCalibration(static_cast<unsigned>(style_));
}

void HdArm::frame() noexcept {
  const hd::Api& api = library_->api();
  calibrate();
  api.hdBeginFrame(device_);
  raw_.time = DeviceClock::now();
  api.hdGetDoublev(hd::current_transform, raw_.transform.data());
  api.hdGetIntegerv(hd::current_buttons, &raw_.buttons);
  wrenches_.update();
  Wanted wanted = wrenches_.front();
  if (!wanted.on || raw_.time - wanted.time > wrench_lasts ||
      raw_.calibration != hd::calibration_ok)
    wanted = {};
  api.hdSetDoublev(hd::current_force, wanted.force.data());
  if (six_) api.hdSetDoublev(hd::current_torque, wanted.torque.data());
  api.hdEndFrame(device_);
  raw_.answered = DeviceClock::now();
  raw_.answers = wanted.sampled;
  unsigned none = hd::success;
  if (const unsigned error = errors(); error != hd::success)
    error_.compare_exchange_strong(none, error);
  ++raw_.count;
  readings_.write(raw_);
  heard_.release();
}

/// Returns the newest error and discards the other ones of the frame, so that they are not
/// attributed to the next frame.
unsigned HdArm::errors() const noexcept {
  constexpr int most = 16;
  const unsigned first = library_->api().hdGetError().code;
  for (int i = 0; first != hd::success && i < most; ++i)
    if (library_->api().hdGetError().code == hd::success) break;
  return first;
}

ArmReading HdArm::read() {
  const bool heard = heard_.try_acquire_for(longest_wait) && readings_.update();
  const auto now = DeviceClock::now();
  if (heard) last_frame_ = now;
  if (now - last_frame_ > stands_still)  // the last force is still on; closing ends it
    return {.kind = ArmReading::Kind::gone, .words = "the scheduler of libHD stands still"};
  if (!heard) return {};
  while (heard_.try_acquire()) continue;
  const Raw& raw = readings_.front();
  const auto fault = [](std::string words) {
    return ArmReading{.kind = ArmReading::Kind::fault, .words = std::move(words)};
  };
  const unsigned error = error_.exchange(hd::success);
  if (error == hd::comm_error || error == hd::comm_config_error || error == hd::device_fault)
    return {.kind = ArmReading::Kind::gone, .words = words_of(error)};
  if (error != hd::success) return fault(words_of(error));
  if (raw.calibration == hd::calibration_needs_hand)
    return fault(
        "it is not calibrated: put its stylus into the inkwell, or its handle where the "
        "maker says");
  if (raw.calibration != hd::calibration_ok) return fault("it is being calibrated");
  Mat3 R;
  Vec3 p;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i < 3; ++i)
      R(static_cast<Eigen::Index>(i), column) = raw.transform[4 * j + i];
    p[column] = metres_of_mm * raw.transform[12 + j];
  }
  const Mat3 S = hd_to_base();
  const std::optional<Quat> q = rotation_of(S * R * S.transpose());
  if (!q) return fault(no_rotation);
  return {.kind = ArmReading::Kind::pose,
          .X_BH = {*q, S * p},
          .buttons = static_cast<std::uint32_t>(raw.buttons),
          .time = raw.time,
          .answered = raw.answered,
          .answers = raw.answers};
}

bool HdArm::write(const DeviceWrench& wrench, bool on) {
  const DeviceWrench most = on ? limited(wrench, identity_.capabilities) : DeviceWrench{};
  const Vec3 force = hd_to_base().transpose() * most.force;
  const Vec3 torque = mN_m * (hd_to_base().transpose() * most.torque);
  wrenches_.write({.force = {force.x(), force.y(), force.z()},
                   .torque = {torque.x(), torque.y(), torque.z()},
                   .on = on,
                   .time = DeviceClock::now(),
                   .sampled = most.sampled});
  return true;
}

}  // namespace sonde
