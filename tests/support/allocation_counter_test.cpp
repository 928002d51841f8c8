// SPDX-License-Identifier: GPL-3.0-or-later
// The counter itself: a test of "no allocation" is worth nothing if the counter sees nothing.
#include "tests/support/allocation_counter.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "engine/platform/real_time.hpp"

namespace sonde::test {
namespace {

struct alignas(64) Aligned {
  double x[8];
};

/// The compiler may leave out an allocation whose block nobody looks at.
void look_at(void* block) { asm volatile("" : : "g"(block) : "memory"); }

TEST(AllocationCounter, sees_nothing_where_nothing_is_allocated) {
  double sum = 0;
  AllocationCounter counter;
  for (int i = 0; i < 100; ++i) sum += i;
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_EQ(counter.frees(), 0u);
  EXPECT_EQ(sum, 4950);
}

TEST(AllocationCounter, sees_new_and_delete) {
  AllocationCounter counter;
  auto* block = new int(1);
  look_at(block);
  delete block;
  counter.stop();
  EXPECT_EQ(counter.allocations(), 1u);
  EXPECT_EQ(counter.frees(), 1u);
}

TEST(AllocationCounter, sees_aligned_new) {
  AllocationCounter counter;
  auto block = std::make_unique<Aligned>();
  look_at(block.get());
  block.reset();
  counter.stop();
  EXPECT_EQ(counter.allocations(), 1u);
  EXPECT_EQ(counter.frees(), 1u);
}

TEST(AllocationCounter, sees_malloc_and_free) {
  AllocationCounter counter;
  void* block = std::malloc(10);
  look_at(block);
  std::free(block);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 1u);
  EXPECT_EQ(counter.frees(), 1u);
}

#ifndef __SANITIZE_THREAD__  // ThreadSanitizer has no hooks for all of these
TEST(AllocationCounter, sees_the_relatives_of_malloc) {
  AllocationCounter counter;
  void* a = std::calloc(3, 4);
  look_at(a);
  void* b = std::aligned_alloc(64, 128);
  look_at(b);
  std::free(a);
  std::free(b);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 2u);
  EXPECT_EQ(counter.frees(), 2u);

  void* c = std::malloc(10);
  AllocationCounter second;
  c = std::realloc(c, 100000);
  look_at(c);
  second.stop();
  std::free(c);
  EXPECT_GE(second.allocations(), 1u);
}
#endif

TEST(AllocationCounter, sees_a_growing_vector) {
  std::vector<int> v;
  AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) v.push_back(i);
  counter.stop();
  EXPECT_GE(counter.allocations(), 5u);
}

TEST(AllocationCounter, looks_at_this_thread_and_between_the_marks_only) {
  std::vector<int> before(1000);
  std::uint64_t there = 0;
  std::thread other;
  {
    AllocationCounter outer;  // starting a thread allocates: stopped before the other one works
    other = std::thread([&there] {
      AllocationCounter counter;
      auto block = std::make_unique<int[]>(10);
      look_at(block.get());
      counter.stop();
      there = counter.allocations();
    });
    outer.stop();
    EXPECT_GE(outer.allocations(), 1u);
  }
  AllocationCounter counter;
  other.join();
  counter.stop();
  std::vector<int> after(1000);
  look_at(after.data());
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_EQ(there, 1u);
}

TEST(AllocationCounter, of_the_process_sees_every_thread) {
  std::atomic<bool> go{false}, done{false};
  std::thread other([&] {
    while (!go) std::this_thread::yield();
    auto block = std::make_unique<int[]>(10);
    look_at(block.get());
    block.reset();
    done = true;
    while (go) std::this_thread::yield();
  });
  ProcessAllocationCounter counter;
  go = true;
  while (!done) std::this_thread::yield();
  counter.stop();
  go = false;
  other.join();
  auto after = std::make_unique<int>(1);
  look_at(after.get());
  EXPECT_GE(counter.allocations(), 1u);
  EXPECT_GE(counter.frees(), 1u);
  const std::uint64_t seen = counter.allocations();
  after.reset(new int(2));
  look_at(after.get());
  EXPECT_EQ(counter.allocations(), seen);
}

TEST(AllocationCounter, of_named_threads_sees_those_and_no_others) {
  constexpr const char* names[] = {"sonde-one", "sonde-other"};
  const auto allocate_as = [](const char* name) {
    std::thread([name] {
      if (name) name_thread(name);
      auto block = std::make_unique<int>(1);
      look_at(block.get());
    }).join();
  };
  NamedAllocationCounter counter(names);
  allocate_as(nullptr);
  allocate_as("sonde-third");
  EXPECT_EQ(counter.allocations(), 0u);
  allocate_as("sonde-other");
  const std::uint64_t seen = counter.allocations();
  EXPECT_GE(seen, 1u);
  EXPECT_GE(counter.frees(), 1u);
  counter.stop();
  allocate_as("sonde-one");
  EXPECT_EQ(counter.allocations(), seen);
}

}  // namespace
}  // namespace sonde::test
