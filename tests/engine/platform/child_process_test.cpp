// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/child_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace sonde {
namespace {

TEST(ChildProcess, gives_what_the_work_returns_and_changes_nothing_here) {
  int here = 1;
  const std::string long_one(5'000'000, 'x');
  const ChildEnd end = in_child_process(
      [&] {
        here = 2;
        return long_one;
      },
      {});
  EXPECT_EQ(here, 1);
  EXPECT_EQ(end.output, long_one);
  EXPECT_EQ(end.signal, 0);
  EXPECT_FALSE(end.threw);
}

TEST(ChildProcess, what_ends_it_does_not_end_us) {
  const auto end_of = [](void (*work)()) {
    return in_child_process(
        [work] {
          work();
          return std::string();
        },
        {});
  };
  EXPECT_EQ(end_of([] { std::raise(SIGSEGV); }).signal, SIGSEGV);
  EXPECT_EQ(end_of([] { std::abort(); }).signal, SIGABRT);
  EXPECT_TRUE(end_of([] { throw std::runtime_error("no"); }).threw);
  EXPECT_TRUE(end_of([] { _exit(7); }).threw);
}

TEST(ChildProcess, is_ended_where_it_is_cancelled) {
  int asked = 0;
  EXPECT_THROW(in_child_process(
                   [] {
                     for (;;) pause();
                     return std::string();
                   },
                   [&](double) { return ++asked < 3; }),
               Cancelled);
}

}  // namespace
}  // namespace sonde
