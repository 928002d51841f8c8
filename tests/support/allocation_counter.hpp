// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace sonde::test {

/// Counts what this thread allocates and frees, by operator new, malloc or their relatives, from
/// construction until stop(). Anything that allocates by itself (a GoogleTest assertion, say)
/// belongs after stop(). One at a time in a thread.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter() { stop(); }
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;
  void stop();
  std::uint64_t allocations() const { return allocations_; }
  std::uint64_t frees() const { return frees_; }

 private:
  bool running_ = true;
  std::uint64_t allocations_ = 0;
  std::uint64_t frees_ = 0;
};

/// The same for the threads that have one of these names (see name_thread), from construction until
/// stop(). The names must live as long. One at a time.
class NamedAllocationCounter {
 public:
  explicit NamedAllocationCounter(std::span<const char* const> names);
  ~NamedAllocationCounter() { stop(); }
  NamedAllocationCounter(const NamedAllocationCounter&) = delete;
  NamedAllocationCounter& operator=(const NamedAllocationCounter&) = delete;
  void stop();
  std::uint64_t allocations() const;
  std::uint64_t frees() const;
};

/// The same for all threads of the process, from construction until stop(). One at a time.
class ProcessAllocationCounter {
 public:
  ProcessAllocationCounter();
  ~ProcessAllocationCounter() { stop(); }
  ProcessAllocationCounter(const ProcessAllocationCounter&) = delete;
  ProcessAllocationCounter& operator=(const ProcessAllocationCounter&) = delete;
  void stop();
  std::uint64_t allocations() const;
  std::uint64_t frees() const;
};

}  // namespace sonde::test
