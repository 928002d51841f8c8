// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/geometry_thread.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::at_depth;

using namespace std::chrono_literals;

class GeometryThreadTest : public testing::Test {
 protected:
  /// Waits for the rows of a tick; for a minute, which only a hung thread takes.
  bool wait_for(std::uint64_t tick) {
    for (int i = 0; i < 60000; ++i, std::this_thread::sleep_for(1ms))
      if (geometry.newest().tick >= tick) return true;
    return false;
  }
  GeometryThread geometry{
      {test::body(test::box({0.02, 0.03, 0.05})), test::body(test::box({0.3, 0.3, 0.1}))},
      Method::pdg,
      Budget{}};
};

TEST_F(GeometryThreadTest, has_the_rows_of_the_start_at_once) {
  geometry.start(at_depth(0.002));
  EXPECT_NEAR(geometry.newest().separation.depth, 0.002, 1e-5);
  EXPECT_GT(geometry.newest().size, 0);
}

TEST_F(GeometryThreadTest, the_newest_pose_asked_about_is_answered) {
  geometry.start(at_depth(-0.01));
  for (std::uint64_t i = 1; i <= 1000; ++i) geometry.ask(at_depth(1e-6 * double(i)), i, double(i));
  ASSERT_TRUE(wait_for(1000));
  const LocalContacts& contacts = geometry.newest();
  EXPECT_EQ(contacts.tick, 1000u);
  EXPECT_EQ(contacts.time, 1000);
  EXPECT_NEAR(contacts.separation.depth, 1e-3, 1e-6);
}

TEST_F(GeometryThreadTest, stops_and_starts_anew) {
  geometry.stop();
  geometry.start(at_depth(0.002));
  geometry.ask(at_depth(0.003), 7, 0.007);
  ASSERT_TRUE(wait_for(7));
  geometry.stop();
  geometry.stop();
  EXPECT_EQ(geometry.newest().tick, 7u);
  geometry.start(at_depth(0.001));
  EXPECT_EQ(geometry.newest().tick, 0u);
  EXPECT_NEAR(geometry.newest().separation.depth, 0.001, 1e-5);
  geometry.ask(at_depth(0.002), 1, 0);
  EXPECT_TRUE(wait_for(1));
}

TEST_F(GeometryThreadTest, neither_asking_nor_reading_allocates) {
  geometry.start(at_depth(0.002));
  int rows = 0;
  test::AllocationCounter counter;
  for (std::uint64_t i = 1; i <= 1000; ++i) {
    geometry.ask(at_depth(1e-6 * double(i)), i, double(i));
    rows += geometry.newest().size;
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_EQ(counter.frees(), 0u);
  EXPECT_GT(rows, 0);
}

}  // namespace
}  // namespace sonde
