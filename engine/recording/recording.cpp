// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "engine/platform/readable_file.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

/// The bytes of the header, or what there is of them.
std::string header_bytes_of(const ReadableFile& file) {
  constexpr std::size_t fixed_size = 20, most = 1u << 24;
  std::string bytes = file.read(0, fixed_size);
  if (bytes.size() == fixed_size) {
    std::string_view rest = std::string_view(bytes).substr(12);
    bytes = file.read(0, fixed_size + std::min<std::size_t>(most, take_count(rest)));
  }
  return bytes;
}

/// Reads the blocks from `offset` on. It records why there are no more; empty at the end of a whole
/// recording.
class BlockReader {
 public:
  BlockReader(Recording& into, std::shared_ptr<const ReadableFile> file)
      : into_(into), file_(std::move(file)) {}

  /// Returns false if there is no more, with the reason in `cut`.
  bool next() {
    try {
      return read_one();
    } catch (const std::invalid_argument& bad) {
      return stop(bad.what());
    }
  }

 private:
  bool stop(const std::string& reason) {
    into_.cut = "byte " + std::to_string(into_.readable) + ": " + reason;
    return false;
  }

  bool read_one() {
    const std::uint64_t at = into_.readable;
    const std::string first = file_->read(at, BlockHead::size);
    if (first.empty()) return stop("it ends without its last block");
    const BlockHead head = head_of(first);
    const std::size_t size = BlockHead::size + head.packed;
    const std::string bytes = file_->read(at, size);
    if (bytes.size() < size) return stop("it ends within a block");
    if (!is_sound(head, bytes)) return stop("the checksum of a block is wrong");
    if (head.kind == BlockKind::end) return end(at + size);
    if (head.kind == BlockKind::searches)
      add_searches(searches_in(content_of(head, bytes)));
    else
      add_ticks(head, at, size);
    into_.readable = at + size;
    return true;
  }

  void add_searches(const std::vector<RecordedSearch>& searches) {
    const auto& all = into_.ticks.searches();
    double before = all.empty() ? -std::numeric_limits<double>::infinity() : all.back().time;
    for (const RecordedSearch& search : searches) {
      if (!std::isfinite(search.time) || search.time < before)
        throw std::invalid_argument("the time of a search is not finite, or falls");
      before = search.time;
    }
    for (const RecordedSearch& search : searches) into_.ticks.add(search);
  }

  void add_ticks(const BlockHead& head, std::uint64_t at, std::size_t size) {
    if (!into_.ticks.empty() && head.first < into_.ticks.last_time())
      throw std::invalid_argument("a block begins before the one ahead of it ends");
    into_.ticks.add(
        head, [file = file_, at, size] { return file->read(at, size); },
        into_.file.string() + ": byte " + std::to_string(at));
  }

  bool end(std::uint64_t at) {
    into_.readable = at;
    if (at < into_.bytes) stop("there is more after its last block");
    return false;
  }

  Recording& into_;
  std::shared_ptr<const ReadableFile> file_;
};

}  // namespace

std::unique_ptr<Recording> read_recording(const fs::path& file, const Progress& progress) {
  const auto open = std::make_shared<const ReadableFile>(file);
  ReadHeader read = read_header(header_bytes_of(*open), file);
  const double radius = read.header.probe_radius, rate = read.header.rate_hz;
  auto recording = std::make_unique<Recording>(Recording{.file = file,
                                                         .header = std::move(read.header),
                                                         .ticks = TickLog(radius, rate),
                                                         .bytes = open->size(),
                                                         .readable = read.size});
  recording->ticks.along_path = recording->header.along_path;
  for (BlockReader blocks(*recording, open); blocks.next();)
    if (progress &&
        !progress(static_cast<double>(recording->readable) / static_cast<double>(recording->bytes)))
      throw Cancelled();
  return recording;
}

std::vector<fs::path> recorded_paths_out_of(const fs::path& folder, const fs::path& recording) {
  const std::string bytes = header_bytes_of(ReadableFile(recording));
  return paths_out_of(folder, recorded_scene_text(bytes, recording), recording);
}

}  // namespace sonde
