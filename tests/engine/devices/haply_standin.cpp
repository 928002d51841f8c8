// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/engine/devices/haply_standin.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdlib>
#include <list>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "engine/platform/real_time.hpp"

namespace sonde::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using Json = nlohmann::json;
using WebSocket = beast::websocket::stream<tcp::socket>;
using namespace std::chrono_literals;

Json json_of(const Vec3& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }
Json json_of(const Quat& q) { return {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}; }

/// Everything that is connected, as the documentation shows it.
Json everything() {
  return Json::parse(R"({"session_id": 7,
    "inverse3": [{"device_id": "049D",
      "config": {"type": "inverse3", "port": "/dev/ttyACM0", "handedness": "right",
        "device_info": {"major_version": 7, "minor_version": 4, "id": "049D"},
        "gravity_compensation": {"enabled": true, "scaling_factor": 1.0},
        "preset": "defaults", "basis": {"permutation": "XYZ"},
        "mount": {"position": {"x": 0, "y": 0, "z": 0},
                  "rotation": {"w": 1, "x": 0, "y": 0, "z": 0},
                  "scale": {"x": 1, "y": 1, "z": 1}},
        "filters": {"force_gate": {"gain": 0.3}, "damping": {"scalar": 0.0}}},
      "state": {"cursor_position": {"x": 0, "y": 0, "z": 0},
        "cursor_velocity": {"x": 0, "y": 0, "z": 0},
        "angular_position": {"a0": 0, "a1": 0, "a2": 0},
        "body_orientation": {"w": 1, "x": 0, "y": 0, "z": 0},
        "control_domain": "cartesian", "control_mode": "idle",
        "transform": {"position": {"x": 0, "y": 0, "z": 0},
                      "rotation": {"w": 1, "x": 0, "y": 0, "z": 0},
                      "scale": {"x": 1, "y": 1, "z": 1}}},
      "status": {"calibrated": true, "in_use": false, "power_supply": true, "ready": true,
                 "started": true}}],
    "wireless_verse_grip": [{"device_id": "61576", "config": {"type": "wireless_verse_grip"},
      "state": {"orientation": {"w": 1, "x": 0, "y": 0, "z": 0}, "hall": 0,
        "buttons": {"a": false, "b": false, "c": false}, "battery_level": 0.8},
      "status": {"ready": true, "connected": true, "awake": true}}]})");
}

}  // namespace

struct HaplyStandin::State {
  asio::io_context io;
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  mutable std::mutex mutex;  // guards what follows
  Json all = everything();
  std::set<std::string> arms{"049D"};  // that were ever listed
  Manner manner = Manner::usual;
  DeviceClock::time_point changed = DeviceClock::now();
  std::optional<DeviceClock::duration> until_zero;
  std::string said, broken;
  Vec3 force = Vec3::Zero();
  std::uint64_t asked = 0, answered = 0;
  int so_far = 0, zero_by = 0;  // connections
  std::list<tcp::socket*> open;
  bool stopping = false;

  std::list<std::thread> sessions;
  std::thread thread;

  Manner now() const {
    const std::lock_guard lock(mutex);
    return manner;
  }
  bool ends() const {
    const std::lock_guard lock(mutex);
    return stopping;
  }
  void accept() {
    for (;;) {
      beast::error_code error;
      tcp::socket socket(io);
      acceptor.accept(socket, error);
      if (error || ends()) return;
      socket.set_option(tcp::no_delay(true));
      sessions.emplace_back([this, taken = std::move(socket)]() mutable { serve(taken); });
    }
  }
  /// Lists the socket, so that the end can end it, while `action` lasts.
  template <class Action>
  void listed(tcp::socket& socket, const Action& action) {
    std::list<tcp::socket*>::iterator place;
    {
      const std::lock_guard lock(mutex);
      place = open.insert(open.end(), &socket);
    }
    try {
      action();
    } catch (const boost::system::system_error&) {
      // The other side has gone.
    }
    const std::lock_guard lock(mutex);
    open.erase(place);
  }
  void wait_while(Manner such) const {
    while (now() == such && !ends()) std::this_thread::sleep_for(1ms);
  }

  void serve(tcp::socket& socket) {
    if (now() == Manner::mute) return listed(socket, [&] { wait_while(Manner::mute); });
    if (now() == Manner::no_web)
      return listed(socket, [&] { asio::write(socket, asio::buffer("220 ready\r\n", 11)); });
    WebSocket web(std::move(socket));
    listed(web.next_layer(), [&] { talk(web); });
  }
  void talk(WebSocket& web) {
    const Promptness prompt(true);
    const int number = begun();
    web.accept();
    web.text(true);
    web.write(asio::buffer(answer(true)));
    beast::flat_buffer buffer;
    for (;;) {
      wait_while(Manner::deaf);
      buffer.clear();
      web.read(buffer);
      const bool full = hear(beast::buffers_to_string(buffer.data()), number);
      if (now() == Manner::closes) return web.close(beast::websocket::close_code::going_away);
      if (now() == Manner::silent) continue;
      while (now() == Manner::pings && !ends()) web.ping({});
      if (now() == Manner::pings) continue;
      if (now() == Manner::late) std::this_thread::sleep_for(30ms);
      if (now() == Manner::slow) std::this_thread::sleep_for(5ms);
      const int times = now() == Manner::floods ? 1000 : 1;
      for (int i = 0; i < times; ++i) web.write(asio::buffer(answer(full)));
      const std::lock_guard lock(mutex);
      answered += static_cast<std::uint64_t>(times);
    }
  }
  int begun() {
    const std::lock_guard lock(mutex);
    return ++so_far;
  }
  /// Returns whether everything is asked for.
  bool hear(const std::string& text, int number) {
    const std::lock_guard lock(mutex);
    ++asked;
    try {
      const Json json = Json::parse(text);
      const Json& arm = json.at("inverse3").at(0);
      const Json& values = arm.at("commands").at("set_cursor_force").at("values");
      if (!arms.contains(arm.at("device_id").get<std::string>()))
        throw std::runtime_error("for another arm");
      force = {values.at("x").get<double>(), values.at("y").get<double>(),
               values.at("z").get<double>()};
      if (force.isZero(0) && !until_zero) {
        until_zero = DeviceClock::now() - changed;
        zero_by = number;
      }
      const Json::json_pointer basis("/session/configure/basis/permutation");
      if (json.contains(basis)) all["inverse3"][0]["config"]["basis"]["permutation"] = json[basis];
      return json.contains("session") && json["session"].contains("force_render_full_state");
    } catch (const std::exception& error) {
      if (broken.empty()) broken = std::string(error.what()) + ": " + text;
    }
    return false;
  }
  /// Configuration and status are said only at first, and where they are asked for.
  std::string answer(bool full) const {
    const std::lock_guard lock(mutex);
    if (!said.empty()) return said;
    if (full) return all.dump();
    Json some = all;
    for (const char* key : {"inverse3", "wireless_verse_grip", "verse_grip"})
      if (some.contains(key) && some[key].is_array())
        for (Json& one : some[key]) {
          one.erase("config");
          one.erase("status");
        }
    return some.dump();
  }
};

HaplyStandin::HaplyStandin() : state_(std::make_unique<State>()) {
  state_->thread = std::thread([this] { state_->accept(); });
  ::setenv("SONDE_HAPLY_PORT", std::to_string(port()).c_str(), 1);
}

HaplyStandin::~HaplyStandin() {
  ::setenv("SONDE_HAPLY_PORT", "0", 1);
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
    for (tcp::socket* socket : state_->open) {
      beast::error_code ignored;
      socket->shutdown(tcp::socket::shutdown_both, ignored);
    }
  }
  // A connection wakes the thread that waits for one.
  asio::io_context io;
  tcp::socket last(io);
  beast::error_code ignored;
  last.connect(state_->acceptor.local_endpoint(), ignored);
  state_->thread.join();
  for (std::thread& session : state_->sessions) session.join();
}

std::uint16_t HaplyStandin::port() const { return state_->acceptor.local_endpoint().port(); }

void HaplyStandin::move_to(const Vec3& p) {
  const std::lock_guard lock(state_->mutex);
  state_->all["inverse3"][0]["state"]["cursor_position"] = json_of(p);
}

void HaplyStandin::turn_to(const Quat& q) {
  const std::lock_guard lock(state_->mutex);
  state_->all["wireless_verse_grip"][0]["state"]["orientation"] = json_of(q);
}

void HaplyStandin::add_arm(const std::string& id) {
  const std::lock_guard lock(state_->mutex);
  Json another = state_->all["inverse3"][0];
  another["device_id"] = id;
  state_->arms.insert(id);
  state_->all["inverse3"].push_back(another);
}

void HaplyStandin::behave(Manner manner) {
  const std::lock_guard lock(state_->mutex);
  state_->manner = manner;
  state_->changed = DeviceClock::now();
  state_->until_zero.reset();
}

void HaplyStandin::say(const std::string& text) {
  const std::lock_guard lock(state_->mutex);
  state_->said = text;
  state_->changed = DeviceClock::now();
  state_->until_zero.reset();
}

void HaplyStandin::set(const std::string& pointer, const std::string& json) {
  const std::lock_guard lock(state_->mutex);
  state_->all[Json::json_pointer(pointer)] = Json::parse(json);
}

Vec3 HaplyStandin::force() const {
  const std::lock_guard lock(state_->mutex);
  return state_->force;
}

std::uint64_t HaplyStandin::asked() const {
  const std::lock_guard lock(state_->mutex);
  return state_->asked;
}

std::uint64_t HaplyStandin::answered() const {
  const std::lock_guard lock(state_->mutex);
  return state_->answered;
}

int HaplyStandin::connections() const {
  const std::lock_guard lock(state_->mutex);
  return static_cast<int>(state_->open.size());
}

std::optional<DeviceClock::duration> HaplyStandin::until_zero() const {
  const std::lock_guard lock(state_->mutex);
  return state_->until_zero;
}

int HaplyStandin::connection_of_zero() const {
  const std::lock_guard lock(state_->mutex);
  return state_->zero_by;
}

int HaplyStandin::connections_so_far() const {
  const std::lock_guard lock(state_->mutex);
  return state_->so_far;
}

std::string HaplyStandin::broken() const {
  const std::lock_guard lock(state_->mutex);
  return state_->broken;
}

}  // namespace sonde::test
