// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/recording/columns.hpp"

namespace sonde {

/// A search that had ended by a time of the recording, s.
struct RecordedSearch {
  double time = 0;
  BackgroundResult result;
};

/// What is kept of a tick: device pose, depth, times and gains to the bit; the separated pose as
/// the motion from the device pose, wrench and contacts to seven digits. Clusters are made of the
/// contacts again.
std::span<const Column<Snapshot>> tick_columns();
std::span<const Column<Contact>> contact_columns();
std::span<const Column<RecordedSearch>> search_columns();

/// Ticks as the content of a block, not compressed: the table of ticks, that of their contacts, one
/// tick's after the other's, the ids of their clusters, and the reasons of those that failed.
std::string tick_content(std::span<const Snapshot> ticks);
/// The ticks again, of a probe of that radius, m. Throws std::invalid_argument.
std::vector<Snapshot> ticks_in(std::string_view content, double radius);

std::string search_content(std::span<const RecordedSearch> searches);
std::vector<RecordedSearch> searches_in(std::string_view content);

}  // namespace sonde
