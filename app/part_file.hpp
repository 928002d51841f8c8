// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/platform/writable_file.hpp"

namespace sonde::app {

/// The lines of a result while it is being computed, and a file beside it, RESULT.part, that holds
/// those that are finished, so that a run that was interrupted can go on from there. Its first line
/// says of which run it is. Each other line ends with a tab and a checksum of itself and all lines
/// before it: lines count up to the first that was changed, moved or cut off. One run at a time
/// writes it.
class PartFile {
 public:
  /// `result`: the file that the result will be; empty: lines are kept in memory alone. `run`: one
  /// line, the same for runs that may continue each other. `resume`: takes over the lines that
  /// count of a part that is there. Throws InputError where that is of another run, cannot be read,
  /// or another run writes it now.
  PartFile(const std::string& result, const std::string& run, bool resume);

  /// Whether a part was there: taken over by a run that resumes, otherwise to be written over.
  bool was_there() const { return was_there_; }
  const std::filesystem::path& file() const { return file_; }
  std::span<const std::string> lines() const { return lines_; }
  void add(std::string line) { lines_.push_back(std::move(line)); }
  /// Forgets the lines from this one on.
  void cut(std::size_t count) { lines_.resize(count); }
  /// Writes to the part what was added since. Throws InputError.
  void flush();
  /// The result is written: takes the part away.
  void done();

 private:
  void hold(WritableFile::Opening opening);
  void take_over();
  [[noreturn]] void fail_to_write(int error) const;

  std::filesystem::path file_;  // empty: there is none
  std::string run_;
  std::vector<std::string> lines_;
  std::string sum_;    // of the lines on the disk
  WritableFile part_;  // open while this run holds it
  std::size_t flushed_ = 0;
  bool was_there_ = false;
  bool ours_ = false;  // the part on the disk holds the first `flushed_` lines
};

}  // namespace sonde::app
