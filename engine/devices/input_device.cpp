// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/input_device.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/triple_buffer.hpp"
#include "engine/devices/connection.hpp"
#include "engine/platform/real_time.hpp"
#include "engine/platform/wakeful_processors.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;

constexpr auto search_every = 1s;
constexpr auto force_wait = 2ms;  // period of sending the wrench if no pose arrives
constexpr auto puck_wait = 20ms;  // delay of switching a light, and of ending the thread
constexpr int most_at_once = 64;  // as many as the kernel buffers
constexpr std::size_t longest_report = 4096;

struct WantedWrench {
  DeviceWrench wrench;
  DeviceClock::time_point time{};
  DeviceClock::time_point first{};  ///< of those that answer the same sample
};

bool fits(const DeviceChoice& choice, const HidInfo& info) {
  return (choice.vendor == 0 || choice.vendor == info.vendor) &&
         (choice.product == 0 || choice.product == info.product) &&
         (choice.serial.empty() || choice.serial == info.serial);
}

std::string silence(const DeviceSample& sample) {
  const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(sample.stale_after);
  return "nothing of use heard from it for more than " + std::to_string(limit.count()) + " ms";
}

/// Why there is no device; `path`: where one was asked for.
std::string absence(const std::string& path, bool was_there) {
  if (path.empty()) return "no 6-DoF device is connected that fits";
  return (was_there ? "it is no longer at " : "no 6-DoF device is connected at ") + path;
}

}  // namespace

struct InputDevice::State {
  explicit State(DeviceChoice wanted) : choice(std::move(wanted)), thread([this] { run(); }) {}
  ~State() {
    {
      const std::lock_guard lock(mutex);
      stopping.store(true, std::memory_order_relaxed);
    }
    stop.notify_all();
    thread.join();
  }

  void run();
  std::vector<HidInfo> fitting() const;
  void know_others(const std::vector<HidInfo>& all);
  bool is_chosen(const HidInfo& info, const std::vector<HidInfo>& all) const;
  std::optional<Connection> find();
  void serve(Connection& connection);
  bool hear(Connection& connection, std::chrono::milliseconds wait);
  bool hear(ForceArm& arm);
  bool answer(Connection& connection);
  bool switch_led(Connection& connection);
  void take(Connection& connection, std::span<const std::uint8_t> report);
  void publish(DeviceState state, const std::string& reason);
  void publish_heard();
  void publish_status() { statuses.write(status); }
  void measure(const Connection& connection, const WantedWrench& newest);
  bool should_stop() const { return stopping.load(std::memory_order_relaxed); }
  void rest();

  // Used by the device's thread only.
  DeviceChoice choice;  ///< its path is the node opened last, if one was requested
  /// The nodes and ports of matching devices other than the requested one.
  std::vector<std::string> others, other_ports;
  bool looked = false;
  DeviceSample sample;
  std::array<std::uint8_t, longest_report> buffer{};
  std::string complaint;
  std::string farewell;  ///< why an arm has gone, in its library's words
  bool was_ready = false;
  DeviceStatus status;
  std::optional<bool> led_shown;
  Latency latency;

  WantedWrench wanted;  ///< used by the servo only: the newest
  TripleBuffer<DeviceSample> samples;
  TripleBuffer<WantedWrench> wrenches;
  TripleBuffer<DeviceStatus> statuses;
  std::mutex reading;  ///< guards the status among its readers; the device's thread does not use it
  std::atomic<bool> led_wanted{false};

  // The device's thread takes this lock only to rest: while it serves a force device, it has a
  // higher priority than any thread that could hold the lock.
  std::mutex mutex;
  std::condition_variable stop;
  std::atomic<bool> stopping{false};

  std::thread thread;  // last, since it uses the others
};

/// Waits until the next search for the device.
void InputDevice::State::rest() {
  std::unique_lock lock(mutex);
  stop.wait_for(lock, search_every, [this] { return should_stop(); });
}

void InputDevice::State::publish(DeviceState state, const std::string& reason) {
  const bool ready = state == DeviceState::ready;
  if (ready && !was_ready) ++sample.session;
  was_ready = ready;
  sample.state = state;
  if (!ready) sample.deflection.setZero();
  samples.write(sample);
  status.state = state;
  status.reason = reason;
  publish_status();
}

std::vector<HidInfo> InputDevice::State::fitting() const {
  std::vector<HidInfo> all;
  for (ConnectedDevice& device : connected_devices())
    if (fits(choice, device.info)) all.push_back(std::move(device.info));
  return all;
}

/// Called when the requested device is opened, and before that. Not later: when its loss is
/// noticed, it may already be back under another node.
void InputDevice::State::know_others(const std::vector<HidInfo>& all) {
  others.clear();
  other_ports.clear();
  for (const HidInfo& info : all) {
    if (info.path == choice.path) continue;
    others.push_back(info.path);
    if (!info.port.empty()) other_ports.push_back(info.port);
  }
}

bool InputDevice::State::is_chosen(const HidInfo& info, const std::vector<HidInfo>& all) const {
  if (choice.path.empty()) return true;
  const auto there = [&](std::string HidInfo::*what, const std::string& wanted) {
    return !wanted.empty() && std::ranges::find(all, wanted, what) != all.end();
  };
  // Node numbers are reassigned; if a port is known, it decides.
  const bool by_port = choice.serial.empty() && !choice.port.empty();
  if (by_port && there(&HidInfo::port, choice.port)) return info.port == choice.port;
  if (!by_port && there(&HidInfo::path, choice.path)) return info.path == choice.path;
  const auto known = [&](const std::vector<std::string>& list, const std::string& one) {
    return std::ranges::find(list, one) != list.end();
  };
  return !choice.serial.empty() || !(known(others, info.path) || known(other_ports, info.port));
}

void InputDevice::State::run() {
  name_thread("sonde-device");
  while (!should_stop()) {
    try {
      if (auto connection = find()) serve(*connection);
    } catch (const std::exception& error) {
      publish(DeviceState::refused, error.what());
    }
    rest();
  }
}

std::optional<Connection> InputDevice::State::find() {
  std::string reasons;
  const std::vector<HidInfo> all = fitting();
  if (!std::exchange(looked, true)) know_others(all);
  for (const HidInfo& info : all) {
    if (!is_chosen(info, all)) continue;
    try {
      Connection connection = connect(info);
      if (!choice.path.empty()) {
        choice.path = info.path;
        choice.port = info.port;
      }
      know_others(all);
      const auto* arm = std::get_if<ForceArm>(&connection.driver);
      status.name = arm ? arm->identity().name : name_of(info);
      status.path = info.path;
      status.port = info.port;
      status.capabilities = connection.capabilities();
      status.scheduling = status.wakefulness = "";
      ++status.connections;
      return connection;
    } catch (const InputError& error) {
      reasons.append(reasons.empty() ? "" : "; ").append(error.what());
    }
  }
  if (!reasons.empty())
    publish(DeviceState::refused, reasons);
  else if (sample.state != DeviceState::absent || status.reason.empty())
    publish(DeviceState::absent, absence(choice.path, status.connections > 0));
  return {};
}

void InputDevice::State::serve(Connection& connection) {
  const bool position = connection.capabilities().position;
  sample = DeviceSample{.position = position,
                        .max_force = connection.capabilities().max_force,
                        .max_torque = connection.capabilities().max_torque,
                        .max_stiffness = connection.capabilities().max_stiffness,
                        .max_damping = connection.capabilities().max_damping,
                        .rate_hz = connection.capabilities().rate_hz,
                        .count = sample.count,
                        .session = sample.session};
  complaint.clear();
  led_shown.reset();
  latency.restart();
  status.latency = {};
  // A puck at rest sends nothing; a force device is not ready before it has reported its pose.
  sample.state = position ? DeviceState::silent : DeviceState::ready;
  publish(sample.state, position ? "open, and nothing heard yet" : "");
  const bool in_the_loop = connection.capabilities().force;
  const auto wait = in_the_loop ? force_wait : puck_wait;
  // The search for devices has no known end, and runs with ordinary priority.
  const Promptness prompt(in_the_loop);
  status.scheduling = prompt.words();
  const WakefulProcessors awake(in_the_loop);
  status.wakefulness = awake.words();
  publish_status();
  bool there = true;
  while (there && !should_stop())
    there = switch_led(connection) && hear(connection, wait) && answer(connection);
  if (!there)
    return publish(DeviceState::absent, farewell.empty() ? "it was unplugged, or stopped answering"
                                                         : std::exchange(farewell, ""));
  publish(DeviceState::absent, "closed");
  if (auto* force = std::get_if<ForceDevice>(&connection.driver))
    connection.hid->write(force->wrench_report({}, false));
}

/// Reads all waiting reports, so that the newest counts; returns false if the device is gone.
bool InputDevice::State::hear(Connection& connection, std::chrono::milliseconds wait) {
  if (auto* arm = std::get_if<ForceArm>(&connection.driver)) return hear(*arm);
  for (int i = 0; i < most_at_once; ++i) {
    const auto report = connection.hid->read(buffer, i == 0 ? wait : 0ms);
    if (!report) return false;
    if (report->empty()) break;
    take(connection, *report);
  }
  publish_heard();
  return true;
}

/// Publishes the present state of the sample, with its reason.
void InputDevice::State::publish_heard() {
  const DeviceState now = aged(sample, DeviceClock::now()).state;
  const bool silent = now == DeviceState::silent;
  publish(now, now == DeviceState::ready ? "" : silent ? silence(sample) : complaint);
}

/// The library itself waits for the next pose. Returns false if the arm is gone.
bool InputDevice::State::hear(ForceArm& arm) {
  const std::optional<Heard> heard = arm.hear(sample);
  if (!heard) farewell = arm.complaint();
  if (!heard) return false;
  if (*heard == Heard::refused) {
    ++status.refused;
    complaint = arm.complaint();
  }
  if (*heard != Heard::nothing) ++status.reports;
  publish_heard();
  return true;
}

void InputDevice::State::take(Connection& connection, std::span<const std::uint8_t> report) {
  const auto now = DeviceClock::now();
  const Heard heard = std::visit(
      [&](auto& driver) {
        if constexpr (std::is_same_v<std::decay_t<decltype(driver)>, ForceArm>) {
          return Heard::nothing;  // it sends no reports
        } else {
          const Heard result = driver.accept(report, now, sample);
          if (result == Heard::refused) complaint = driver.complaint();
          return result;
        }
      },
      connection.driver);
  const auto* force = std::get_if<ForceDevice>(&connection.driver);
  ++status.reports;
  if (heard == Heard::refused) ++status.refused;
  if (force) status.lost = force->lost();
  publish_status();
}

/// Sends the wrench; returns false if the device does not accept it.
bool InputDevice::State::answer(Connection& connection) {
  auto* force = std::get_if<ForceDevice>(&connection.driver);
  auto* arm = std::get_if<ForceArm>(&connection.driver);
  if (arm) arm->pace();
  wrenches.update();
  const WantedWrench& newest = wrenches.front();
  const bool fresh = DeviceClock::now() - newest.time < wrench_lasts;
  const bool on = fresh && sample.state == DeviceState::ready;
  if (arm && !arm->write(newest.wrench, on)) return false;
  if (force && !connection.hid->write(force->wrench_report(newest.wrench, on))) return false;
  if (fresh && sample.state == DeviceState::ready) measure(connection, newest);
  return true;
}

void InputDevice::State::measure(const Connection& connection, const WantedWrench& newest) {
  const auto* arm = std::get_if<ForceArm>(&connection.driver);
  const bool force = connection.capabilities().force;
  if (!arm) latency.answered(newest.wrench.sampled, force ? DeviceClock::now() : newest.first);
  const TimeHistogram& times = arm ? arm->latency().times() : latency.times();
  // Computing a quantile takes longer than the rest, so it is not done for each sample.
  constexpr std::uint64_t every = 100;
  if (times.total >= status.latency.samples + every || status.latency.samples < every)
    status.latency = summary_of(times);
}

/// Switches a light only if that was ever requested.
bool InputDevice::State::switch_led(Connection& connection) {
  const auto* mouse = std::get_if<SpaceMouse>(&connection.driver);
  const bool wanted = led_wanted.load(std::memory_order_relaxed);
  if (!mouse || wanted == led_shown.value_or(false)) return true;
  led_shown = wanted;
  const auto report = mouse->led_report(wanted);
  if (!report.empty()) connection.hid->write(report);  // a failing light is no reason to close
  return true;
}

InputDevice::InputDevice(DeviceChoice choice)
    : state_(std::make_unique<State>(std::move(choice))) {}
InputDevice::~InputDevice() = default;

DeviceSample InputDevice::latest(DeviceClock::time_point now) noexcept {
  state_->samples.update();
  return aged(state_->samples.front(), now);
}

void InputDevice::set_wrench(const DeviceWrench& wrench, DeviceClock::time_point now) noexcept {
  WantedWrench& wanted = state_->wanted;
  if (wanted.wrench.sampled != wrench.sampled) wanted.first = now;
  wanted.wrench = wrench;
  wanted.time = now;
  state_->wrenches.write(wanted);
}

DeviceStatus InputDevice::status() const {
  const std::lock_guard lock(state_->reading);
  state_->statuses.update();
  return state_->statuses.front();
}

void InputDevice::set_led(bool on) { state_->led_wanted.store(on, std::memory_order_relaxed); }

}  // namespace sonde
