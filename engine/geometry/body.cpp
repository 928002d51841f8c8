// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/body.hpp"

#include <cmath>
#include <limits>

#include "engine/geometry/read_mesh.hpp"

namespace sonde {
namespace {

/// Boxes are single precision, and σ is a length squared: sizes must leave room for both.
constexpr double largest_coordinate = 1e30;
constexpr double smallest_size = 1e-30;

void report(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Cancelled();
}

std::string counted(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// The soup with one vertex for each place, and none that no triangle uses.
Soup compacted(const Soup& soup) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  const std::vector<std::uint32_t> first = weld(soup.vertices);
  std::vector<std::uint32_t> index(soup.vertices.size(), unused);
  Soup out;
  out.triangles = soup.triangles;
  for (Triangle& t : out.triangles)
    for (std::uint32_t& v : t) {
      std::uint32_t& i = index[first[v]];
      if (i == unused) {
        i = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(soup.vertices[first[v]]);
      }
      v = i;
    }
  return out;
}

std::size_t set_aside_degenerate(Soup& soup) {
  return std::erase_if(soup.triangles, [&](const Triangle& t) {
    return is_degenerate(soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]);
  });
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
void choose_model(Body& body, Model asked) {
  body.mass = mass_by_area(body.soup);
  if (asked == Model::surface) {
    body.why = "asked for: surface";
    return;
  }
  const MassProperties by_volume =
      body.topology.closed ? mass_by_volume(body.soup) : MassProperties();
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

void grow_tree(Body& body) {
  std::vector<std::uint32_t> order;
  body.tree = build_tree(body.soup, order);
  const std::vector<std::uint32_t> old = body.topology.component_of;
  for (std::size_t i = 0; i < order.size(); ++i) body.topology.component_of[i] = old[order[i]];
  body.component_triangle.assign(body.topology.components, 0);
  for (std::size_t i = order.size(); i-- > 0;)
    body.component_triangle[body.topology.component_of[i]] = static_cast<std::uint32_t>(i);
}

}  // namespace

std::shared_ptr<const Body> make_body(const PolygonSoup& polygons, Model asked,
                                      const std::string& name, const Progress& progress) {
  if (polygons.points.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError::in(name, "more than 2^31 points");
  auto body = std::make_shared<Body>();
  body->name = name;
  report(progress, 0);
  body->soup = compacted(triangulate_all(polygons));
  report(progress, 0.2);
  body->topology = analyse_topology(body->soup);
  body->degenerate = set_aside_degenerate(body->soup);
  if (body->soup.triangles.empty()) throw InputError::in(name, "no triangle has an area");
  if (body->degenerate > 0) {
    // What hung together by a sliver alone no longer does.
    body->soup = compacted(body->soup);
    find_components(body->soup, body->topology);
  }
  check_size(body->soup, name);
  report(progress, 0.5);
  choose_model(*body, asked);
  report(progress, 0.7);
  grow_tree(*body);
  report(progress, 1);
  return body;
}

std::shared_ptr<const Body> load_body(const std::string& file, Model asked, double scale,
                                      const Progress& progress) {
  const auto part = [&](double start, double share) -> Progress {
    if (!progress) return {};
    return [&progress, start, share](double f) { return progress(start + share * f); };
  };
  const PolygonSoup polygons = read_mesh(file, scale, part(0, 0.5));
  return make_body(polygons, asked, file, part(0.5, 0.5));
}

}  // namespace sonde
