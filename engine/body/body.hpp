// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/body/tree.hpp"
#include "engine/geometry/face_offset.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/geometry/model.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mending/repair_places.hpp"
#include "engine/mending/repairs.hpp"

namespace sonde {

struct Body;

/// A part of a body that was joined of several, with its pose in the body's mesh frame.
struct BodyPart {
  std::string name;
  std::shared_ptr<const Body> body;
  Pose X_BP;
};

/// A body, built once and immutable: its triangles, mass properties and bounding volume tree, all
/// in the mesh frame. No two vertices are at the same place, and each vertex is a corner of a
/// triangle.
struct Body {
  std::string name;
  Soup soup;
  /// The body has an interior (winding number of the triangles that are not loose ≠ 0); otherwise
  /// only its triangles count.
  bool solid = false;
  std::string why;  ///< "closed", "12 open edges: the inside does not count", ...
  /// Which mass was taken and why, where it has open parts beside closed ones ("by area: 97 % of
  /// the area belongs to open parts"); empty otherwise.
  std::string mass_why;
  bool turned = false;  ///< the whole mesh was inside out, and has been turned
  Repairs repairs;      ///< repairs that gave it an inside
  RepairPlaces places;  ///< places of the repairs
  /// Oddities of its file that did not prevent reading, a sentence each (PolygonSoup::remarks).
  std::vector<std::string> remarks;
  /// A ray may slip through between triangles whose corners were only joined by index. Winding
  /// numbers are then counted along whole lines, which reveals that.
  bool cracked = false;
  /// If cracked: the same surface with one corner where several are joined, and with sides cut at
  /// corners that lie on them; used to offset its faces.
  Soup joined;
  Soup caps;  ///< the triangles that close openings, a copy of those in `soup`, for display
  std::size_t degenerate = 0;  ///< triangles removed because they have no area
  Topology topology;           ///< including the degenerate triangles
  /// The first triangle of surface(body) in each connected component.
  std::vector<std::uint32_t> component_triangle;
  MassProperties mass;
  /// The offset of its faces from those of its mesh. The mass is still the mesh's (except for R).
  FaceOffset offset;
  /// The surface in as few triangles as its flat parts need (facets.hpp). Empty if the soup already
  /// has no more.
  Soup facets;
  std::size_t merged = 0;      ///< triangles of the soup that are parts of larger ones in `facets`
  std::size_t duplicates = 0;  ///< triangles of the soup that `facets` leaves out as repeated
  Tree tree;                   ///< over surface(body)
  /// For each triangle of surface(body), whether it bounds nothing: it belongs to a sheet beside a
  /// solid. Empty if all of them bound the inside, or if there is none.
  std::vector<bool> loose;
  /// The same body, with its mass, in about outline_triangles triangles: an approximation that
  /// guides searches. None if the body itself has few triangles.
  std::shared_ptr<const Body> outline;
  /// The parts that it was joined of; empty if it has a single mesh.
  std::vector<BodyPart> parts;
};
constexpr std::size_t outline_triangles = 1000;

/// The triangles used for contact, in the order of the tree's leaves: every query works on these.
inline const Soup& surface(const Body& body) {
  return body.facets.triangles.empty() ? body.soup : body.facets;
}

/// Whether a triangle of surface(body) bounds nothing.
inline bool is_loose(const Body& body, std::uint32_t triangle) {
  return !body.loose.empty() && body.loose[triangle];
}

/// The outline of a body, or the body itself if it has none.
inline const Body& roughly(const Body& body) { return body.outline ? *body.outline : body; }

/// Builds a body. With `asked` solid, throws InputError if the mesh bounds no inside (with
/// Repair::none: if it is not closed). With automatic, falls back to surface and gives the reason.
/// A closed mesh whose volume is indistinguishable from zero (flat) is a surface. Throws InputError
/// if no triangle has an area.
std::shared_ptr<const Body> make_body(const PolygonSoup& polygons, Model asked,
                                      const std::string& name, const Progress& progress = {},
                                      Repair repair = Repair::automatic);

/// The same body with its surface offset by `offset`: name, model and mass stay, R is that of the
/// new surface. The soup must be as that of a body: one vertex for each place, no degenerate
/// triangle. `caps`: those of its triangles that close openings. Throws InputError if it leaves the
/// range of make_body.
std::shared_ptr<const Body> with_surface(const Body& nominal, Soup soup, Soup caps,
                                         const FaceOffset& offset, const Progress& progress = {});

/// The same body with other mass properties, except for R, which is that of its surface.
std::shared_ptr<const Body> with_other_mass(const Body& body, const MassProperties& mass);

/// The same body, with these parts recorded as what it was joined of.
std::shared_ptr<const Body> with_parts(const Body& body, std::vector<BodyPart> parts);

/// The memory that a body takes, in bytes, including everything that it owns.
std::size_t bytes(const Body& body);

/// read_mesh and make_body in one.
std::shared_ptr<const Body> load_body(const std::string& file, Model asked, double scale = 1.0,
                                      const Progress& progress = {},
                                      Repair repair = Repair::automatic);

}  // namespace sonde
