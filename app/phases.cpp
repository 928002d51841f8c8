// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/phases.hpp"

#include <CLI/CLI.hpp>

namespace sonde::app {

void add_flags(CLI::App& parser, PhaseOptions& options) {
  parser.add_flag("--phases", options.wanted,
                  "columns that say how an answer came about: the depth by translation alone "
                  "(pdt), converged, and how many limits acted on the way (limited)");
}

std::vector<Column> with_phases(const PhaseOptions& options, std::vector<Column> columns) {
  if (!options.wanted) return columns;
  columns.push_back({"pdt", "m"});
  if (options.with_converged) columns.push_back({"converged", ""});
  columns.push_back({"limited", ""});
  return columns;
}

void append_phases(const PhaseOptions& options, Row& row, const Separation& answer) {
  if (!options.wanted) return;
  if (answer.status == Status::failed) return append_nothing(row, options.with_converged ? 3 : 2);
  row.push_back(answer.pdt ? Cell(*answer.pdt) : Cell());
  if (options.with_converged) row.push_back(std::int64_t{answer.converged});
  row.push_back(std::int64_t{answer.limited});
}

}  // namespace sonde::app
