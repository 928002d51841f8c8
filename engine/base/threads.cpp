// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/threads.hpp"

#include <exception>
#include <thread>

#include "engine/base/progress.hpp"

namespace sonde {

void run_both(bool two_threads, const Progress& progress, const Part& here, const Part& there) {
  if (!two_threads) {
    here(part_of(progress, 0, 0.5));
    there(part_of(progress, 0.5, 1));
    return;
  }
  std::exception_ptr fault;
  {
    std::jthread other([&](const std::stop_token& stop) {
      try {
        there([&stop](double) { return !stop.stop_requested(); });
      } catch (...) {
        fault = std::current_exception();
      }
    });
    here(progress);  // on an exception the thread is asked to stop, and joined
    other.join();
  }
  if (fault) std::rethrow_exception(fault);
}

}  // namespace sonde
