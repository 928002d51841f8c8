// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/allocation_counter.hpp"

#include <sys/prctl.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace {

// Plain thread-local numbers of the executable itself: reaching them never allocates.
struct Counts {
  bool on;
  std::uint64_t allocations;
  std::uint64_t frees;
};
thread_local Counts counts{};

std::atomic<bool> all_on{false};
std::atomic<std::uint64_t> all_allocations{0}, all_frees{0};

std::atomic<bool> named_on{false};
std::span<const char* const> wanted_names;
std::atomic<std::uint64_t> named_allocations{0}, named_frees{0};

/// Asks the system each time: a thread may be named after its first allocation.
bool has_wanted_name() noexcept {
  char name[16] = "";
  prctl(PR_GET_NAME, name);
  for (const char* wanted : wanted_names)
    if (std::strcmp(name, wanted) == 0) return true;
  return false;
}

void count_allocation() noexcept {
  if (counts.on) ++counts.allocations;
  if (named_on.load(std::memory_order_acquire) && has_wanted_name()) ++named_allocations;
  if (all_on.load(std::memory_order_relaxed)) ++all_allocations;
}
void count_free(const volatile void* block) noexcept {
  if (block == nullptr) return;
  if (counts.on) ++counts.frees;
  if (named_on.load(std::memory_order_acquire) && has_wanted_name()) ++named_frees;
  if (all_on.load(std::memory_order_relaxed)) ++all_frees;
}

}  // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(SONDE_SANITIZED)

// A sanitizer replaces malloc itself, and offers hooks instead.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {
const int hooks_installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { count_allocation(); },
    [](const volatile void* block) { count_free(block); });
}  // namespace

#else

// glibc lets a program bring its own malloc; operator new of the C++ library ends here too.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept {
  count_allocation();
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) noexcept {
  count_allocation();
  return __libc_calloc(n, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  count_allocation();
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  count_allocation();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  void* const block = memalign(alignment, size);
  if (block == nullptr) return ENOMEM;
  *out = block;
  return 0;
}
void free(void* block) noexcept {
  count_free(block);
  __libc_free(block);
}
}

#endif

namespace sonde::test {

AllocationCounter::AllocationCounter() { counts = {.on = true, .allocations = 0, .frees = 0}; }

void AllocationCounter::stop() {
  if (!running_) return;
  running_ = false;
  counts.on = false;
  allocations_ = counts.allocations;
  frees_ = counts.frees;
}

NamedAllocationCounter::NamedAllocationCounter(std::span<const char* const> names) {
  wanted_names = names;
  named_allocations = named_frees = 0;
  named_on.store(true, std::memory_order_release);
}
void NamedAllocationCounter::stop() { named_on = false; }
std::uint64_t NamedAllocationCounter::allocations() const { return named_allocations; }
std::uint64_t NamedAllocationCounter::frees() const { return named_frees; }

ProcessAllocationCounter::ProcessAllocationCounter() {
  all_allocations = all_frees = 0;
  all_on = true;
}
void ProcessAllocationCounter::stop() { all_on = false; }
std::uint64_t ProcessAllocationCounter::allocations() const { return all_allocations; }
std::uint64_t ProcessAllocationCounter::frees() const { return all_frees; }

}  // namespace sonde::test
