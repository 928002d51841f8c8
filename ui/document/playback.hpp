// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "engine/recording/tick_log.hpp"
#include "ui/document/instant.hpp"

namespace sonde::ui {

/// A tick of a log as it looked then. Throws InputError where the file no longer holds it.
Instant recorded_instant(const TickLog& ticks, std::uint64_t index);

/// The position of a user who looks back over kept ticks: at one of them, or playing.
class Playback {
 public:
  static constexpr double slowest = 0.01, fastest = 4;

  /// Looks at these ticks, at the last one. They must outlive this object, or the next call. Null:
  /// none.
  void look_at(const TickLog* ticks);
  bool looking() const { return ticks_ != nullptr && !ticks_->empty(); }
  const TickLog* ticks() const { return ticks_; }

  /// s; to the nearest there is.
  void seek(double time);
  void step(std::int64_t ticks);
  /// Of the present tick: the oldest one kept, where the one looked at has been forgotten since.
  std::uint64_t index() const { return looking() ? std::max(index_, ticks_->begin()) : 0; }
  double time() const { return time_; }

  /// At the end it starts again.
  void play(bool on);
  bool playing() const { return playing_; }
  void set_speed(double speed);  ///< clamped to the range; NaN changes nothing
  double speed() const { return speed_; }
  void set_loop(bool on) { loop_ = on; }
  bool loop() const { return loop_; }
  /// Advances by that many seconds. False where nothing moves.
  bool advance(double seconds);

  /// The present tick. Throws InputError where the file no longer holds it.
  Instant instant() const;

 private:
  const TickLog* ticks_ = nullptr;
  std::uint64_t index_ = 0;
  double time_ = 0;  ///< s; between two ticks while it plays slowly
  double speed_ = 1;
  bool playing_ = false;
  bool loop_ = false;
};

}  // namespace sonde::ui
