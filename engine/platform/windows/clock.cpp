// SPDX-License-Identifier: GPL-3.0-or-later
// An ordinary sleep ends at the next of Windows' ticks, up to 16 ms late.
#include "engine/platform/clock.hpp"

#include <windows.h>

#include <chrono>

namespace sonde {
namespace {

constexpr DWORD high_resolution = 2;  // CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, of Windows 10 (1803)
constexpr std::int64_t unit_ns = 100;

/// Of one thread; null where the system has none to give.
class Timer {
 public:
  Timer() noexcept : handle_(make(high_resolution)) {
    if (!handle_) handle_ = make(0);
  }
  ~Timer() {
    if (handle_) CloseHandle(handle_);
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  bool wait_ns(std::int64_t ns) noexcept {
    LARGE_INTEGER due;
    due.QuadPart = -((ns + unit_ns - 1) / unit_ns);  // from now on
    return handle_ && SetWaitableTimer(handle_, &due, 0, nullptr, nullptr, FALSE) &&
           WaitForSingleObject(handle_, INFINITE) == WAIT_OBJECT_0;
  }

 private:
  static HANDLE make(DWORD flags) noexcept {
    return CreateWaitableTimerExW(nullptr, nullptr, flags, TIMER_ALL_ACCESS);
  }
  HANDLE handle_;
};

}  // namespace

std::int64_t monotonic_ns() noexcept {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

void sleep_until_ns(std::int64_t due) noexcept {
  thread_local Timer timer;
  for (std::int64_t left; (left = due - monotonic_ns()) > 0;)
    if (!timer.wait_ns(left)) Sleep(static_cast<DWORD>(left / 1'000'000 + 1));
}

}  // namespace sonde
