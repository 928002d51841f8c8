// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/processor_time.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>

namespace sonde {
namespace {

TEST(ProcessorTime, sleep_is_not_counted_and_work_is) {
  // A sleep of 200 ms has a processor time of well under a millisecond on any machine.
  EXPECT_LT(processor_time_us([] { std::this_thread::sleep_for(std::chrono::milliseconds(200)); }),
            100e3);
  // Work until the C library's clock of the process, which has one thread here, says 5 ms.
  const auto work = [] {
    const clock_t begin = std::clock();
    while (std::clock() - begin < CLOCKS_PER_SEC / 200) {
    }
  };
  EXPECT_GT(processor_time_us(work), 4e3);
}

}  // namespace
}  // namespace sonde
