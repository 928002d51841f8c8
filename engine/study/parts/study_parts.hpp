// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/progress.hpp"

namespace sonde {

/// A piece of a study that is independent of all others.
struct StudyPart {
  std::string name;  ///< of its file: letters, digits, '-', '_' and '.'
  /// Its result as JSON text: the same bits wherever and whenever it is computed, except for
  /// members named time_us.
  std::function<std::string(const Stop& stop)> compute;
  /// Of a part that takes long: how much of it is done, 0 to 1, set by `compute` before it asks
  /// whether to stop. Null: it does not say.
  std::shared_ptr<std::atomic<double>> done = nullptr;
};

/// A long computation as a list of independent parts and the data that joins their results. Its
/// folder holds `study.json`, which identifies the study, and `parts/NAME.json` for each finished
/// part. So a study can be stopped and continued, and split over machines.
struct Study {
  std::string kind;   ///< "tune", "traces", "compare", "trade"
  std::string about;  ///< JSON text that determines everything else: inputs, settings
  std::vector<StudyPart> parts;
};

/// The content of `study.json`, and the parts' results beside it.
struct StudyFolder {
  std::string kind;
  std::string about;
  std::vector<std::string> names;                   ///< of all parts, in order
  std::vector<std::optional<std::string>> results;  ///< of each part, if it is finished
  bool complete() const;
  StudyFolder finished() const;  ///< the same with the finished parts only
};

/// A final file of a study: its name in the folder, and its text.
struct StudyFile {
  std::string name;
  std::string text;
};

/// Parts index, index + count, index + 2 count, ... of a study, index from 0.
struct Shard {
  std::size_t index = 0;
  std::size_t count = 1;
};
/// "2/8": the second of eight. No value for anything else.
std::optional<Shard> shard_of(std::string_view text);

/// `done` parts of `total` in the shard are finished, and of those that are being computed and say
/// so, so much (in parts). One thread at a time.
using PartsProgress = std::function<void(std::size_t done, std::size_t total, double under_way)>;

/// Throws InputError if the folder holds other files and no study. Call it before a study is
/// planned, which may take long.
void refuse_other_things(const std::filesystem::path& folder);

/// Makes the folder the study's: writes its study.json. A folder with other parts of the same study
/// (the same kind and `about`) becomes the requested study and keeps its finished parts; if it is
/// finished and has all of them, it is not changed. Throws InputError if the folder holds another
/// study, or other files and no study, or cannot be written.
void claim_folder(const std::filesystem::path& folder, const Study& study);

/// Claims the folder, computes the parts of a shard that are not yet in it, on `threads` threads,
/// and writes each part, whole, as soon as it is finished. Throws as claim_folder does, Cancelled
/// if `stop` returns true (finished parts stay), and whatever a part throws.
void compute_parts(const std::filesystem::path& folder, const Study& study, Shard shard,
                   unsigned threads, const Stop& stop, const PartsProgress& progress = {});

/// The same in memory: all parts of a study that takes seconds, on `threads` threads. Throws
/// Cancelled, and whatever a part throws.
StudyFolder compute_at_once(const Study& study, unsigned threads, const Stop& stop);

/// Reads a folder. Throws InputError if it holds no study, or a file that is not the study's.
StudyFolder read_study(const std::filesystem::path& folder);

/// 64-bit FNV-1a of the text in 16 hexadecimal digits: only to distinguish inputs.
std::string fingerprint(std::string_view text);

}  // namespace sonde
