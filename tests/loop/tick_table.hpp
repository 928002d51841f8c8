// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/penetration/contact/separation.hpp"
#include "tests/loop/tick_cases.hpp"

namespace sonde::ticks {

struct Tick {
  double us = 0;  ///< processor time
  Separation separation;
};

/// Head of the table, in Markdown. Times are µs.
std::string table_head();

/// Its row of one case. Beside times and counts: of a flat contact the largest ratio of tangential
/// to normal force; the least force along TickCase::up, below zero where the probe is held back;
/// and in percent of the largest energy stored the net work on the hand (below zero: it gave more
/// than it got) and what was lost of it in ticks that reported no jump. Both are zero on a path so
/// slow that the force is even between two ticks. Forces are those of the object norm, without
/// limits.
std::string table_row(const TickCase& c, const std::vector<Tick>& ticks);

/// The ticks one by one. Throws where the file cannot be written.
void write_csv(const std::string& file, const TickCase& c, const std::vector<Tick>& ticks);

}  // namespace sonde::ticks
