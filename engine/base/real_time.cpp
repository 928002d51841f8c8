// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/real_time.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <thread>

namespace sonde {
namespace {

/// Before all ordinary threads, behind those that the system itself runs in this way.
constexpr int priority = 20;

int schedule(int policy, int priority_of_it) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority_of_it;
  return pthread_setschedparam(pthread_self(), policy, &parameters);
}

const char* scheduling_words(int error) {
  switch (error) {
    case 0:
      return "real-time scheduling";
    case EPERM:
      return "no real-time scheduling: not permitted (an rtprio limit in "
             "/etc/security/limits.conf would allow it)";
    default:
      return "no real-time scheduling: the system refused";
  }
}

const char* memory_words(int error) {
  switch (error) {
    case 0:
      return "memory locked";
    case EPERM:
    case ENOMEM:
    case EAGAIN:
      return "memory not locked: not permitted (a memlock limit in /etc/security/limits.conf "
             "would allow it)";
    default:
      return "memory not locked: the system refused";
  }
}

}  // namespace

void name_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

RealTime request_real_time() noexcept {
  const int scheduling = schedule(SCHED_FIFO, priority);
  // What is mapped later is not asked for: where the limit is low, every allocation would fail.
  const int memory = mlockall(MCL_CURRENT) == 0 ? 0 : errno;
  return {.scheduled = scheduling == 0,
          .locked = memory == 0,
          .scheduling = scheduling_words(scheduling),
          .memory = memory_words(memory)};
}

bool request_precedence() noexcept {
  if (std::thread::hardware_concurrency() > 1) return schedule(SCHED_FIFO, priority / 2) == 0;
  constexpr int nice = -11;
  return setpriority(PRIO_PROCESS, 0, nice) == 0;  // of this thread alone, on Linux
}

Promptness::Promptness(bool wanted) noexcept {
  if (!wanted) return;
  if (std::thread::hardware_concurrency() <= 1) {
    words_ = "no real-time scheduling: there is a single processor";
    return;
  }
  const int error = schedule(SCHED_FIFO, priority - 1);
  granted_ = error == 0;
  if (!granted_) words_ = scheduling_words(error);
}

Promptness::~Promptness() {
  if (granted_) schedule(SCHED_OTHER, 0);
}

}  // namespace sonde
