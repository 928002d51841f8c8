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

/// Writes a recording block by block in its own thread. After a kill the file can be read up to the
/// last whole block.
///
/// See also: ui/document/recorder.cpp feeds it. Each snapshot goes to a TickLog, which packs ticks
/// into blocks and passes a block on when it is full (TickLog::sealed). A writer of another format
/// belongs before that packing: it takes the snapshots that TickLog::add takes.
class RecordingWriter {
 public:
  /// Throws InputError where the file cannot be created.
  RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header);
  ~RecordingWriter();  ///< finishes it
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Returns at once. After a failure it writes nothing more.
  void add(BlockBytes block);
  /// Nothing more is added: the thread writes what is waiting and the last block, and sees to it
  /// that the disk has them. Returns at once.
  void close();
  /// All of that is done, or has failed.
  bool closed() const { return closed_.load(std::memory_order_acquire); }
  /// close(), and waits until then.
  void finish();
  /// Why the file ends early; none where it does not. The file holds all blocks before that, whole.
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
  std::atomic<std::uint64_t> bytes_{0};  ///< whole blocks
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<BlockBytes> waiting_;
  bool finishing_ = false;
  std::atomic<bool> closed_{false};
  std::optional<std::string> failure_;
  std::thread thread_;
};

/// A whole recording as the file of that name holds it. Throws InputError.
std::string recording_bytes(const std::filesystem::path& file, const RecordingHeader& header,
                            const TickLog& ticks);
/// Writes a whole recording at once, or nothing: from ticks that are all there. Throws InputError.
void write_recording(const std::filesystem::path& file, const RecordingHeader& header,
                     const TickLog& ticks);

}  // namespace sonde
