// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/offset/fans.hpp"
#include "engine/offset/move_faces.hpp"

namespace sonde {

/// Where a solid is too thin to be taken smaller.
struct ThinPlace {
  double thickness = 0;    ///< m, from one side of the material to the other
  Vec3 at = Vec3::Zero();  ///< on one of them, mesh frame
};

/// The thinnest place found of those where the solid, its faces moved inwards, is inside out or
/// goes through itself where it did not before; none where it does neither. Two parts that fill
/// space each by itself may go through each other as they like: they are one to begin with. The
/// soup is the body's, or that without walls inside; the fans are its. Throws Cancelled.
std::optional<ThinPlace> find_thin_place(const Body& nominal, const Soup& soup, const Fans& fans,
                                         const MovedFaces& moved, const Progress& progress = {});

}  // namespace sonde
