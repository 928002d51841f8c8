// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Where a file may name its unit, though its format has none.
enum class UnitPlace {
  comments,    ///< of a text: lines that begin with '#', before much else
  ply_header,  ///< its lines "comment" and "obj_info"
  stl_header,  ///< the 80 bytes of a binary file, or the first line of a text
};

/// Adds a remark where a file names the unit of its numbers ("units: mm", "UNITS=mm") and they were
/// multiplied by that of another one. The remark changes nothing: such words are no part of the
/// format, and may be left over from another program. `scale`: what the numbers of the file were
/// multiplied by; where that is no unit, the caller knows what the numbers are, and there is no
/// remark.
void remark_on_unit(PolygonSoup& soup, UnitPlace place, std::string_view bytes, double scale);

}  // namespace sonde
