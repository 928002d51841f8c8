// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The surface of a soup in as few triangles as its flat parts need.
struct Facets {
  /// The same set of points as the soup's triangles, to the flatness below. Its vertices are
  /// vertices of the soup.
  Soup soup;
  /// For each of its triangles, one of the soup's triangles that it covers partly or wholly; the
  /// two are connected.
  std::vector<std::uint32_t> from;
  std::size_t merged = 0;      ///< triangles of the soup that are in larger ones now
  std::size_t duplicates = 0;  ///< triangles of the soup left out, since they repeat others
};

/// How finely a flat face is cut must not matter to contacts, and a fine cut costs time. So
/// neighbours that lie in one plane are joined, and their union is triangulated from the corners of
/// its outline alone. In one plane means within `flatness` (m) of it. Larger parts that are less
/// flat stay as they are, and so does everything where joining would save nothing. A triangle that
/// is repeated stays once in either orientation, as the two sides of a sheet; with `solid`, as
/// often as leaves every winding number in proportion.
///
/// The order of the triangles decides only ties; the same soup gives the same facets. Throws
/// Cancelled.
Facets merge_flat(const Soup& soup, double flatness, bool solid, const Progress& progress = {});

/// The flatness for merge_flat in a soup: the rounding of coordinates that were computed, m, and
/// never more than 1e-11 of the soup's own size.
double rounding_flatness(const Soup& soup);

}  // namespace sonde
