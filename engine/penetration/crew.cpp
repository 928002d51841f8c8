// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/crew.hpp"

namespace sonde {

Crew::~Crew() {
  if (!other_.joinable()) return;
  over_ = true;
  ++asked_;
  asked_.notify_one();
  other_.join();
}

void Crew::each(std::size_t count, const Work& work) {
  work_ = &work;
  count_ = count;
  if (!two_threads_ || count < 2) {
    take_part(0);
    return take_part(1);
  }
  if (!other_.joinable()) other_ = std::thread([this] { help(); });
  const int call = ++asked_;
  asked_.notify_one();
  take_part(0);
  for (int done = answered_; done != call; done = answered_) answered_.wait(done);
}

void Crew::help() {
  for (int done = 0;;) {
    asked_.wait(done);
    done = asked_;
    if (over_) return;
    take_part(1);
    answered_ = done;
    answered_.notify_one();
  }
}

void Crew::take_part(std::size_t lane) {
  for (std::size_t k = lane; k < count_; k += 2) (*work_)(k, lane);
}

}  // namespace sonde
