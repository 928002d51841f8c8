// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/recording/recording_header.hpp"
#include "engine/recording/tick_log.hpp"

namespace sonde {

/// A recording that was read: every block's checksum is verified, and ticks are read from the file
/// on demand.
struct Recording {
  std::filesystem::path file;
  RecordingHeader header;
  TickLog ticks;
  std::uint64_t bytes = 0;  ///< of the file
  /// The end of the last whole block, and why the file is not read beyond it; empty if the
  /// recording is whole. A program that was killed leaves a recording that is not whole.
  std::uint64_t readable = 0;
  std::string cut = {};
};

/// Throws InputError, naming the file, the byte and the reason, if there is no readable header; and
/// Cancelled. A recording that is truncated or damaged later is read up to there; `cut` gives the
/// reason.
std::unique_ptr<Recording> read_recording(const std::filesystem::path& file,
                                          const Progress& progress = {});

/// The files that the recorded scene names outside a folder; see paths_out_of (scene.hpp). None of
/// them is read, and only the header of the recording. Throws as read_recording does.
std::vector<std::filesystem::path> recorded_paths_out_of(const std::filesystem::path& folder,
                                                         const std::filesystem::path& recording);

}  // namespace sonde
