// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/penetration/contact/separation.hpp"

namespace sonde::app {

/// The room between two bodies, one continuous quantity, and where it is taken.
struct Room {
  std::optional<double> clearance;  ///< m; less than zero, by the depth, where they overlap
  std::optional<Vec3> on_fixed;     ///< there; where they overlap, of the contact that bears most
};

/// None where the bodies are apart and nobody has measured how far, or where the search failed.
Room room_of(const Separation& separation);

}  // namespace sonde::app
