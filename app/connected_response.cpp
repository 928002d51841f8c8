// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connected_response.hpp"

#include <chrono>
#include <memory>
#include <thread>

#include "app/interrupt.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/study/identification/identified_profile.hpp"
#include "engine/study/identification/measured_hand.hpp"

namespace sonde::app {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 5s;  // a device is looked for about once a second
constexpr auto look = 20ms;

/// Times that a measurement begins, since a busy machine may keep the device's thread waiting for
/// longer than a device may be silent. More than this is a fault of the device, or too busy a
/// machine for a measurement.
constexpr int most_attempts = 3;

/// Waits until the device reports its pose.
void await(InputDevice& device, const std::string& path) {
  for (const auto end = std::chrono::steady_clock::now() + patience;;
       std::this_thread::sleep_for(look)) {
    const DeviceStatus status = device.status();
    if (status.state == DeviceState::ready) {
      if (status.capabilities.force && status.capabilities.position) return;
      throw InputError::in(path, "gives no force or tells no position: nothing to measure by");
    }
    if (interrupt_noted()) throw Cancelled();
    if (std::chrono::steady_clock::now() > end)
      throw InputError::in(path, status.reason.empty() ? "does not answer" : status.reason);
  }
}

/// What the loop needs to run, and no more: two small triangles that never meet.
Pair far_apart() {
  const auto triangle = [] {
    PolygonSoup soup;
    soup.points = {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0.01, 0)};
    soup.polygons = {{0, 1, 2}};
    return make_body(soup, Model::surface, "far apart");
  };
  return {triangle(), triangle()};
}

struct Played {
  PulseProgress end;
  Response response;  ///< whole where the pulses are done
};

Played play(const std::shared_ptr<InputDevice>& device, const PulsePlan& plan,
            const PulseBounds& bounds, const Progress& progress) {
  const Pose away{Quat::Identity(), Vec3(1, 0, 0)};
  MeasuredHand hand(device, plan, bounds, away);
  Servo servo(far_apart(), Method::pdg, Coupling{}, ServoSettings{});
  servo.start(away, hand.hand());
  PulseProgress now;
  do {
    std::this_thread::sleep_for(look);
    now = hand.pulses().progress();
    const double done = now.samples > 0 ? double(now.sample) / double(now.samples) : 0;
    if (interrupt_noted() || !progress(done)) {
      servo.stop();  // the last wrench is zero
      throw Cancelled();
    }
  } while (now.end == PulsesEnd::none);
  servo.stop();
  return {now, hand.pulses().response()};
}

}  // namespace

ConnectedResponse connected_response(const std::string& path, const DeviceProfile& profile,
                                     const PulseLimits& limits, const Progress& progress) {
  note_interrupts();
  const auto device = std::make_shared<InputDevice>(DeviceChoice{.path = path});
  await(*device, path);
  const DeviceProfile limited = with_limits_of(profile, device->status().capabilities);
  const PulsePlan plan = plan_pulses(limited, limits, 1 / ServoSettings{}.rate_hz);
  for (int attempt = 1;; ++attempt) {
    const auto [now, response] = play(device, plan, bounds_of(plan, limits), progress);
    if (now.end == PulsesEnd::done) return {response, limited};
    if (now.end == PulsesEnd::lost && attempt < most_attempts) {
      await(*device, path);
      continue;
    }
    std::string why = now.end == PulsesEnd::withheld ? words(now.withheld) : words(now.end);
    if (now.end == PulsesEnd::lost) why += ", " + std::to_string(attempt) + " times";
    throw InputError::in(path, why);
  }
}

}  // namespace sonde::app
