// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/thread_pair.hpp"

namespace sonde {

ThreadPair::~ThreadPair() {
  if (!other_.joinable()) return;
  other_lane_ = Lane::over;
  other_lane_.notify_one();
  other_.join();
}

void ThreadPair::each(std::size_t count, const Work& work) {
  work_ = &work;
  count_ = count;
  if (!two_threads_ || count < 2) {
    run_lane(0);
    return run_lane(1);
  }
  if (!other_.joinable()) other_ = std::thread([this] { help(); });
  other_lane_ = Lane::offered;
  other_lane_.notify_one();
  run_lane(0);
  Lane lane = Lane::offered;
  if (other_lane_.compare_exchange_strong(lane, Lane::idle)) return run_lane(1);
  other_lane_.wait(Lane::taken);
}

void ThreadPair::help() {
  for (;;) {
    Lane seen = Lane::offered;
    if (other_lane_.compare_exchange_strong(seen, Lane::taken)) {
      run_lane(1);
      other_lane_ = Lane::done;
      other_lane_.notify_one();
    } else if (seen == Lane::over) {
      return;
    } else {
      other_lane_.wait(seen);
    }
  }
}

void ThreadPair::run_lane(std::size_t lane) {
  for (std::size_t k = lane; k < count_; k += 2) (*work_)(k, lane);
}

}  // namespace sonde
