// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/facets.hpp"
#include "engine/body/model_choice.hpp"
#include "engine/body/outline.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mesh_io/read_mesh.hpp"

namespace sonde {
namespace {

/// Boxes are single precision, and σ is a length squared: sizes must be in the range of both.
constexpr double largest_coordinate = 1e30;
constexpr double smallest_size = 1e-30;

/// Throws if the numbers leave the range that the engine computes in.
void check_size(const Soup& soup, const std::string& name) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  if (!(box.max().cwiseAbs().maxCoeff() < largest_coordinate &&
        box.min().cwiseAbs().maxCoeff() < largest_coordinate))
    throw InputError::in(name, "a coordinate is beyond 1e30 m");
  if (box.sizes().maxCoeff() < smallest_size)
    throw InputError::in(name, "the mesh is smaller than 1e-30 m");
}

/// The facets of the triangles that bound an inside, and separately those of the loose ones, since
/// neither may absorb the others.
Facets merge_apart(const Soup& soup, const std::vector<TriangleKind>& kinds,
                   const Progress& progress) {
  Facets out;
  out.soup.vertices = soup.vertices;
  for (const bool loose : {false, true}) {
    Soup some{soup.vertices, {}};
    std::vector<std::uint32_t> number;
    for (std::uint32_t i = 0; i < kinds.size(); ++i)
      if ((kinds[i] == TriangleKind::loose) == loose) {
        number.push_back(i);
        some.triangles.push_back(soup.triangles[i]);
      }
    const Facets found = merge_flat(some, rounding_flatness(soup), !loose,
                                    part_of(progress, loose ? 0.5 : 0, loose ? 1 : 0.5));
    out.soup.triangles.insert(out.soup.triangles.end(), found.soup.triangles.begin(),
                              found.soup.triangles.end());
    for (const std::uint32_t i : found.from) out.from.push_back(number[i]);
    out.merged += found.merged;
    out.duplicates += found.duplicates;
  }
  return out;
}

/// Merges coplanar triangles. For each triangle of the surface returns a triangle of the soup that
/// is connected with it.
std::vector<std::uint32_t> find_facets(Body& body, const std::vector<TriangleKind>& kinds,
                                       const Progress& progress) {
  Facets facets = kinds.empty()
                      ? merge_flat(body.soup, rounding_flatness(body.soup), body.solid, progress)
                      : merge_apart(body.soup, kinds, progress);
  if (facets.merged + facets.duplicates == 0) return {};
  body.facets = compacted(std::move(facets.soup));
  body.merged = facets.merged;
  body.duplicates = facets.duplicates;
  // Repeated triangles count once in the mass of a surface.
  if (!body.solid && body.duplicates > 0) body.mass = mass_by_area(body.facets);
  return facets.from;
}

void grow_tree(Body& body, const std::vector<TriangleKind>& kinds, const Progress& progress) {
  const Components components = find_components(body.soup, part_of(progress, 0, 0.1));
  const std::vector<std::uint32_t> from = find_facets(body, kinds, part_of(progress, 0.1, 0.3));
  std::vector<std::uint32_t> order;
  Soup& surface = from.empty() ? body.soup : body.facets;
  body.tree = build_tree(surface, order, part_of(progress, 0.3, 1));
  body.component_triangle.resize(components.count);
  if (!kinds.empty()) body.loose.resize(order.size());
  for (std::size_t i = order.size(); i-- > 0;) {
    const std::uint32_t triangle = from.empty() ? order[i] : from[order[i]];
    if (!kinds.empty()) body.loose[i] = kinds[triangle] == TriangleKind::loose;
    body.component_triangle[components.of[triangle]] = static_cast<std::uint32_t>(i);
  }
}

/// Adds an outline to a body that has many more triangles than its outline would have.
void add_outline(Body& body, const Progress& progress) {
  if (surface(body).triangles.size() < 2 * outline_triangles) return;
  auto rough = std::make_shared<Body>();
  rough->soup = compacted(outline(surface(body), outline_triangles, progress));
  if (rough->soup.triangles.empty()) return;
  rough->mass = body.mass;
  std::vector<std::uint32_t> order;
  rough->tree = build_tree(rough->soup, order);
  body.outline = std::move(rough);
}

std::shared_ptr<const Body> build(Soup soup, std::vector<std::string> remarks, Model asked,
                                  Repair repair, const std::string& name,
                                  const Progress& progress) {
  auto body = std::make_shared<Body>();
  body->name = name;
  body->remarks = std::move(remarks);
  body->soup = compacted(std::move(soup), part_of(progress, 0, 0.1));
  body->topology = analyse_topology(body->soup, part_of(progress, 0.1, 0.2));
  // Triangles without an area still connect others, so this comes before they are removed.
  const bool mends = asked != Model::surface && repair == Repair::automatic &&
                     may_need_mending(*body, part_of(progress, 0.2, 0.22));
  const Soup all = mends ? body->soup : Soup{};
  body->degenerate = set_aside_degenerate(body->soup, part_of(progress, 0.22, 0.25));
  if (body->soup.triangles.empty()) throw InputError::in(name, "no triangle has an area");
  if (body->degenerate > 0)
    body->soup = compacted(std::move(body->soup), part_of(progress, 0.25, 0.3));
  check_size(body->soup, name);
  const Progress choosing = part_of(progress, 0.3, 0.4);
  const std::vector<TriangleKind> kinds = mends ? choose_mended(*body, all, asked, choosing)
                                                : choose_model(*body, asked, repair, choosing);
  grow_tree(*body, kinds, part_of(progress, 0.4, 0.9));
  add_outline(*body, part_of(progress, 0.9, 1));
  report(progress, 1);
  return body;
}

Soup triangles_of(const PolygonSoup& polygons, const std::string& name, const Progress& progress) {
  if (polygons.points.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError::in(name, "more than 2^31 points");
  report(progress, 0);
  return triangulate_all(polygons, progress);
}

template <class T>
std::size_t capacity_bytes(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

std::shared_ptr<const Body> make_body(const PolygonSoup& polygons, Model asked,
                                      const std::string& name, const Progress& progress,
                                      Repair repair) {
  return build(triangles_of(polygons, name, part_of(progress, 0, 0.05)), polygons.remarks, asked,
               repair, name, part_of(progress, 0.05, 1));
}

std::shared_ptr<const Body> with_surface(const Body& nominal, Soup soup, Soup caps,
                                         const FaceOffset& offset, const Progress& progress) {
  auto body = std::make_shared<Body>();
  body->name = nominal.name;
  body->solid = nominal.solid;
  body->why = nominal.why;
  body->mass_why = nominal.mass_why;
  body->turned = nominal.turned;
  body->repairs = nominal.repairs;
  body->places = nominal.places;
  body->remarks = nominal.remarks;
  body->degenerate = nominal.degenerate;
  body->topology = nominal.topology;
  body->mass = nominal.mass;
  body->offset = offset;
  body->soup = std::move(soup);
  body->caps = std::move(caps);
  check_size(body->soup, body->name);
  body->mass.radius = radius_about(body->soup, body->mass.com);
  grow_tree(*body, {}, part_of(progress, 0, 0.8));
  add_outline(*body, part_of(progress, 0.8, 1));
  report(progress, 1);
  return body;
}

std::shared_ptr<const Body> with_other_mass(const Body& body, const MassProperties& mass) {
  auto out = std::make_shared<Body>(body);
  out->mass = mass;
  out->mass_why.clear();
  out->mass.by_volume = body.mass.by_volume;
  out->mass.radius = radius_about(surface(body), mass.com);
  if (body.outline) {
    auto outline = std::make_shared<Body>(*body.outline);
    outline->mass = out->mass;
    out->outline = std::move(outline);
  }
  return out;
}

std::shared_ptr<const Body> with_parts(const Body& body, std::vector<BodyPart> parts) {
  auto out = std::make_shared<Body>(body);
  out->parts = std::move(parts);
  return out;
}

std::size_t bytes(const Body& body) {
  return sizeof(Body) + body.name.capacity() + body.why.capacity() + body.mass_why.capacity() +
         capacity_bytes(body.soup.vertices) + capacity_bytes(body.soup.triangles) +
         capacity_bytes(body.facets.vertices) + capacity_bytes(body.facets.triangles) +
         capacity_bytes(body.caps.vertices) + capacity_bytes(body.caps.triangles) +
         capacity_bytes(body.joined.vertices) + capacity_bytes(body.joined.triangles) +
         capacity_bytes(body.places.places) + capacity_bytes(body.component_triangle) +
         body.loose.capacity() / 8 + bytes(body.tree) + (body.outline ? bytes(*body.outline) : 0);
}

std::shared_ptr<const Body> load_body(const std::string& file, Model asked, double scale,
                                      const Progress& progress, Repair repair) {
  std::vector<std::string> remarks;
  // The polygons are freed before the body is built.
  Soup soup = [&] {
    PolygonSoup polygons = read_mesh(file, scale, part_of(progress, 0, 0.45));
    remarks = std::move(polygons.remarks);
    return triangles_of(polygons, file, part_of(progress, 0.45, 0.5));
  }();
  return build(std::move(soup), std::move(remarks), asked, repair, file, part_of(progress, 0.5, 1));
}

}  // namespace sonde
