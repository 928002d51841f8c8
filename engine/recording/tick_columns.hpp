// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/recording/columns.hpp"

namespace sonde {

/// A search that had ended by this time of the recording, s.
struct RecordedSearch {
  double time = 0;
  BackgroundResult result;
};

/// The stored columns of a tick. Device pose, depth, times and gains are stored exactly; the
/// separated pose as the motion from the device pose, and the wrench and the contacts to seven
/// digits. Reading these columns puts that motion into the separated pose (ticks_in() computes the
/// pose from it).
std::span<const Column<Snapshot>> tick_columns();
std::span<const Column<Contact>> contact_columns();
std::span<const Column<RecordedSearch>> search_columns();

}  // namespace sonde
