// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "engine/recording/curves.hpp"
#include "engine/recording/recording_writer.hpp"
#include "engine/recording/tick_log.hpp"

namespace sonde::ui {

/// Keeps the last ten minutes of a session, always, in at most 200 MB, and writes them to a file
/// with all that follows while it is asked to. On the window's thread; the file has one of its own.
class Recorder {
 public:
  static constexpr double seconds = 600;
  static constexpr std::size_t most_bytes = 200'000'000;

  /// Begins anew, for another probe. A recording ends.
  void begin(double probe_radius, double rate_hz);
  void add(const Snapshot& tick);
  void add(const BackgroundResult& search);

  /// Records what is kept and what comes. Throws InputError where the file cannot be made.
  void record(const std::filesystem::path& file, const Scene& scene);
  /// Ends the recording: waits until the last is written. Why it failed; empty where it did not.
  QString stop();
  /// What is kept is in blocks up to now.
  void seal() {
    if (ticks_) ticks_->seal();
  }
  bool recording() const { return writer_ != nullptr; }
  /// Of the recording under way. Empty: all went well so far.
  QString failure() const;
  const RecordingWriter* writer() const { return writer_.get(); }

  /// Null before there is a session.
  const TickLog* ticks() const { return ticks_.get(); }
  const Curves& curves() const { return curves_; }

 private:
  std::unique_ptr<TickLog> ticks_;
  Curves curves_;
  std::optional<BackgroundResult> searched_;
  std::unique_ptr<RecordingWriter> writer_;
};

}  // namespace sonde::ui
