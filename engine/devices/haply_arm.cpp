// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/haply_arm.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <thread>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;

constexpr auto exchange_every = 1ms;
constexpr auto answer_wait = 2ms;
// Ten periods; with the servo's own limit of 20 ms for a sample, the force ends within that.
constexpr auto silent_after = 10ms;
constexpr auto gone_after = 100ms;
constexpr auto opening = 300ms;
// Status and configuration come only when asked for: five times a second.
constexpr int everything_every = 200;
// Messages that do not mention the arm, before it counts as unplugged: the service takes some time
// to list an arm again that it has started anew.
constexpr int without_limit = 100;
/// The arms that this program has open, with the grip that each follows: two that tell one of them
/// forces would be felt as one that shakes, and two that follow one grip turn with the wrong hand.
class OpenArms {
 public:
  /// False if it is open already.
  bool add(const std::string& id) {
    const std::lock_guard lock(mutex_);
    return grips_.try_emplace(id).second;
  }
  void remove(const std::string& id) {
    const std::lock_guard lock(mutex_);
    grips_.erase(id);
  }
  int count() {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(grips_.size());
  }
  /// From now on that arm follows the first of these that is awake and that no other follows, or,
  /// if all sleep and `asleep` allows it, the first; null if there is none.
  const haply::Grip* follow(const std::string& arm, const std::vector<haply::Grip>& grips,
                            bool asleep) {
    const std::lock_guard lock(mutex_);
    const haply::Grip* next = nullptr;
    for (const haply::Grip& grip : grips) {
      const bool awake = grip.ready.value_or(false);
      if (next && !awake) continue;
      if (!(awake || asleep) || others_follow(arm, grip.id)) continue;
      next = &grip;
      if (awake) break;
    }
    if (next) grips_[arm] = next->id;
    return next;
  }

 private:
  bool others_follow(const std::string& arm, const std::string& grip) const {
    return std::ranges::any_of(
        grips_, [&](const auto& open) { return open.first != arm && open.second == grip; });
  }

  std::mutex mutex_;
  std::map<std::string, std::string> grips_;  ///< by the arm's id
};
OpenArms& open_haply_arms() {
  static OpenArms arms;
  return arms;
}

int service_port() {
  constexpr int usual = 10001;
  const char* const text = std::getenv("SONDE_HAPLY_PORT");
  if (!text || !*text) return usual;
  int port = -1;
  const char* const end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, port);
  if (error != std::errc() || rest != end || port < 0 || port > 65535)
    throw InputError(std::string("the environment variable SONDE_HAPLY_PORT is no port: ") + text);
  return port;
}

/// The service's first message, which lists everything that is connected.
haply::Message inventory(LocalSocket& socket, DeviceClock::time_point until,
                         const std::string& address) {
  const auto text = socket.receive(until);
  if (!text) throw InputError::in(address, "it does not say what is connected");
  const auto message = haply::decode(*text);
  if (!message) throw InputError::in(address, "what answers there is not Haply's service");
  return *message;
}

struct HaplyLimits {
  const char* model;
  double force;   // N
  double radius;  // m
};

/// The working volumes are those that the maker's tutorial "Combined" keeps to. The only public
/// figure of a largest force that was found is the limit of the ROS 2 driver haply_ros2_interface
/// (Óbuda University) for the Inverse3; for others, what no model should exceed.
HaplyLimits haply_limits_of(const std::string& model) {
  static constexpr HaplyLimits known[] = {
      {"inverse3", 10, 0.10}, {"inverse3x", 10, 0.10}, {"minverse", 3, 0.04}};
  const auto* const found = std::ranges::find(known, model, &HaplyLimits::model);
  return found == std::end(known) ? HaplyLimits{"", 3, 0.10} : *found;
}

ArmIdentity haply_identity_of(const haply::Arm& arm, bool grip) {
  constexpr unsigned buttons_of_a_grip = 3;
  const std::string model = arm.model.value_or("of no told model");
  const HaplyLimits limits = haply_limits_of(model);
  ArmIdentity identity;
  identity.name = "Haply " + (model == "inverse3"    ? "Inverse3"
                              : model == "inverse3x" ? "Inverse3x"
                              : model == "minverse"  ? "Minverse"
                                                     : "arm (" + model + ")");
  if (!grip) identity.name += " without a VerseGrip";
  identity.serial = "haply-" + arm.id;
  identity.capabilities = {.position = true,
                           .force = true,
                           .buttons = buttons_of_a_grip,  // a grip may come later
                           .max_force = limits.force,
                           .rate_hz = 1000,
                           .reach = Vec3::Constant(limits.radius)};
  return identity;  // the base lies at the edge of the volume: half a metre is a bound for all
}

}  // namespace

HaplyService find_haply_service() {
  HaplyService service;
  try {
    const int port = service_port();
    service.address = LocalSocket::address(static_cast<std::uint16_t>(port));
    if (port == 0) throw InputError("SONDE_HAPLY_PORT is 0: it is not looked for");
    const auto until = DeviceClock::now() + opening;
    LocalSocket socket(static_cast<std::uint16_t>(port), opening);
    service.arms = inventory(socket, until, service.address).arms;
    service.answers = true;
  } catch (const std::exception& error) {  // out of sockets: no reason to end the program
    service.reason = error.what();
  }
  return service;
}

int HaplyArm::open() { return open_haply_arms().count(); }

HaplyArm::HaplyArm(const std::string& id) : id_(id) {
  const std::string path = "haply/" + id;
  if (!open_haply_arms().add(id)) throw InputError::in(path, "this program has it open already");
  try {
    const auto port = static_cast<std::uint16_t>(service_port());
    socket_ = std::make_unique<LocalSocket>(port, opening);
    const haply::Message all =
        inventory(*socket_, DeviceClock::now() + opening, LocalSocket::address(port));
    const auto found = std::ranges::find(all.arms, id, &haply::Arm::id);
    if (found == all.arms.end()) throw InputError("the service knows no arm of this id");
    arm_ = *found;
    take(all, *found);
    identity_ = haply_identity_of(arm_, !grip_.id.empty());
  } catch (const std::exception& error) {
    open_haply_arms().remove(id);
    throw InputError::in(path, error.what());
  }
  next_ = heard_ = caught_up_ = DeviceClock::now();
}

HaplyArm::~HaplyArm() {
  try {
    // The force's end is on its way before the connection ends. Where no force was told, nothing is
    // said: another program may hold the arm.
    socket_->flush(DeviceClock::now() + silent_after);
    if (pushed_) send({});
    // A socket that closes with something unread may take back what it sent (Linux keeps it).
    const auto until = DeviceClock::now() + gone_after;
    while (pushed_ && unanswered_ > 0 && socket_->receive(until)) --unanswered_;
  } catch (const std::exception&) {
    // The connection ends all the same.
  }
  open_haply_arms().remove(id_);
}

bool HaplyArm::write(const DeviceWrench& wrench, bool on) {
  wanted_ = on ? limited(wrench, identity_.capabilities) : DeviceWrench{};
  if (unanswered_ > 0) return true;
  pace();
  return send(wanted_);
}

void HaplyArm::pace() const {
  if (unanswered_ == 0) std::this_thread::sleep_until(next_);
}

bool HaplyArm::send(const DeviceWrench& wrench) {
  const bool everything = until_everything_-- <= 0;
  if (everything) until_everything_ = everything_every;
  const bool basis = everything && arm_.basis && *arm_.basis != "XYZ";
  if (!socket_->send(haply::encode(
          id_, {.force = wrench.force, .ask_everything = everything, .set_basis = basis})))
    return false;
  answers_ = wrench.sampled;
  sent_ = DeviceClock::now();
  if (unanswered_ == 0) asked_ = sent_;
  next_ = std::clamp(next_ + exchange_every, sent_, sent_ + exchange_every);
  pushed_ = pushed_ || !wrench.force.isZero(0);
  ++unanswered_;
  return true;
}

ArmReading HaplyArm::read() {
  pace();
  if (unanswered_ == 0 && !send(wanted_)) return gone("it does not take what it is told");
  std::optional<std::string> newest = socket_->receive(DeviceClock::now() + answer_wait);
  if (!newest) return silent();
  for (--unanswered_; unanswered_ >= 0; --unanswered_) {
    std::optional<std::string> later = socket_->receive(DeviceClock::now());
    if (!later) return heard(*newest);
    newest = std::move(later);
  }
  return gone("it sends messages that nobody asked for");
}

/// A service owes an answer only to what it was told: a thread that was held up asks later.
DeviceClock::time_point HaplyArm::waits_since() const { return std::max(heard_, asked_); }

/// No answer: without one for too long, the force is to end there too.
ArmReading HaplyArm::silent() {
  if (!socket_->ended().empty()) return gone(socket_->ended());
  const auto now = DeviceClock::now();
  const auto silence = now - waits_since();
  if (silence < silent_after) return {};
  if (silence > gone_after) return gone("it has not answered for 0.1 s");
  if (now - sent_ >= silent_after && !send({}))
    return gone("it neither answers nor takes what it is told");
  return {.kind = ArmReading::Kind::fault, .words = "Haply's service does not answer"};
}

ArmReading HaplyArm::gone(const std::string& words) const {
  return {.kind = ArmReading::Kind::gone, .words = "Haply's service: " + words};
}

ArmReading HaplyArm::heard(const std::string& text) {
  const auto now = DeviceClock::now();
  // One that comes late says where the handle was, and that the force has been held. With others
  // still to come, it answers an earlier message.
  const bool late = now - waits_since() >= silent_after || unanswered_ > 0;
  round_trip_ = now - sent_;
  heard_ = now;
  if (unanswered_ == 0) caught_up_ = now;
  if (now - caught_up_ > gone_after) return gone("it leaves messages without an answer");
  const auto fault_by = [](const std::string& words) {
    return ArmReading{.kind = ArmReading::Kind::fault, .words = words};
  };
  const std::optional<haply::Message> message = haply::decode(text);
  if (!message) return fault_by("Haply's service sent a message that is none of its own");
  const auto found = std::ranges::find(message->arms, id_, &haply::Arm::id);
  if (found == message->arms.end() || !found->position) {
    if (++without_ > without_limit) return gone("it no longer knows the arm");
    return fault_by("Haply's service says nothing of the arm");
  }
  without_ = 0;
  take(*message, *found);
  if (const std::string words = fault(); !words.empty()) return fault_by(words);
  if (late) return fault_by("Haply's service answers late");
  return {.kind = ArmReading::Kind::pose,
          .X_BH = {grip_.orientation.value_or(Quat::Identity()), *arm_.position},
          .buttons = grip_.buttons,
          .time = now,
          .answered = now,
          .answers = answers_};
}

void HaplyArm::take(const haply::Message& message, const haply::Arm& arm) {
  const auto renew = [](auto& known, const auto& said) {
    if (said) known = said;
  };
  renew(arm_.position, arm.position);
  renew(arm_.calibrated, arm.calibrated);
  renew(arm_.powered, arm.powered);
  renew(arm_.basis, arm.basis);
  renew(arm_.mount_scaled, arm.mount_scaled);
  renew(arm_.place_scaled, arm.place_scaled);
  if (choose_grip(message.grips)) return;
  const auto grip = std::ranges::find(message.grips, grip_.id, &haply::Grip::id);
  grip_.orientation = grip == message.grips.end() ? std::nullopt : grip->orientation;
  if (grip == message.grips.end()) return;
  renew(grip_.ready, grip->ready);
  grip_.buttons = grip->buttons;
}

/// Follows another grip where there was none, or where the one that is followed is no longer
/// mentioned, or sleeps beside one that is awake; not one that another arm of this program follows.
/// Returns true if so: the handle seems to turn by a jump then, so this message gives no pose, and
/// the force rises anew.
bool HaplyArm::choose_grip(const std::vector<haply::Grip>& grips) {
  const auto own = std::ranges::find(grips, grip_.id, &haply::Grip::id);
  without_grip_ = own == grips.end() ? without_grip_ + 1 : 0;
  const bool sleeps = own != grips.end() && !own->ready.value_or(true);
  const bool gone = grip_.id.empty() || without_grip_ > without_limit;
  if (grips.empty() || !(gone || sleeps)) return false;
  const haply::Grip* const next = open_haply_arms().follow(id_, grips, gone);
  if (!next) return false;
  grip_ = {.id = next->id, .orientation = {}, .ready = next->ready, .buttons = 0};
  without_grip_ = 0;
  return true;
}

/// Why the newest pose cannot be used; empty if it can.
std::string HaplyArm::fault() const {
  if (!arm_.powered.value_or(true)) return "it has no power";
  if (!arm_.calibrated.value_or(true))
    return "it is not calibrated: put the grip on the inkwell, or calibrate it in Haply Hub";
  if (arm_.basis.value_or("XYZ") != "XYZ")
    return "the service gives its axes in the order " + *arm_.basis + " and does not change it";
  if (arm_.mount_scaled.value_or(false) || arm_.place_scaled.value_or(false))
    return "the service scales its movements: set the scale of its mount and transform to 1";
  if (!grip_.id.empty() && !grip_.ready.value_or(true)) return "its VerseGrip sleeps, or is away";
  if (!grip_.id.empty() && !grip_.orientation) return "its VerseGrip does not say how it is turned";
  return "";
}

}  // namespace sonde
