// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/playback.hpp"

#include <algorithm>
#include <cmath>

namespace sonde::ui {

Instant recorded_instant(const TickLog& ticks, std::uint64_t index) {
  const Snapshot tick = ticks.at(index);
  const RecordedSearch* search = ticks.searched(tick.time);
  return instant_of(tick, search ? &search->result : nullptr, false);
}

void Playback::look_at(const TickLog* ticks) {
  ticks_ = ticks;
  playing_ = false;
  if (looking()) seek(ticks_->last_time());
}

void Playback::seek(double time) {
  if (!looking()) return;
  time_ = std::clamp(time, ticks_->first_time(), ticks_->last_time());
  index_ = ticks_->find(time_);
}

void Playback::step(std::int64_t ticks) {
  if (!looking()) return;
  playing_ = false;
  const auto first = static_cast<std::int64_t>(ticks_->begin());
  const auto last = static_cast<std::int64_t>(ticks_->end()) - 1;
  index_ = static_cast<std::uint64_t>(
      std::clamp(static_cast<std::int64_t>(index()) + ticks, first, last));
  time_ = ticks_->at(index_).time;
}

void Playback::play(bool on) {
  playing_ = on && looking();
  if (playing_ && time_ >= ticks_->last_time()) seek(ticks_->first_time());
}

void Playback::set_speed(double speed) {
  if (!std::isnan(speed)) speed_ = std::clamp(speed, slowest, fastest);
}

bool Playback::advance(double seconds) {
  if (!playing_ || !looking()) return false;
  const double next = time_ + speed_ * seconds;
  if (next < ticks_->last_time()) {
    seek(next);
    return true;
  }
  if (!loop_) playing_ = false;
  seek(loop_ ? ticks_->first_time() : ticks_->last_time());
  return true;
}

Instant Playback::instant() const { return recorded_instant(*ticks_, index()); }

}  // namespace sonde::ui
