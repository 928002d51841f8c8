// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/recording/tick_log.hpp"
#include "ui/document/instant.hpp"

namespace sonde::ui {

/// Where somebody is who looks back over ticks that were kept: at one of them, or moving on.
class Playback {
 public:
  static constexpr double slowest = 0.01, fastest = 4;

  /// Looks at these ticks, at the last one; they must outlive this, or another call. Null: at none.
  void look_at(const TickLog* ticks);
  bool looking() const { return ticks_ != nullptr && !ticks_->empty(); }
  const TickLog* ticks() const { return ticks_; }

  /// s; to the nearest there is.
  void seek(double time);
  void step(std::int64_t ticks);
  std::uint64_t index() const { return index_; }
  double time() const { return time_; }

  /// At the end it begins anew.
  void play(bool on);
  bool playing() const { return playing_; }
  void set_speed(double speed);  ///< brought into the range; NaN changes nothing
  double speed() const { return speed_; }
  void set_loop(bool on) { loop_ = on; }
  bool loop() const { return loop_; }
  /// So many seconds have passed. False where nothing moves.
  bool advance(double seconds);

  /// Of the tick it is at. Throws InputError where a file holds it no more.
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
