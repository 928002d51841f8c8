// SPDX-License-Identifier: GPL-3.0-or-later
// The wall's clock may be set while the loop runs. Here it is set by hand: this program's own
// clock_gettime stands before the system's.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "engine/haptics/loop/servo.hpp"
#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/support/shapes.hpp"

namespace {
std::atomic<long> wall_clock_is_ahead{0};  // s
}

extern "C" __attribute__((visibility("default"))) int clock_gettime(clockid_t clock,
                                                                    timespec* now) noexcept {
  const long failed = ::syscall(SYS_clock_gettime, clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec += wall_clock_is_ahead.load();
  return static_cast<int>(failed);
}

namespace sonde {
namespace {

using namespace std::chrono_literals;

TEST(ServoClock, the_wall_clock_may_jump_an_hour_either_way) {
  ServoSettings settings;
  settings.safety.stalled_after = 60;  // s, far less than the jump
  Servo servo({test::body(test::box({0.02, 0.03, 0.05})), test::body(test::box({0.3, 0.3, 0.1}))},
              Method::pdg, Coupling{}, settings);
  const auto began = std::chrono::steady_clock::now();
  servo.start(test::at_depth(0.001));
  Snapshot last;
  for (const long ahead : {0L, 3600L, -3600L, 0L}) {
    const auto before = std::chrono::system_clock::now();
    const long jump = ahead - wall_clock_is_ahead.exchange(ahead);
    const double seen =
        std::chrono::duration<double>(std::chrono::system_clock::now() - before).count();
    ASSERT_NEAR(seen, double(jump), 60) << "the clock does not jump: nothing is tested";
    for (int ticks = 0; ticks < 100;) {
      Snapshot tick;
      if (!servo.next_tick(tick)) {
        ASSERT_LT(std::chrono::steady_clock::now() - began, 60s) << "the loop stands still";
        std::this_thread::sleep_for(1ms);
        continue;
      }
      ++ticks;
      if (last.tick > 0) {
        EXPECT_GT(tick.time, last.time);
        EXPECT_LT(tick.time - last.time, 60);
      }
      EXPECT_EQ(tick.hand.withheld, Withheld::nothing) << words(tick.hand.withheld);
      last = tick;
    }
  }
  const double passed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  EXPECT_LE(last.time, passed);
  servo.stop();
}

}  // namespace
}  // namespace sonde
