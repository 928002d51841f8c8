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
  std::size_t merged = 0;      ///< triangles of the soup that were merged into larger ones
  std::size_t duplicates = 0;  ///< triangles of the soup left out because they repeat others
};

/// Contacts must not depend on how finely a flat face is meshed, and a fine mesh costs time. So
/// neighbours in one plane are merged, and their union is triangulated from the corners of its
/// outline only. In one plane means within `flatness` (m) of it. Parts that are less flat stay as
/// they are, and so does everything where merging would save nothing. A repeated triangle stays
/// once in each orientation, as the two sides of a sheet; with `solid`, as often as keeps the
/// ratios of all winding numbers.
///
/// The order of the triangles only decides ties; the same soup gives the same facets. Throws
/// Cancelled.
Facets merge_flat(const Soup& soup, double flatness, bool solid, const Progress& progress = {});

/// The flatness for merge_flat in a soup: the rounding error of computed coordinates, m, and at
/// most 1e-11 of the soup's own size.
double rounding_flatness(const Soup& soup);

}  // namespace sonde
