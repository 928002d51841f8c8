// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace sonde {

/// The least number of letters to insert, delete, replace or swap with a neighbour that turns one
/// word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to the given one; of two equally near, the longer. Empty if none is
/// known.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace sonde
