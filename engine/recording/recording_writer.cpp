// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording_writer.hpp"

#include <stdexcept>
#include <system_error>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/base/threads.hpp"
#include "engine/text/output_file.hpp"

namespace sonde {
namespace {

std::string system_reason(int error) {
  return "cannot be written: " + std::generic_category().message(error);
}

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header)
    : file_(file) {
  open_ = create_anew(file);  // the ticks to come may be those of the recording it replaces
  thread_ = std::thread([this, header] { run(header); });
}

RecordingWriter::~RecordingWriter() { finish(); }

void RecordingWriter::add(BlockBytes block) {
  const std::scoped_lock lock(mutex_);
  if (failure_ || finishing_) return;
  waiting_.push_back(std::move(block));
  news_.notify_one();
}

void RecordingWriter::close() {
  const std::scoped_lock lock(mutex_);
  finishing_ = true;
  news_.notify_one();
}

void RecordingWriter::finish() {
  close();
  if (thread_.joinable()) thread_.join();
}

std::optional<std::string> RecordingWriter::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

/// The next block to write. None: all is written.
std::optional<BlockBytes> RecordingWriter::next() {
  std::unique_lock lock(mutex_);
  news_.wait(lock, [this] { return finishing_ || !waiting_.empty(); });
  if (waiting_.empty()) return {};
  BlockBytes block = std::move(waiting_.front());
  waiting_.pop_front();
  return block;
}

void RecordingWriter::run(const RecordingHeader& header) {
  name_thread("sonde-record");
  try {
    write(header_bytes(header, file_));
    while (const std::optional<BlockBytes> block = next()) {
      const std::string bytes = (*block)();
      const BlockHead head = head_of(bytes);
      if (head.kind == BlockKind::ticks) ticks_ += head.rows;
      write(bytes);
    }
    write(end_block(ticks_));
    if (!open_.sync()) throw InputError::in(file_.string(), system_reason(open_.error()));
  } catch (const std::exception& bad) {
    const std::scoped_lock lock(mutex_);
    failure_ = bad.what();
    waiting_.clear();
  }
  closed_.store(true, std::memory_order_release);
}

/// Writes all bytes or nothing.
void RecordingWriter::write(const std::string& bytes) {
  if (!open_.write(bytes)) {
    // What is left of a block is cut off; a file that cannot be cut can be read all the same.
    open_.truncate(bytes_.load(std::memory_order_relaxed));
    throw InputError::in(file_.string(), system_reason(open_.error()));
  }
  bytes_.fetch_add(bytes.size(), std::memory_order_relaxed);
}

std::string recording_bytes(const std::filesystem::path& file, const RecordingHeader& header,
                            const TickLog& ticks) {
  std::string bytes = header_bytes(header, file);
  for (const BlockBytes& block : ticks.all()) bytes += block();
  bytes += end_block(ticks.end() - ticks.begin());
  return bytes;
}

void write_recording(const std::filesystem::path& file, const RecordingHeader& header,
                     const TickLog& ticks) {
  write_whole(file, recording_bytes(file, header, ticks));
}

}  // namespace sonde
