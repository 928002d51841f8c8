// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/threads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

TEST(AtOnce, does_both_parts_and_reports_on_the_callers_thread) {
  for (const bool two_threads : {false, true}) {
    const auto caller = std::this_thread::get_id();
    std::vector<double> seen;
    std::thread::id here, there;
    run_both(
        two_threads,
        [&](double f) {
          EXPECT_EQ(std::this_thread::get_id(), caller);
          seen.push_back(f);
          return true;
        },
        [&](const Progress& part) {
          report(part, 0.5);
          here = std::this_thread::get_id();
        },
        [&](const Progress& part) {
          report(part, 0.5);
          there = std::this_thread::get_id();
        });
    EXPECT_EQ(here, caller);
    EXPECT_EQ(there == caller, !two_threads);
    EXPECT_EQ(seen, two_threads ? std::vector<double>{0.5} : (std::vector<double>{0.25, 0.75}));
  }
}

TEST(AtOnce, cancelling_stops_the_other_thread) {
  std::atomic<bool> started = false, stopped = false;
  const auto cancel = [&](double) {
    while (!started) std::this_thread::yield();
    return false;
  };
  const auto until_cancelled = [&](const Progress& part) {
    started = true;
    while (part(0)) std::this_thread::yield();
    stopped = true;
    throw Cancelled();
  };
  EXPECT_THROW(run_both(
                   true, cancel, [](const Progress& part) { report(part, 0); }, until_cancelled),
               Cancelled);
  EXPECT_TRUE(stopped);
}

TEST(AtOnce, throws_what_either_part_throws) {
  const auto fail = [](const Progress&) { throw InputError("a fault"); };
  const auto nothing = [](const Progress&) {};
  for (const bool two_threads : {false, true}) {
    EXPECT_THROW(run_both(two_threads, {}, fail, nothing), InputError);
    EXPECT_THROW(run_both(two_threads, {}, nothing, fail), InputError);
  }
}

TEST(RunParallel, does_each_once_and_throws_what_one_throws) {
  for (const std::size_t threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> done(1000);
    run_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    const auto fail = [](std::size_t i) {
      if (i == 7) throw InputError("a fault");
    };
    EXPECT_THROW(run_parallel(1000, threads, fail), InputError);
    run_parallel(0, threads, fail);
  }
}

}  // namespace
}  // namespace sonde
