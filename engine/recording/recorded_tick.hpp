// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/recording/tick_columns.hpp"

namespace sonde {

/// Ticks as the content of a block, not compressed (clusters are made of the contacts again): the
/// table of ticks, that of their contacts, one tick's after the other's, the ids of their clusters,
/// and the reasons of those that failed.
std::string tick_content(std::span<const Snapshot> ticks);
/// The ticks again, of a probe of that radius, m. Throws std::invalid_argument.
std::vector<Snapshot> ticks_in(std::string_view content, double radius);

std::string search_content(std::span<const RecordedSearch> searches);
std::vector<RecordedSearch> searches_in(std::string_view content);

}  // namespace sonde
