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

/// A part that a body was joined of, at its place in the body's mesh frame.
struct BodyPart {
  std::string name;
  std::shared_ptr<const Body> body;
  Pose X_BP;
};

/// A body, built once and immutable: its triangles, mass properties and bounding-volume tree, all
/// in the mesh frame. No two vertices are at one place, and each is a corner of a triangle.
struct Body {
  std::string name;
  Soup soup;
  /// An interior counts (winding number of the triangles that are not loose ≠ 0); else only the
  /// triangles.
  bool solid = false;
  std::string why;      ///< "closed", "12 open edges: the inside does not count", ...
  bool turned = false;  ///< was inside out, all of it, and has been turned
  Repairs repairs;      ///< what was done so that it has an inside
  RepairPlaces places;  ///< and where
  /// What is odd about its file and was read all the same, a sentence each (PolygonSoup::remarks).
  std::vector<std::string> remarks;
  /// A ray may slip through between triangles whose corners are joined by name alone: windings are
  /// then counted along whole lines, where that shows.
  bool cracked = false;
  /// Where cracked: the same surface with one corner where several are joined, and sides cut where
  /// corners lie on them, for what moves its faces.
  Soup joined;
  Soup caps;  ///< the triangles that close openings, a copy of those in `soup`, to be shown
  std::size_t degenerate = 0;  ///< triangles set aside for having no area
  Topology topology;           ///< with the degenerate triangles
  /// One triangle of surface(body), the first, of each connected component.
  std::vector<std::uint32_t> component_triangle;
  MassProperties mass;
  /// How far its faces are from those of its mesh. The mass is the mesh's (but for R) all the same.
  FaceOffset offset;
  /// The surface in as few triangles as its flat parts need (facets.hpp). Empty where the soup
  /// already is that.
  Soup facets;
  std::size_t merged = 0;      ///< triangles of the soup that are parts of larger ones in `facets`
  std::size_t duplicates = 0;  ///< triangles of the soup that `facets` leaves out as repeated
  Tree tree;                   ///< over surface(body)
  /// Of each triangle of surface(body), whether it bounds nothing: of a sheet beside a solid. Empty
  /// where all of them bound the inside, and where there is none.
  std::vector<bool> loose;
  /// The same body, with its mass, in about outline_triangles triangles: an approximation that
  /// guides searches. None where the body itself has few.
  std::shared_ptr<const Body> outline;
  /// What it was joined of; empty where it is of one mesh.
  std::vector<BodyPart> parts;
};
constexpr std::size_t outline_triangles = 1000;

/// The triangles of contact, in the order of the tree's leaves: every query works on these.
inline const Soup& surface(const Body& body) {
  return body.facets.triangles.empty() ? body.soup : body.facets;
}

/// Whether a triangle of surface(body) bounds nothing.
inline bool is_loose(const Body& body, std::uint32_t triangle) {
  return !body.loose.empty() && body.loose[triangle];
}

/// The outline of a body, or the body itself where it has none.
inline const Body& roughly(const Body& body) { return body.outline ? *body.outline : body; }

/// Builds a body. `asked` solid throws InputError where the mesh bounds no inside (with
/// Repair::none: where it is not closed); automatic falls back to surface and gives the reason. A
/// closed mesh whose volume cannot be told from zero (flat) is a surface. Throws InputError where
/// no triangle has an area.
std::shared_ptr<const Body> make_body(const PolygonSoup& polygons, Model asked,
                                      const std::string& name, const Progress& progress = {},
                                      Repair repair = Repair::automatic);

/// The same body with a surface that is elsewhere by `offset`: name, model and mass stay, R is that
/// of the surface. The soup is as that of a body: one vertex for each place, no degenerate
/// triangle. `caps`: those of its triangles that close openings. Throws InputError where it leaves
/// the range of make_body.
std::shared_ptr<const Body> with_surface(const Body& nominal, Soup soup, Soup caps,
                                         const FaceOffset& offset, const Progress& progress = {});

/// The same body with other mass properties, but for R, which is that of its surface.
std::shared_ptr<const Body> with_other_mass(const Body& body, const MassProperties& mass);

/// The same body, joined of these parts.
std::shared_ptr<const Body> with_parts(const Body& body, std::vector<BodyPart> parts);

/// The memory that a body takes, in bytes: itself and all that it owns.
std::size_t bytes(const Body& body);

/// read_mesh and make_body in one.
std::shared_ptr<const Body> load_body(const std::string& file, Model asked, double scale = 1.0,
                                      const Progress& progress = {},
                                      Repair repair = Repair::automatic);

}  // namespace sonde
