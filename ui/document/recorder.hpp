// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "engine/recording/curves.hpp"
#include "engine/recording/recording_writer.hpp"
#include "engine/recording/tick_log.hpp"

namespace sonde::ui {

/// Always keeps the last ten minutes of a session, in at most 200 MB. On request it writes them and
/// everything that follows to a file. It runs on the window's thread; the file has its own thread.
class Recorder {
 public:
  static constexpr double seconds = 600;
  static constexpr std::size_t most_bytes = 200'000'000;

  /// Starts over for another probe. A recording ends.
  void begin(double probe_radius, double rate_hz);
  void add(const Snapshot& tick);
  void add(const BackgroundResult& search);

  /// Records the kept ticks and those that follow. Throws InputError where the file cannot be
  /// created.
  void record(const std::filesystem::path& file, const Scene& scene);
  /// Ends the recording: waits until the last block is written. Returns why it failed; empty where
  /// it did not.
  QString stop();
  /// Puts the kept ticks up to now into blocks.
  void seal() {
    if (ticks_) ticks_->seal();
  }
  bool recording() const { return writer_ != nullptr; }
  /// The failure of the present recording. Empty: no failure so far.
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
