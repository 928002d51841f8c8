// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/facets.hpp"
#include "engine/body/outline.hpp"
#include "engine/mesh_io/read_mesh.hpp"

namespace sonde {
namespace {

/// Boxes are single precision, and σ is a length squared: sizes must leave room for both.
constexpr double largest_coordinate = 1e30;
constexpr double smallest_size = 1e-30;

std::string counted(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::size_t set_aside_degenerate(Soup& soup, const Progress& progress) {
  const std::size_t all = soup.triangles.size();
  std::size_t kept = 0;
  for_each_index(all, progress, [&](std::size_t i) {
    const Triangle t = soup.triangles[i];
    soup.triangles[kept] = t;
    kept += !is_degenerate(soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]);
  });
  soup.triangles.resize(kept);
  soup.triangles.shrink_to_fit();
  return all - kept;
}

/// Throws where the numbers leave the range that the engine computes in.
void check_size(const Soup& soup, const std::string& name) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  if (!(box.max().cwiseAbs().maxCoeff() < largest_coordinate &&
        box.min().cwiseAbs().maxCoeff() < largest_coordinate))
    throw InputError::in(name, "a coordinate is beyond 1e30 m");
  if (box.sizes().maxCoeff() < smallest_size)
    throw InputError::in(name, "the mesh is smaller than 1e-30 m");
}

/// Why the inside of the mesh cannot count; empty where it can.
std::string why_not_solid(const Topology& topology, const MassProperties& by_volume,
                          const MassProperties& by_area) {
  if (topology.open_edges > 0) return counted(topology.open_edges, "open edge");
  if (topology.misoriented_edges > 0)
    return counted(topology.misoriented_edges, "edge") +
           (topology.misoriented_edges == 1 ? " does" : " do") + " not agree in orientation";
  // The integral over a flat closed mesh is rounding noise of about this size.
  if (!(std::abs(by_volume.measure) > 1e-12 * by_area.measure * 2 * by_area.radius))
    return "closed but flat (no volume)";
  return {};
}

void turn_inside_out(Body& body) {
  for (Triangle& t : body.soup.triangles) std::swap(t[1], t[2]);
  body.mass.measure = -body.mass.measure;
  body.turned = true;
}

/// Decides between solid and surface; the soup is without its degenerate triangles by now, the
/// topology is that of all of them.
void choose_model(Body& body, Model asked, const Progress& progress) {
  const bool may_be_solid = asked != Model::surface && body.topology.closed;
  MassProperties by_volume;
  run_both(
      may_be_solid && body.soup.triangles.size() >= worth_a_thread, progress,
      [&](const Progress& part) { body.mass = mass_by_area(body.soup, part); },
      [&](const Progress& part) {
        if (may_be_solid) by_volume = mass_by_volume(body.soup, part);
      });
  if (asked == Model::surface) {
    body.why = "asked for: surface";
    return;
  }
  const std::string why_not = why_not_solid(body.topology, by_volume, body.mass);
  if (why_not.empty()) {
    body.solid = true;
    body.why = "closed: the inside counts";
    body.mass = by_volume;
    if (by_volume.measure < 0) turn_inside_out(body);
  } else if (asked == Model::solid) {
    throw InputError::in(body.name, "cannot be a solid: " + why_not);
  } else {
    body.why = why_not + ": the inside does not count";
  }
}

/// Joins what is flat. For each triangle of the surface returns one of the soup's that it is
/// connected with.
std::vector<std::uint32_t> find_facets(Body& body, const Progress& progress) {
  Facets facets = merge_flat(body.soup, rounding_flatness(body.soup), body.solid, progress);
  if (facets.merged + facets.duplicates == 0) return {};
  body.facets = compacted(std::move(facets.soup));
  body.merged = facets.merged;
  body.duplicates = facets.duplicates;
  // What is there twice is no more of a surface than what is there once.
  if (!body.solid && body.duplicates > 0) body.mass = mass_by_area(body.facets);
  return facets.from;
}

void grow_tree(Body& body, const Progress& progress) {
  const Components components = find_components(body.soup, part_of(progress, 0, 0.1));
  const std::vector<std::uint32_t> from = find_facets(body, part_of(progress, 0.1, 0.3));
  std::vector<std::uint32_t> order;
  Soup& surface = from.empty() ? body.soup : body.facets;
  body.tree = build_tree(surface, order, part_of(progress, 0.3, 1));
  body.component_triangle.resize(components.count);
  for (std::size_t i = order.size(); i-- > 0;) {
    const std::uint32_t triangle = from.empty() ? order[i] : from[order[i]];
    body.component_triangle[components.of[triangle]] = static_cast<std::uint32_t>(i);
  }
}

/// A body that is finer than its outline would be gets one.
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

std::shared_ptr<const Body> build(Soup soup, Model asked, const std::string& name,
                                  const Progress& progress) {
  auto body = std::make_shared<Body>();
  body->name = name;
  body->soup = compacted(std::move(soup), part_of(progress, 0, 0.1));
  body->topology = analyse_topology(body->soup, part_of(progress, 0.1, 0.2));
  body->degenerate = set_aside_degenerate(body->soup, part_of(progress, 0.2, 0.25));
  if (body->soup.triangles.empty()) throw InputError::in(name, "no triangle has an area");
  if (body->degenerate > 0)
    body->soup = compacted(std::move(body->soup), part_of(progress, 0.25, 0.3));
  check_size(body->soup, name);
  choose_model(*body, asked, part_of(progress, 0.3, 0.4));
  grow_tree(*body, part_of(progress, 0.4, 0.9));
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
                                      const std::string& name, const Progress& progress) {
  return build(triangles_of(polygons, name, part_of(progress, 0, 0.05)), asked, name,
               part_of(progress, 0.05, 1));
}

std::shared_ptr<const Body> with_surface(const Body& nominal, Soup soup, const FaceOffset& offset,
                                         const Progress& progress) {
  auto body = std::make_shared<Body>();
  body->name = nominal.name;
  body->solid = nominal.solid;
  body->why = nominal.why;
  body->turned = nominal.turned;
  body->degenerate = nominal.degenerate;
  body->topology = nominal.topology;
  body->mass = nominal.mass;
  body->offset = offset;
  body->soup = std::move(soup);
  check_size(body->soup, body->name);
  body->mass.radius = 0;
  for (const Vec3& x : body->soup.vertices)
    body->mass.radius = std::max(body->mass.radius, (x - body->mass.com).norm());
  grow_tree(*body, part_of(progress, 0, 0.8));
  add_outline(*body, part_of(progress, 0.8, 1));
  report(progress, 1);
  return body;
}

std::size_t bytes(const Body& body) {
  return sizeof(Body) + body.name.capacity() + body.why.capacity() +
         capacity_bytes(body.soup.vertices) + capacity_bytes(body.soup.triangles) +
         capacity_bytes(body.facets.vertices) + capacity_bytes(body.facets.triangles) +
         capacity_bytes(body.component_triangle) + bytes(body.tree) +
         (body.outline ? bytes(*body.outline) : 0);
}

std::shared_ptr<const Body> load_body(const std::string& file, Model asked, double scale,
                                      const Progress& progress) {
  // The polygons are gone before the body is built.
  Soup soup = triangles_of(read_mesh(file, scale, part_of(progress, 0, 0.45)), file,
                           part_of(progress, 0.45, 0.5));
  return build(std::move(soup), asked, file, part_of(progress, 0.5, 1));
}

}  // namespace sonde
