// SPDX-License-Identifier: GPL-3.0-or-later
// What the system permits is not ours to say: the test asks it for what it granted.
#include "engine/platform/real_time.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <fstream>
#include <string>
#include <thread>
#include <vector>

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
  EXPECT_EQ(got.locked, std::string(got.memory).starts_with("memory locked"));
  EXPECT_EQ(!got.scheduled, std::string(got.scheduling).starts_with("no real-time"));
  EXPECT_EQ(!got.locked, std::string(got.memory).starts_with("memory not locked"));
}

/// The reference is the kernel's own count of what is locked.
TEST(RealTime, where_it_says_so_what_comes_later_is_locked_too) {
  RealTime got;
  std::thread([&] { got = request_real_time(); }).join();
  const auto locked = [] {
    std::ifstream in("/proc/self/status");
    double kilobytes = 0;
    for (std::string word; in >> word;)
      if (word == "VmLck:") in >> kilobytes;
    return kilobytes;
  };
  const double before = locked();
  std::vector<char> later(32 << 20, 1);
  const bool grew = locked() - before > 30'000;
  munlockall();
  EXPECT_EQ(grew, std::string(got.memory) == "memory locked") << got.memory;
}

TEST(RealTime, each_thread_of_the_loop_has_a_processor_where_there_are_more_than_two) {
  const int allowed[] = {0, 2, 3, 7};
  EXPECT_EQ(processor_for(LoopThread::servo, allowed, 4), 7);
  EXPECT_EQ(processor_for(LoopThread::geometry, allowed, 4), 3);
  EXPECT_EQ(processor_for(LoopThread::servo, allowed, 3), 3);
  for (const LoopThread thread : {LoopThread::servo, LoopThread::geometry})
    for (const int count : {1, 2}) EXPECT_EQ(processor_for(thread, allowed, count), -1);
}

TEST(RealTime, the_processor_is_as_it_says) {
  cpu_set_t all, mine;
  sched_getaffinity(0, sizeof all, &all);
  std::string words;
  std::thread([&] {
    words = request_processor(LoopThread::servo);
    sched_getaffinity(0, sizeof mine, &mine);
  }).join();
  const bool own = CPU_COUNT(&mine) == 1 && CPU_COUNT(&all) > 2;
  EXPECT_EQ(own, words == "a processor of its own") << words;
  if (!own) {
    EXPECT_TRUE(CPU_EQUAL(&mine, &all));
  }
}

TEST(RealTime, nothing_is_said_where_nothing_was_asked) {
  const RealTime none;
  EXPECT_STREQ(none.scheduling, "");
  EXPECT_STREQ(none.memory, "");
  EXPECT_STREQ(none.processor, "");
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
