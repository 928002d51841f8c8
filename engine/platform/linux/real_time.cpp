// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/real_time.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

namespace sonde {
namespace {

/// Above all ordinary threads, below those that the system itself runs with real-time priority.
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

const char* memory_words(int error, bool later) {
  switch (error) {
    case 0:
      return later ? "memory locked"
                   : "memory locked, but not what comes later (a memlock limit of unlimited in "
                     "/etc/security/limits.conf would allow it)";
    case EPERM:
    case ENOMEM:
    case EAGAIN:
      return "memory not locked: not permitted (a memlock limit in /etc/security/limits.conf "
             "would allow it)";
    default:
      return "memory not locked: the system refused";
  }
}

/// Locks future pages when they are first used. Not requested if there is a limit, since an
/// allocation beyond it would fail.
bool lock_what_comes() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return false;
  return mlockall(MCL_FUTURE | MCL_ONFAULT) == 0;
}

}  // namespace

const char* request_processor(LoopThread thread) noexcept {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return "processor: the system does not say";
  int allowed[CPU_SETSIZE], count = 0;
  for (int i = 0; i < CPU_SETSIZE; ++i)
    if (CPU_ISSET(i, &set)) allowed[count++] = i;
  const int processor = processor_for(thread, allowed, count);
  if (processor < 0) return "shares its processor: there are not more than two";
  CPU_ZERO(&set);
  CPU_SET(processor, &set);
  return sched_setaffinity(0, sizeof set, &set) == 0 ? "a processor of its own"
                                                     : "shares its processor: the system refused";
}

void name_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

void stand_back() noexcept {
  constexpr int nice = 10;  // a tenth of the processor where others want it
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nice);
}

RealTime request_real_time() noexcept {
  const int scheduling = schedule(SCHED_FIFO, priority);
  const int memory = mlockall(MCL_CURRENT) == 0 ? 0 : errno;
  const bool later = memory == 0 && lock_what_comes();
  return {.scheduled = scheduling == 0,
          .locked = memory == 0,
          .scheduling = scheduling_words(scheduling),
          .memory = memory_words(memory, later),
          .processor = request_processor(LoopThread::servo)};
}

bool request_precedence() noexcept {
  if (std::thread::hardware_concurrency() > 1) return schedule(SCHED_FIFO, priority / 2) == 0;
  constexpr int nice = -11;
  return setpriority(PRIO_PROCESS, 0, nice) == 0;  // on Linux, for this thread only
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
