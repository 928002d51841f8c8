// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/progress.hpp"

namespace sonde {

/// A piece of a study that needs nothing of any other piece.
struct StudyPart {
  std::string name;  ///< of its file: letters, digits, '-', '_' and '.'
  /// Its result as JSON text: the same bits wherever and whenever it is computed, but for members
  /// named time_us.
  std::function<std::string(const Stop& stop)> compute;
};

/// A long computation as a list of independent parts and what is needed to join their results. In a
/// folder it is `study.json`, which says what study it is, and `parts/NAME.json` for each part that
/// is finished. So a study can be stopped and taken up again, and split over machines.
struct Study {
  std::string kind;   ///< "tune", "compare", "trade"
  std::string about;  ///< JSON text, on which all else depends: inputs, settings
  std::vector<StudyPart> parts;
};

/// What `study.json` says, and the parts' results that lie beside it.
struct StudyFolder {
  std::string kind;
  std::string about;
  std::vector<std::string> names;                   ///< of all parts, in order
  std::vector<std::optional<std::string>> results;  ///< of each, where it is finished
  bool complete() const;
};

/// A file of a study's end: its name in the folder, and its text.
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

/// `done` parts of `total` in the shard are finished.
using PartsProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Computes the parts of a shard that are not yet in the folder, on so many threads, and writes
/// each as soon as it is finished, whole. Makes the folder where there is none. One that holds
/// other parts of the same study (the same kind and `about`) becomes the study asked for and keeps
/// what is finished; where it is finished and has all of them, it stays as it is. Throws InputError
/// where it holds another study or cannot be written, Cancelled where `stop` says so (what is
/// finished stays), else what a part throws.
void compute_parts(const std::filesystem::path& folder, const Study& study, Shard shard,
                   unsigned threads, const Stop& stop, const PartsProgress& progress = {});

/// Reads a folder. Throws InputError where it holds no study, or a file that is none of its own.
StudyFolder read_study(const std::filesystem::path& folder);

/// 64-bit FNV-1a of the text in 16 hexadecimal digits: tells inputs apart, no more.
std::string fingerprint(std::string_view text);

}  // namespace sonde
