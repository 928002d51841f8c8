// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/platform/writable_file.hpp"
#include "engine/recording/recording_header.hpp"
#include "engine/recording/tick_log.hpp"

namespace sonde {

/// Writes a recording block by block in its own thread. If the program is killed, the file can be
/// read up to the last whole block.
///
/// ui/document/recorder.cpp feeds it. Each snapshot goes to a TickLog, which packs ticks into
/// blocks and passes each full block on (TickLog::sealed). A writer of another format belongs
/// before that packing: it would take the same snapshots as TickLog::add.
class RecordingWriter {
 public:
  /// Throws InputError if the file cannot be created.
  RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header);
  ~RecordingWriter();  ///< finishes the recording
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Returns immediately. After a failure nothing more is written.
  void add(BlockBytes block);
  /// Call it when nothing more will be added: the thread writes the waiting blocks and the last
  /// one, and syncs the file to disk. Returns immediately.
  void close();
  /// Whether all of that is done, or has failed.
  bool closed() const { return closed_.load(std::memory_order_acquire); }
  /// close(), and waits until closed().
  void finish();
  /// Why the file ends early; none if it does not. The file contains all blocks before that, whole.
  std::optional<std::string> failure() const;
  std::uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }
  const std::filesystem::path& file() const { return file_; }

 private:
  void run(const RecordingHeader& header);
  void write(const std::string& bytes);
  std::optional<BlockBytes> next();

  std::filesystem::path file_;
  WritableFile open_;
  std::uint64_t ticks_ = 0;
  std::atomic<std::uint64_t> bytes_{0};  ///< in whole blocks
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<BlockBytes> waiting_;
  bool finishing_ = false;
  std::atomic<bool> closed_{false};
  std::optional<std::string> failure_;
  std::thread thread_;
};

/// The bytes of a whole recording for a file of that name. Throws InputError.
std::string recording_bytes(const std::filesystem::path& file, const RecordingHeader& header,
                            const TickLog& ticks);
/// Writes a whole recording, or nothing, from a complete log. Throws InputError.
void write_recording(const std::filesystem::path& file, const RecordingHeader& header,
                     const TickLog& ticks);

}  // namespace sonde
