// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/local_socket.hpp"

#include <gmock/gmock.h>

#include "tests/engine/devices/haply_standin.hpp"
#include "tests/engine/devices/loaded_standin.hpp"

namespace sonde::test {
namespace {

using Manner = HaplyStandin::Manner;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr const char* command =
    R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"values":{"x":0,"y":0,"z":0}}}}]})";

DeviceClock::time_point in(DeviceClock::duration time) { return DeviceClock::now() + time; }

TEST(LocalSocket, a_message_is_answered) {
  HaplyStandin standin;
  LocalSocket socket(standin.port(), 5s);
  ASSERT_TRUE(socket.receive(in(5s)));
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(socket.send(command));
    const auto answer = socket.receive(in(5s));
    ASSERT_TRUE(answer);
    EXPECT_THAT(*answer, HasSubstr("cursor_position"));
  }
  EXPECT_EQ(standin.asked(), 50U);
  EXPECT_EQ(socket.ended(), "");
  EXPECT_FALSE(socket.receive(in(1ms))) << "nothing was asked";
}

TEST(LocalSocket, without_a_service_it_says_so) {
  std::uint16_t port = 0;
  {
    const HaplyStandin standin;
    port = standin.port();
  }
  EXPECT_THAT(refusal([&] { LocalSocket(port, 5s); }),
              testing::AllOf(HasSubstr(LocalSocket::address(port)), HasSubstr("refused")));
}

TEST(LocalSocket, a_service_that_does_not_shake_hands_is_not_waited_for) {
  HaplyStandin standin;
  standin.behave(Manner::mute);
  EXPECT_THAT(refusal([&] { LocalSocket(standin.port(), 50ms); }), HasSubstr("does not answer"));
  standin.behave(Manner::no_web);
  EXPECT_NE(refusal([&] { LocalSocket(standin.port(), 5s); }), "");
}

TEST(LocalSocket, a_message_that_is_too_long_ends_it) {
  HaplyStandin standin;
  LocalSocket socket(standin.port(), 5s);
  ASSERT_TRUE(socket.receive(in(5s)));
  standin.say(std::string(LocalSocket::longest_message + 1, ' '));
  ASSERT_TRUE(socket.send(command));
  EXPECT_FALSE(socket.receive(in(5s)));
  EXPECT_NE(socket.ended(), "");
  EXPECT_FALSE(socket.send(command));
}

TEST(LocalSocket, a_connection_that_ends_is_noticed) {
  HaplyStandin standin;
  LocalSocket socket(standin.port(), 5s);
  ASSERT_TRUE(socket.receive(in(5s)));
  standin.behave(Manner::closes);
  ASSERT_TRUE(socket.send(command));
  EXPECT_FALSE(socket.receive(in(5s)));
  EXPECT_NE(socket.ended(), "");
}

/// What the other side does not read fills the system's buffers; then nothing more is begun.
TEST(LocalSocket, a_service_that_does_not_read_holds_nobody_up) {
  HaplyStandin standin;
  LocalSocket socket(standin.port(), 5s);
  ASSERT_TRUE(socket.receive(in(5s)));
  standin.behave(Manner::deaf);
  const std::string much(1 << 20, ' ');
  int sent = 0;
  while (sent < 1000 && socket.send(much) && socket.flush(in(50ms))) ++sent;
  EXPECT_LT(sent, 1000);
  EXPECT_EQ(socket.ended(), "");
  EXPECT_FALSE(socket.send(much)) << "what is on its way goes first";
}

}  // namespace
}  // namespace sonde::test
