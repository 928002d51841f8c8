// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/recording/tick_columns.hpp"

namespace sonde {

/// Ticks as the uncompressed content of a block (clusters are recomputed from the contacts): the
/// table of ticks, that of their contacts in the order of the ticks, the ids of their clusters, and
/// the reasons of failures.
std::string tick_content(std::span<const Snapshot> ticks);
/// The ticks of such a content, for a probe of that radius, m. Throws std::invalid_argument.
std::vector<Snapshot> ticks_in(std::string_view content, double radius);

std::string search_content(std::span<const RecordedSearch> searches);
std::vector<RecordedSearch> searches_in(std::string_view content);

}  // namespace sonde
