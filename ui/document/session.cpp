// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.hpp"

#include <chrono>
#include <thread>
#include <utility>
#include <variant>

#include "engine/calibration/calibration_file.hpp"
#include "engine/devices/device_hand.hpp"
#include "engine/haptics/hand/direct_hand.hpp"
#include "engine/haptics/hand/simulated_hand.hpp"
#include "engine/scene/path_hand.hpp"
#include "engine/study/trade/tick_budget.hpp"

namespace sonde::ui {

namespace {

/// One that somebody else made.
class OtherHand {
 public:
  explicit OtherHand(std::shared_ptr<const Hand> made) : made_(std::move(made)) {}
  Hand hand() const { return *made_; }

 private:
  std::shared_ptr<const Hand> made_;
};

}  // namespace

/// A hand with what it is made of.
struct Session::Holding {
  template <class Kind, class... Arguments>
  explicit Holding(std::in_place_type_t<Kind> kind, Arguments&&... arguments)
      : by(kind, std::forward<Arguments>(arguments)...), hand(std::get<Kind>(by).hand()) {}

  DirectHand* direct() { return std::get_if<DirectHand>(&by); }
  SimulatedHand* simulated() { return std::get_if<SimulatedHand>(&by); }
  DeviceHand* device() { return std::get_if<DeviceHand>(&by); }

  std::variant<DirectHand, SimulatedHand, DeviceHand, PathHand, OtherHand> by;
  Hand hand;
};

namespace {

/// A pointer to the hand that owns all of it.
template <class Holding>
std::shared_ptr<const Hand> hand_of(const std::shared_ptr<Holding>& holding) {
  return {holding, &holding->hand};
}

/// The scene's, with the time that its wanted accuracy takes.
ServoSettings with_budget(ServoSettings servo, const Pair& pair) {
  if (servo.accuracy > 0)
    servo.budget = tick_budget(servo, pair, Method::pdg, default_calibration());
  return servo;
}

}  // namespace

Session::Session(LoadedScene loaded)
    : loaded_(std::move(loaded)),
      target_(loaded_.here.value_or(loaded_.start)),
      coupling_(loaded_.coupling),
      searched_(loaded_.pair),
      gauge_(loaded_.pair),
      holding_(std::make_shared<Holding>(std::in_place_type<DirectHand>, target_)),
      hands_(hand_of(holding_)),
      servo_(loaded_.pair, Method::pdg, coupling_, with_budget(loaded_.servo, loaded_.pair)) {
  servo_.start(target_, hands_.hand());
}

Session::~Session() = default;

Pose Session::probe_pose() {
  const Snapshot* now = latest();  // none while it is placed: where it will be counts then
  return now ? now->separation.device : target_;
}

void Session::hold(std::shared_ptr<Holding> holding) {
  holding_ = std::move(holding);
  hands_.set(hand_of(holding_));
}

void Session::hold_by_mouse() {
  target_ = probe_pose();
  hold(std::make_shared<Holding>(std::in_place_type<DirectHand>, target_));
}

void Session::hold_by(const SimulatedDeviceParameters& device, double scaling) {
  target_ = probe_pose();
  hold(std::make_shared<Holding>(std::in_place_type<SimulatedHand>, device,
                                 1 / loaded_.servo.rate_hz, scaling, probe().mass.com, target_));
}

void Session::hold_by(std::shared_ptr<InputDevice> device, const DeviceSettings& settings) {
  const auto holding = std::make_shared<Holding>(std::in_place_type<DeviceHand>, std::move(device),
                                                 settings, probe().mass.com, probe_pose());
  holding->hand = awaited(std::move(holding->hand), others_, probe_pose());
  hold(holding);
  holding_->device()->set_view(q_FV_);
}

void Session::hold_by(std::shared_ptr<const Hand> hand) {
  hold(std::make_shared<Holding>(std::in_place_type<OtherHand>, std::move(hand)));
}

void Session::replay(std::vector<TimedPose> path) {
  path_ = std::move(path);
  hold(std::make_shared<Holding>(std::in_place_type<PathHand>, path_, probe_pose()));
}

void Session::set_rate(double rate_hz) {
  loaded_.servo.rate_hz = rate_hz;
  servo_.set_rate(rate_hz);
}

void Session::pace_simulated() {
  if (SimulatedHand* simulated = holding_->simulated())
    simulated->set_period(1 / loaded_.servo.rate_hz);
}

void Session::set_simulated(const SimulatedDeviceParameters& device) {
  if (SimulatedHand* simulated = holding_->simulated())
    simulated->set_parameters(device, 1 / loaded_.servo.rate_hz);
}

void Session::set_passivity_control(bool on) {
  loaded_.servo.passivity.control = on;
  servo_.set_passivity_control(on);
}

void Session::set_knob(const ServoSettings& servo) {
  loaded_.servo.budget.microseconds = servo.budget.microseconds;
  loaded_.servo.accuracy = servo.accuracy;
  servo_.set_budget_us(with_budget(loaded_.servo, loaded_.pair).budget.microseconds);
}

void Session::set_device_settings(const DeviceSettings& settings) {
  if (DeviceHand* device = holding_->device()) device->set_settings(settings);
  if (SimulatedHand* simulated = holding_->simulated()) simulated->set_scaling(settings.scaling);
}

void Session::set_device_profile(const std::optional<DeviceTraits>& at_handle) {
  if (DeviceHand* device = holding_->device()) device->set_profile(at_handle);
}

void Session::set_view(const Quat& q_FV) {
  if (q_FV_.coeffs() == q_FV.coeffs()) return;
  q_FV_ = q_FV;
  if (DeviceHand* device = holding_->device()) device->set_view(q_FV);
}

bool Session::clutch_open() const {
  const DeviceHand* device = holding_->device();
  return device && device->clutch_open();
}

Pose Session::device_pose() {
  return holding_->direct() || holding_->simulated() ? target_ : probe_pose();
}

void Session::set_device_pose(const Pose& X_FM) {
  target_ = X_FM;
  if (DirectHand* direct = holding_->direct()) direct->set_target(X_FM);
  if (SimulatedHand* simulated = holding_->simulated()) simulated->set_target(X_FM);
}

void Session::set_coupling(const Coupling& coupling) {
  coupling_ = coupling;
  if (!placing()) servo_.set_coupling(coupling);
}

void Session::set_force(bool on) {
  force_on_ = on;
  servo_.set_force(on);
}

void Session::set_paused(bool paused) {
  paused_ = paused;
  hands_.set_paused(paused);
  servo_.set_paused(paused);
}

void Session::place(const Pose& X_FM) {
  set_device_pose(X_FM);
  set_paused(false);
  if (placing())
    wanted_ = X_FM;
  else
    begin(X_FM);
}

/// In another thread: a search may come first, and before that the force of a pressed hand on a
/// device falls gradually.
void Session::begin(const Pose& X_FM) {
  const bool may_be_pressed = holding_->device() || std::holds_alternative<OtherHand>(holding_->by);
  if (!may_be_pressed) servo_.stop();
  if (std::holds_alternative<PathHand>(holding_->by))
    hold(std::make_shared<Holding>(std::in_place_type<PathHand>, path_, X_FM));
  begun_ = false;
  beginning_ =
      std::async(std::launch::async, [this, X_FM, holding = holding_, hand = hands_.hand()] {
        servo_.stop();
        begun_ = true;
        if (SimulatedHand* simulated = holding->simulated()) simulated->place(X_FM);
        if (DeviceHand* device = holding->device()) device->place(X_FM);
        servo_.start(X_FM, hand);
      });
}

bool Session::placing() {
  if (!beginning_.valid()) return false;
  if (beginning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return true;
  beginning_.get();
  if (const auto next = std::exchange(wanted_, std::nullopt)) {
    begin(*next);
    return true;
  }
  servo_.set_coupling(coupling_);
  return false;
}

std::optional<GaugedClearance> Session::clearance(const Pose& X_FM) {
  // A picture comes every 16 ms: most pairs have answered by then, and the picture is all of one
  // instant. Others follow a picture later.
  constexpr std::chrono::milliseconds patience(4);
  return gauge_.at(X_FM, patience);
}

void Session::let_go() {
  wanted_.reset();
  if (!placing()) return;  // end() lets the force fall
  set_force(false);
  hold_by_mouse();
  while (!begun_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  *ended_ = true;  // it may search for long, and then begins with the mouse
}

void Session::end() {
  if (beginning_.valid()) beginning_.wait();
  servo_.stop();
  *ended_ = true;
}

}  // namespace sonde::ui
