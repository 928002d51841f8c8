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

std::shared_ptr<InputDevice> opened(const std::string& path) {
  auto device = std::make_shared<InputDevice>(DeviceChoice{.path = path});
  for (const auto end = std::chrono::steady_clock::now() + patience;;
       std::this_thread::sleep_for(look)) {
    const DeviceStatus status = device->status();
    if (status.state == DeviceState::ready) {
      if (status.capabilities.force && status.capabilities.position) return device;
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

}  // namespace

ConnectedResponse connected_response(const std::string& path, const DeviceProfile& profile,
                                     const PulseLimits& limits, const Progress& progress) {
  note_interrupts();
  const auto device = opened(path);
  const ServoSettings settings;
  const DeviceProfile limited = with_limits_of(profile, device->status().capabilities);
  const PulsePlan plan = plan_pulses(limited, limits, 1 / settings.rate_hz);
  const Pose away{Quat::Identity(), Vec3(1, 0, 0)};
  MeasuredHand hand(device, plan, bounds_of(plan, limits), away);
  Servo servo(far_apart(), Method::pdg, Coupling{}, settings);
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
  if (now.end == PulsesEnd::done) return {hand.pulses().response(), limited};
  throw InputError::in(path, now.end == PulsesEnd::withheld ? words(now.withheld) : words(now.end));
}

}  // namespace sonde::app
