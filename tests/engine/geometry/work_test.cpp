// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/work.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace sonde {
namespace {

TEST(Work, EachIndexOnceInOrder) {
  for (const std::size_t n : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
    std::vector<std::size_t> seen;
    for_each_index(n, {}, [&](std::size_t i) { seen.push_back(i); });
    ASSERT_EQ(seen.size(), n);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(seen[i], i);
  }
}

TEST(Work, ReportsPieceByPiece) {
  std::vector<double> seen;
  const auto keep = [&](double f) {
    seen.push_back(f);
    return true;
  };
  for_each_index(4 << 16, keep, [](std::size_t) {});
  EXPECT_THAT(seen, testing::ElementsAre(0, 0.25, 0.5, 0.75));
}

TEST(Work, CancellingEndsTheLoopAtThatPiece) {
  std::size_t calls = 0, steps = 0;
  EXPECT_THROW(for_each_index(
                   4 << 16, [&](double) { return ++calls < 3; }, [&](std::size_t) { ++steps; }),
               Cancelled);
  EXPECT_EQ(steps, std::size_t{2} << 16);
}

TEST(Work, PartsOfParts) {
  double seen = -1;
  const Progress whole = [&](double f) {
    seen = f;
    return f < 0.6;
  };
  const Progress half = part_of(whole, 0.5, 1), quarter = part_of(half, 0, 0.5);
  EXPECT_TRUE(quarter(0));
  EXPECT_EQ(seen, 0.5);
  EXPECT_FALSE(quarter(1));
  EXPECT_EQ(seen, 0.75);
  EXPECT_FALSE(part_of({}, 0, 1));
}

TEST(AtOnce, DoesBothPartsAndReportsOnTheCallersThread) {
  for (const bool two_threads : {false, true}) {
    const auto caller = std::this_thread::get_id();
    std::vector<double> seen;
    std::thread::id here, there;
    at_once(
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

TEST(AtOnce, CancellingStopsTheOtherThread) {
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
  EXPECT_THROW(at_once(
                   true, cancel, [](const Progress& part) { report(part, 0); }, until_cancelled),
               Cancelled);
  EXPECT_TRUE(stopped);
}

TEST(AtOnce, ThrowsWhatEitherPartThrows) {
  const auto fail = [](const Progress&) { throw InputError("a fault"); };
  const auto nothing = [](const Progress&) {};
  for (const bool two_threads : {false, true}) {
    EXPECT_THROW(at_once(two_threads, {}, fail, nothing), InputError);
    EXPECT_THROW(at_once(two_threads, {}, nothing, fail), InputError);
  }
}

TEST(RunParallel, DoesEachOnceAndThrowsWhatOneThrows) {
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
