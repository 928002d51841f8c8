// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/device_control.hpp"

#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/haptics/hand/device_traits.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/profile_match.hpp"
#include "engine/study/identification/measured_hand.hpp"
#include "engine/text/output_file.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui {
namespace {

constexpr int keep_after_ms = 400;  // a slider that moves writes no file for each step
constexpr qint64 count_ms = 1000;

}  // namespace

DeviceControl::DeviceControl(std::filesystem::path settings_folder,
                             std::span<const std::filesystem::path> profile_folders)
    : folder_(std::move(settings_folder)) {
  for (const std::string& id : device_profile_ids(profile_folders)) try {
      profiles_.push_back(find_device_profile(id, profile_folders));
    } catch (const InputError&) {
      continue;
    }
  keep_timer_.setSingleShot(true);
  connect(&keep_timer_, &QTimer::timeout, this, &DeviceControl::keep_settings);
  clock_.start();
}

DeviceControl::~DeviceControl() {
  const QSignalBlocker nobody_to_tell(this);  // a window that closes asks nothing
  if (keep_timer_.isActive()) keep_settings();
}

bool DeviceControl::mouse_leads() const {
  return std::holds_alternative<MouseSource>(source_) ||
         std::holds_alternative<SimulatedSource>(source_);
}

void DeviceControl::choose(const InputSource& source) {
  chosen_ = true;
  take(source);
}

void DeviceControl::attach(Session* session) {
  session_ = session;
  if (!session_) return;
  const LoadedScene& opened = session_->loaded();
  of_scene_ = opened.servo;
  const auto* path = std::get_if<PathSource>(&source_);
  const bool without_path = path && path->file.empty() && opened.trajectory.empty();
  if (without_path)
    emit failed(QStringLiteral("This scene has no recorded path: the mouse holds the probe."));
  if (!chosen_ && opened.device)
    take(SimulatedSource{*opened.device});
  else if (!chosen_ || without_path)
    take(MouseSource{});
  else
    take(InputSource(source_));
}

void DeviceControl::take(const InputSource& source) {
  if (keep_timer_.isActive()) keep_settings();
  const bool stays = same(source, source_) && input_;
  source_ = source;
  const auto* connected = std::get_if<ConnectedSource>(&source_);
  if (!connected) input_.reset();
  if (connected && !stays) {
    input_ = std::make_shared<InputDevice>(connected->choice);
    counted_ = 0;
    reports_per_s_ = 0;
  }
  load_settings();
  hold();
  emit changed();
}

/// Once it is open, a device tells its name. Until then that of its listing counts.
void DeviceControl::find_profile() {
  const auto* connected = std::get_if<ConnectedSource>(&source_);
  if (!input_ || !connected) return;
  std::string name = input_->status().name;
  if (name.empty()) name = connected->name;
  if (named_ == name) return;
  named_ = std::move(name);
  const DeviceProfile* found = profile_of(*named_, profiles_);
  profile_ = found ? std::optional(*found) : std::nullopt;
  if (!found) return session_->set_device_profile({});
  DeviceTraits traits = traits_of(simulated(*found));
  traits.known = !found->damping.assumed;
  session_->set_device_profile(traits);
}

/// Hands the probe of the session over.
void DeviceControl::hold() {
  measuring_ = false;
  named_.reset();
  profile_.reset();
  if (!session_) return;
  run_as_wanted();
  if (input_) {
    session_->hold_by(input_, settings_);
    return find_profile();
  }
  if (const auto* path = std::get_if<PathSource>(&source_)) return follow_path(*path);
  const auto* simulating = std::get_if<SimulatedSource>(&source_);
  if (!simulating) return session_->hold_by_mouse();
  try {
    session_->hold_by(held(simulated(simulating->profile), grip_), settings_.scaling);
  } catch (const std::invalid_argument& why) {
    source_ = MouseSource{};
    session_->hold_by_mouse();
    emit failed(QString::fromUtf8(why.what()));
  }
}

void DeviceControl::follow_path(const PathSource& path) {
  session_->replay(path.file.empty() ? session_->loaded().trajectory : *path.path);
}

/// A simulated device is made for one rate: one that cannot run at it is let go of.
void DeviceControl::pace_simulated() {
  if (session_) try {
      session_->pace_simulated();
    } catch (const std::invalid_argument&) {
      hold();
    }
}

ServoSettings DeviceControl::servo() const {
  ServoSettings servo = of_scene_;
  servo.rate_hz = settings_.rate_hz.value_or(servo.rate_hz);
  servo.passivity.control = settings_.passivity_control.value_or(servo.passivity.control);
  return servo;
}

void DeviceControl::run_as_wanted() {
  const ServoSettings wanted = servo();
  session_->set_rate(wanted.rate_hz);
  session_->set_passivity_control(wanted.passivity.control);
}

std::filesystem::path DeviceControl::settings_file() const {
  const std::string name = settings_name_of(source_);
  return name.empty() ? std::filesystem::path() : folder_ / name;
}

/// Of a device without a serial number; empty for all others.
std::filesystem::path DeviceControl::model_settings_file() const {
  const std::string name = model_settings_name_of(source_);
  return name.empty() ? std::filesystem::path() : folder_ / name;
}

/// The scene's, where it sets any; else those kept, for the device or else for its model; else the
/// usual ones.
void DeviceControl::load_settings() {
  settings_ = usual_settings(source_);
  damaged_.clear();
  from_scene_ = session_ && session_->loaded().device_settings;
  if (from_scene_) {
    settings_ = *session_->loaded().device_settings;
    return;
  }
  std::filesystem::path file = settings_file();
  std::error_code none;
  if (!file.empty() && !std::filesystem::exists(file, none)) file = model_settings_file();
  if (file.empty() || !std::filesystem::exists(file, none)) return;
  try {
    settings_ = read_device_settings(file);
  } catch (const InputError& bad) {
    damaged_ = file;
    emit failed(QString::fromUtf8(bad.what()));
  }
}

void DeviceControl::set_settings(const DeviceSettings& settings) {
  const double rate_before = servo().rate_hz;
  settings_ = settings;
  if (session_) {
    session_->set_device_settings(settings_);
    run_as_wanted();
  }
  if (servo().rate_hz != rate_before) pace_simulated();
  if (!from_scene_ && !settings_file().empty()) keep_timer_.start(keep_after_ms);
  emit changed();
}

void DeviceControl::keep_settings() {
  keep_timer_.stop();
  if (settings_file().empty()) return;  // what had them has gone
  try {
    std::filesystem::create_directories(folder_);
    // Somebody's own work with a slip in it: put aside, not lost.
    if (const auto damaged = std::exchange(damaged_, {}); !damaged.empty())
      std::filesystem::rename(damaged, damaged.string() + ".bad");
    write_whole(settings_file(), device_settings_text(settings_));
    // The next of the model, or the same in another port, begins with them.
    if (const auto model = model_settings_file(); !model.empty())
      write_whole(model, device_settings_text(settings_));
  } catch (const std::exception& why) {
    // Once: the next change of a slider would say the same.
    if (!std::exchange(keeping_failed_, true)) emit failed(QString::fromUtf8(why.what()));
  }
}

void DeviceControl::set_grip(const SimulatedGrip& grip) {
  grip_ = grip;
  keep_grip(grip_);
  const auto* simulating = std::get_if<SimulatedSource>(&source_);
  if (session_ && simulating) try {
      session_->set_simulated(held(simulated(simulating->profile), grip_));
    } catch (const std::invalid_argument&) {
      hold();  // says why
    }
  emit changed();
}

void DeviceControl::set_led(bool on) {
  if (input_) input_->set_led(on);
}

void DeviceControl::frame(const Quat& q_FV) {
  if (!session_) return;
  const std::string before = model();
  find_profile();
  if (model() != before) emit changed();
  session_->set_view(q_FV);
  session_->sweep();
}

std::vector<InputSource> DeviceControl::choices() const {
  std::vector<InputSource> all{MouseSource{}};
  if (session_ && !session_->loaded().trajectory.empty()) all.emplace_back(PathSource{});
  for (const DeviceProfile& profile : profiles_) all.emplace_back(SimulatedSource{profile});
  for (const ConnectedDevice& device : watch_.connected()) all.emplace_back(source_of(device.info));
  if (std::ranges::none_of(all, [this](const InputSource& h) { return same(h, source_); }))
    all.push_back(source_);
  return all;
}

SourceReport DeviceControl::report() {
  SourceReport report;
  if (input_) report.device = input_->status();
  report.profile = profile_;
  // Plugged in again it may have another node.
  if (auto* connected = std::get_if<ConnectedSource>(&source_))
    if (!report.device.path.empty()) {
      connected->choice.path = report.device.path;
      connected->choice.port = report.device.port;
    }
  const qint64 since = clock_.elapsed() - counted_at_;
  if (since >= count_ms) {
    reports_per_s_ = double(report.device.reports - counted_) * 1000 / double(since);
    counted_ = report.device.reports;
    counted_at_ += since;
  }
  report.reports_per_s = reports_per_s_;
  report.clutch_open = session_ && session_->clutch_open();
  report.measurable = measurable();
  return report;
}

void DeviceControl::add_profile(const DeviceProfile& profile) {
  std::erase_if(profiles_, [&](const DeviceProfile& each) { return each.id == profile.id; });
  profiles_.push_back(profile);
  named_.reset();  // it may be of what is connected
}

bool DeviceControl::measurable() const {
  if (!session_) return false;
  if (std::holds_alternative<SimulatedSource>(source_)) return true;
  if (!input_) return false;
  const DeviceStatus device = input_->status();
  return device.state == DeviceState::ready && device.capabilities.force &&
         device.capabilities.position;
}

std::shared_ptr<MeasuredHand> DeviceControl::begin_measuring(const PulsePlan& plan,
                                                             const PulseBounds& bounds) {
  if (!measurable()) return nullptr;
  const Snapshot* now = session_->latest();
  const Pose X_FM = now ? now->separation.device : session_->device_pose();
  const auto* simulating = std::get_if<SimulatedSource>(&source_);
  auto measured = simulating ? std::make_shared<MeasuredHand>(simulated(simulating->profile), plan,
                                                              bounds, X_FM)
                             : std::make_shared<MeasuredHand>(input_, plan, bounds, X_FM);
  session_->hold_by(std::shared_ptr<const Hand>(measured, &measured->hand()));
  measuring_ = true;
  return measured;
}

void DeviceControl::end_measuring() {
  if (!measuring_) return;
  hold();
  emit changed();
}

}  // namespace sonde::ui
