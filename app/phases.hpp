// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "app/result_table.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace CLI {
class App;
}

namespace sonde::app {

/// How an answer came about, off unless asked for: in columns of their own, what translations alone
/// came to, whether the last phase converged, how many limits acted on the way, and the time of
/// each phase; in a picture, these times.
struct PhaseOptions {
  bool columns = false;
  bool with_converged = true;  ///< false where that is a column anyway
  std::string picture = {};    ///< a file, NAME.svg; empty: none

  bool timed() const { return columns || !picture.empty(); }
};
void add_flags(CLI::App& parser, PhaseOptions& options);

/// The columns, and those of the phases behind them, where they are wanted.
std::vector<Column> with_phases(const PhaseOptions& options, std::vector<Column> columns);
void append_phases(const PhaseOptions& options, Row& row, const Separation& answer);

/// Refuses, before any work, a picture that cannot be written, or that is an input or the result.
void check_picture(const PhaseOptions& options, const OutputOptions& output,
                   const std::vector<std::filesystem::path>& others);

/// Collects where the time of answers went, for a picture.
class PhasePicture {
 public:
  /// `time_us`: of the whole answer.
  void add(const Separation& answer, double time_us);
  /// Of all answers, of those that penetrate, and of the slowest of them: the mean time of each
  /// phase. `what` names an answer in the plural: "ticks".
  std::string svg(const std::string& what) const;
  /// Writes the result with the picture, where one is wanted: both, or neither.
  void write_with(const PhaseOptions& options, const std::string& what, const OutputOptions& output,
                  const std::string& result) const;

 private:
  struct Answer {
    double time_us;
    bool penetrates;
    PhaseTimes phases;
  };
  std::vector<Answer> answers_;
};

}  // namespace sonde::app
