// SPDX-License-Identifier: GPL-3.0-or-later
// What the system permits is not ours to say: the test asks it for what it granted.
#include "engine/base/real_time.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <string>
#include <thread>

namespace sonde {
namespace {

TEST(RealTime, what_is_said_is_what_was_granted) {
  RealTime got;
  int policy = -1;
  std::thread thread([&] {
    got = request_real_time();
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
  });
  thread.join();
  munlockall();
  EXPECT_EQ(got.scheduled, policy == SCHED_FIFO);
  EXPECT_EQ(got.scheduled, std::string(got.scheduling) == "real-time scheduling");
  EXPECT_EQ(got.locked, std::string(got.memory) == "memory locked");
  EXPECT_EQ(!got.scheduled, std::string(got.scheduling).starts_with("no real-time"));
  EXPECT_EQ(!got.locked, std::string(got.memory).starts_with("memory not locked"));
}

TEST(RealTime, nothing_is_said_where_nothing_was_asked) {
  const RealTime none;
  EXPECT_STREQ(none.scheduling, "");
  EXPECT_STREQ(none.memory, "");
}

TEST(RealTime, promptness_is_between_precedence_and_deadlines_and_ends) {
  int policy = -1, after = -1, precedence = 0, prompt = 0, servo = 0;
  std::string words;
  bool all = true;
  const auto now = [&policy] {
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return parameters.sched_priority;
  };
  std::thread([&] {
    {
      const Promptness wanted(true);
      prompt = now();
      words = wanted.words();
    }
    EXPECT_EQ(policy == SCHED_FIFO, words.empty()) << words;
    now();
    after = policy;
    const Promptness not_wanted(false);
    EXPECT_STREQ(not_wanted.words(), "");
    EXPECT_EQ(now(), 0);
    all = request_precedence();
    precedence = now();
    all = all && request_real_time().scheduled;
    servo = now();
  }).join();
  munlockall();
  EXPECT_EQ(after, SCHED_OTHER);
  if (!words.empty() || !all) return;  // not permitted here: nothing to compare
  EXPECT_LT(precedence, prompt);
  EXPECT_LT(prompt, servo);
}

TEST(RealTime, precedence_is_of_the_thread_alone_and_behind_what_has_deadlines) {
  const int before = getpriority(PRIO_PROCESS, 0);
  bool granted = false;
  int nice = 0, policy = -1;
  sched_param there{}, servo{};
  std::thread thread([&] {
    granted = request_precedence();
    nice = getpriority(PRIO_PROCESS, 0);
    pthread_getschedparam(pthread_self(), &policy, &there);
  });
  thread.join();
  EXPECT_EQ(granted, nice < 0 || policy == SCHED_FIFO);
  std::thread other([&] {
    if (!request_real_time().scheduled)
      servo.sched_priority = 99;  // nothing to compare with
    else
      pthread_getschedparam(pthread_self(), &policy, &servo);
  });
  other.join();
  munlockall();
  EXPECT_LT(there.sched_priority, servo.sched_priority);
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), before);
  pthread_getschedparam(pthread_self(), &policy, &there);
  EXPECT_EQ(policy, SCHED_OTHER);
}

}  // namespace
}  // namespace sonde
