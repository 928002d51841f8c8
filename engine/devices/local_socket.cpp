// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/local_socket.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <utility>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Error = boost::system::error_code;

}  // namespace

struct LocalSocket::State {
  asio::io_context io{1};
  beast::websocket::stream<beast::tcp_stream> stream{io};
  beast::flat_buffer incoming;
  std::string outgoing;
  bool sending = false, arrived = false;
  std::string ended;

  /// Runs what is ready, until `done` or the time is over. What is ready now is not waited for, but
  /// of an endless stream of it no more than this runs after the time.
  static constexpr int most_ready = 64;
  template <class Done>
  bool run(DeviceClock::time_point until, const Done& done) {
    for (int ready = 0; !done();) {
      io.restart();
      if (io.poll_one() > 0) {
        if (++ready >= most_ready && DeviceClock::now() >= until) break;
      } else if (io.run_one_until(until) == 0) {
        break;
      }
    }
    return done();
  }
  /// Runs one step of opening; throws its error.
  template <class Begin>
  void step(DeviceClock::time_point until, const Begin& begin) {
    std::optional<Error> result;
    begin([&result](const Error& error) { result = error; });
    if (run(until, [&] { return result.has_value(); })) {
      if (*result) throw InputError(result->message());
      return;
    }
    // Its handler refers to this frame.
    Error ignored;
    stream.next_layer().socket().close(ignored);
    run(DeviceClock::time_point::max(), [&] { return result.has_value(); });
    throw InputError("it does not answer");
  }
  void connect(std::uint16_t port, DeviceClock::time_point until) {
    beast::tcp_stream& tcp = stream.next_layer();
    const asio::ip::tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    step(until, [&](auto done) { tcp.async_connect(here, done); });
    tcp.socket().set_option(asio::ip::tcp::no_delay(true));
    stream.read_message_max(longest_message);
    stream.text(true);
    const std::string host = "127.0.0.1:" + std::to_string(port);
    step(until, [&](auto done) { stream.async_handshake(host, "/", done); });
  }
  void read() {
    stream.async_read(incoming, [this](const Error& error, std::size_t) {
      if (error)
        end(error);
      else
        arrived = true;
    });
  }
  void end(const Error& error) {
    if (ended.empty()) ended = error.message();
  }
};

LocalSocket::LocalSocket(std::uint16_t port, DeviceClock::duration limit) {
  try {
    state_ = std::make_unique<State>();
    state_->connect(port, DeviceClock::now() + limit);
  } catch (const InputError& error) {
    throw InputError::in(address(port), error.what());
  } catch (const boost::system::system_error& error) {
    throw InputError::in(address(port), error.code().message());
  }
  state_->read();
}

LocalSocket::~LocalSocket() = default;

std::string LocalSocket::address(std::uint16_t port) {
  return "ws://127.0.0.1:" + std::to_string(port);
}

bool LocalSocket::send(std::string text) {
  State& state = *state_;
  if (!state.ended.empty() || !flush(DeviceClock::now())) return false;
  state.outgoing = std::move(text);
  state.sending = true;
  state.stream.async_write(asio::buffer(state.outgoing), [&state](const Error& error, std::size_t) {
    state.sending = false;
    if (error) state.end(error);
  });
  flush(DeviceClock::now());  // it begins at once
  return true;
}

bool LocalSocket::flush(DeviceClock::time_point until) {
  State& state = *state_;
  return state.run(until, [&] { return !state.sending || !state.ended.empty(); }) &&
         state.ended.empty();
}

std::optional<std::string> LocalSocket::receive(DeviceClock::time_point until) {
  State& state = *state_;
  state.run(until, [&] { return state.arrived || !state.ended.empty(); });
  if (!state.arrived) return {};
  std::string text = beast::buffers_to_string(state.incoming.data());
  state.incoming.clear();
  state.arrived = false;
  state.read();
  return text;
}

const std::string& LocalSocket::ended() const { return state_->ended; }

}  // namespace sonde
