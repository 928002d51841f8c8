// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/threads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
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

TEST(RunInOrder, results_come_in_order_however_long_each_takes) {
  for (const std::size_t threads : {1u, 2u, 5u}) {
    std::vector<std::size_t> order;
    run_in_order(
        200, threads,
        [](std::size_t i) {
          if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
          return 3 * i;
        },
        [&](std::size_t i, std::size_t result) {
          EXPECT_EQ(result, 3 * i);
          order.push_back(i);
        });
    ASSERT_EQ(order.size(), 200u);
    EXPECT_TRUE(std::ranges::is_sorted(order));
  }
  run_in_order(
      0, 3, [](std::size_t i) { return i; }, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(RunInOrder, no_thread_is_further_ahead_than_it_may_be) {
  constexpr std::size_t ahead = 4;
  std::atomic<std::size_t> done{0};
  run_in_order(
      300, 4,
      [&](std::size_t i) {
        EXPECT_LT(i, done + ahead + 1) << "one more: it is counted after it is done";
        if (i % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return i;
      },
      [&](std::size_t, std::size_t) { ++done; }, ahead);
  EXPECT_EQ(done, 300u);
}

TEST(RunInOrder, throws_what_either_step_throws_and_ends) {
  for (const std::size_t threads : {1u, 3u}) {
    std::atomic<int> begun{0};
    const auto compute = [&](std::size_t i) {
      ++begun;
      if (i == 20) throw std::runtime_error("computed");
      return i;
    };
    std::size_t last = 0;
    EXPECT_THROW(
        run_in_order(100'000, threads, compute, [&](std::size_t i, std::size_t) { last = i; }),
        std::runtime_error);
    EXPECT_LT(last, 20u);
    EXPECT_LT(begun, 100'000);
    EXPECT_THROW(run_in_order(
                     100'000, threads, [](std::size_t i) { return i; },
                     [](std::size_t i, std::size_t) {
                       if (i == 5) throw Cancelled();
                     }),
                 Cancelled);
  }
}

}  // namespace
}  // namespace sonde
