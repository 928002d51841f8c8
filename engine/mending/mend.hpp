// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/model.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mending/repair_places.hpp"
#include "engine/mending/repairs.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// The role of a triangle of a mended soup.
enum class TriangleKind : std::uint8_t {
  bounds,  ///< it bounds the inside
  loose,   ///< can be touched, but bounds nothing: of a sheet, a vessel, a part with one side
  cap,     ///< added to close an opening; bounds the inside
  hidden   ///< it lies inside, where nothing can touch it, and is left out
};

/// A mended soup, whose inside is known.
struct Mended {
  /// The triangles used for contact, with the role of each: those of the soup in their order,
  /// turned if their orientation was wrong, without backs; then caps. The vertices are those of the
  /// soup.
  std::vector<Triangle> triangles;
  std::vector<TriangleKind> kinds;
  std::vector<std::uint32_t> parts;  ///< for each triangle: its part, or no_part
  static constexpr std::uint32_t no_part = std::numeric_limits<std::uint32_t>::max();
  /// For each triangle, whether it is one of a pair that cancels with the outside on both sides: of
  /// a sheet that is there both ways round, at a solid.
  std::vector<bool> fins;
  /// The closed parts whose inside counts, for mass (Region); empty if the body is a surface.
  Sealed solid;
  /// Cracks and cuts are closed by index only: a ray may slip through between the triangles.
  bool cracked = false;
  bool as_given = true;  ///< the triangles are the soup's own, unturned, in their order
  std::string why;       ///< why it is a solid or a surface
  /// Triangles of cavities with nothing on either side, as across the mouth of a pocket that is a
  /// shell of its own: there is no material, but they are walls, as all triangles.
  std::size_t lids = 0;
  Repairs repairs;
  RepairPlaces places;  ///< all except the hidden triangles; sort_and_cap() has not been called
};

/// Joins, turns and caps a soup until every part of it is closed, and decides for each part whether
/// its inside counts: with Model::automatic if it looks solid (PartFacts), with Model::solid if it
/// bounds any inside. `soup` has one vertex for each place; its degenerate triangles still connect
/// others. `topology` is that of `soup`. Throws InputError, naming `name`, if `asked` is solid and
/// no part has an inside; throws Cancelled.
Mended mend(const Soup& soup, const Topology& topology, Model asked, const std::string& name,
            const Progress& progress = {});

}  // namespace sonde
