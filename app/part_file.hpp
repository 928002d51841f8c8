// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sonde::app {

/// The lines of a result while it is being computed, and a file beside it, RESULT.part, that holds
/// those that are finished, so that a run that was interrupted can go on from there. Its first line
/// says of which run it is.
class PartFile {
 public:
  /// `result`: the file that the result will be; empty: lines are kept in memory alone. `run`: one
  /// line, the same for runs that may continue each other. `resume`: takes over the whole lines of
  /// a part that is there. Throws InputError where that is of another run, or cannot be read.
  PartFile(const std::string& result, const std::string& run, bool resume);

  /// Whether there was a part to take over.
  bool was_there() const { return was_there_; }
  std::span<const std::string> lines() const { return lines_; }
  void add(std::string line) { lines_.push_back(std::move(line)); }
  /// Forgets the lines from this one on.
  void cut(std::size_t count) { lines_.resize(count); }
  /// Writes to the part what was added since. Throws InputError.
  void flush();
  /// The result is written: takes the part away.
  void done();

 private:
  std::filesystem::path file_;  // empty: none
  std::string run_;
  std::vector<std::string> lines_;
  std::size_t flushed_ = 0;
  bool was_there_ = false;
  bool ours_ = false;  // the part on the disk holds the first `flushed_` lines
};

}  // namespace sonde::app
