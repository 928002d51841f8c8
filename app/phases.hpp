// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/result_table.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace CLI {
class App;
}

namespace sonde::app {

/// How an answer came about, in columns of their own, off unless asked for: what translations alone
/// came to, whether the last phase converged, and how many limits acted on the way.
struct PhaseOptions {
  bool wanted = false;
  bool with_converged = true;  ///< false where that is a column anyway
};
void add_flags(CLI::App& parser, PhaseOptions& options);

/// The columns, and those of the phases behind them, where they are wanted.
std::vector<Column> with_phases(const PhaseOptions& options, std::vector<Column> columns);
void append_phases(const PhaseOptions& options, Row& row, const Separation& answer);

}  // namespace sonde::app
