// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

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
  /// The clearance that was measured last, for the curves.
  void add(const GaugedClearance& clearance) { clearance_ = clearance; }

  /// Records the kept ticks and those that follow. Throws InputError where the file cannot be
  /// created.
  void record(const std::filesystem::path& file, const Scene& scene, const MeshMarks& meshes);
  /// Ends the recording. Its last blocks are written in its own thread: ended() tells when.
  void stop();
  /// A recording that has ended by now, each once.
  struct Ended {
    std::filesystem::path file;
    QString failure;  ///< why it ends early; empty where it does not
  };
  std::optional<Ended> ended();
  /// Puts the kept ticks up to now into blocks.
  void seal() {
    if (ticks_) ticks_->seal();
  }
  bool recording() const { return writer_ != nullptr; }
  /// The failure of the present recording. Empty: no failure so far.
  QString failure() const;
  /// Is a recording that was stopped still being written?
  bool ending() const { return !closing_.empty(); }

  /// Null before there is a session.
  const TickLog* ticks() const { return ticks_.get(); }
  const Curves& curves() const { return curves_; }

 private:
  std::unique_ptr<TickLog> ticks_;
  Curves curves_;
  std::optional<BackgroundResult> searched_;
  std::optional<GaugedClearance> clearance_;
  std::unique_ptr<RecordingWriter> writer_;
  std::vector<std::unique_ptr<RecordingWriter>> closing_;
};

}  // namespace sonde::ui
