// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/model_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/mass_rule.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/pinches.hpp"
#include "engine/mending/region_mass.hpp"
#include "engine/text/counted.hpp"

namespace sonde {
namespace {

/// The volume integral over a flat closed mesh is rounding noise of about this size.
bool has_volume(const MassProperties& by_volume, const MassProperties& by_area) {
  return std::abs(by_volume.measure) > 1e-12 * by_area.measure * 2 * by_area.radius;
}

/// The reason why the mesh, as it is, has no inside; empty if it has one.
std::string why_not_closed(const Topology& topology) {
  if (topology.open_edges > 0) return counted(topology.open_edges, "open edge");
  if (topology.misoriented_edges > 0)
    return counted(topology.misoriented_edges, "edge") +
           (topology.misoriented_edges == 1 ? " does" : " do") + " not agree in orientation";
  return {};
}

void turn_inside_out(Body& body) {
  for (Triangle& t : body.soup.triangles) std::swap(t[1], t[2]);
  body.mass.measure = -body.mass.measure;
  body.turned = true;
  body.repairs.turned_parts = 1;
  add_place(body.places, RepairKind::inside_out, body.soup.vertices, body.soup.triangles);
  sort_and_cap(body.places);
}

/// Takes the mass of the region if it has a volume (solid), otherwise that of the area (surface).
/// Returns false for the latter.
bool take_mass(Body& body, const MassProperties& by_area, const MassProperties& sum,
               const Region& region) {
  body.mass = region.overlaps ? mass_of(region) : sum;
  body.mass.radius = radius_about(body.soup, body.mass.com);
  body.repairs.overlaps = region.overlaps;
  body.repairs.overlap_error = region.error;
  body.repairs.overlap_unknown = region.unknown;
  body.solid = has_volume(body.mass, by_area) && region.differ <= overlap_tuning.most_differ;
  if (!body.solid) body.mass = by_area;
  return body.solid;
}

/// Marks the parts that lie inside as hidden.
void hide(Mended& mended, const std::vector<bool>& parts) {
  if (parts.empty()) return;
  mended.as_given = false;
  for (std::size_t i = 0; i < mended.triangles.size(); ++i)
    if (mended.parts[i] < parts.size() && parts[mended.parts[i]] &&
        mended.kinds[i] != TriangleKind::loose) {
      mended.kinds[i] = TriangleKind::hidden;
      ++mended.repairs.hidden;
    }
}

/// The places of the repairs, with the triangles that have been hidden since.
RepairPlaces places_of(Mended& mended, const Soup& all) {
  RepairPlaces places = std::move(mended.places);
  std::vector<Triangle> hidden;
  if (mended.repairs.hidden > 0)
    for (std::size_t i = 0; i < mended.triangles.size(); ++i)
      if (mended.kinds[i] == TriangleKind::hidden) hidden.push_back(mended.triangles[i]);
  add_places(places, RepairKind::hidden, all.vertices, hidden);
  sort_and_cap(places);
  return places;
}

/// What is odd about pockets that the file closes by a wall.
std::string lid_words(std::size_t lids) {
  return counted(lids, "triangle") +
         " across the mouths of pockets that are shells of their own, on the body's face: no "
         "material, but walls, as all triangles are";
}

}  // namespace

bool may_need_mending(const Body& body, const Progress& progress) {
  const Topology& t = body.topology;
  return !t.closed || t.nonmanifold_edges > 0 || t.duplicate_triangles > 0 ||
         find_components(body.soup, progress).count > 1 || has_pinches(body.soup);
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

std::vector<TriangleKind> choose_mended(Body& body, const Soup& all, Model asked,
                                        const Progress& progress) {
  Mended mended = mend(all, body.topology, asked, body.name, part_of(progress, 0, 0.4));
  body.why = mended.why;
  if (mended.lids > 0) body.remarks.push_back(lid_words(mended.lids));
  const bool any_inside = !mended.solid.soup.triangles.empty();
  Region region;
  if (any_inside)
    region = find_region(mended.solid.soup, mended.solid.part, part_of(progress, 0.4, 0.85));
  hide(mended, region.hidden);
  body.repairs = mended.repairs;
  body.places = places_of(mended, all);
  std::vector<TriangleKind> kinds;
  if (any_inside && (!mended.as_given || body.repairs.solid_parts < body.repairs.parts)) {
    Soup soup{all.vertices, {}}, caps{all.vertices, {}};
    for (std::size_t i = 0; i < mended.triangles.size(); ++i) {
      const Triangle& t = mended.triangles[i];
      if (mended.kinds[i] == TriangleKind::hidden ||
          is_degenerate(all.vertices[t[0]], all.vertices[t[1]], all.vertices[t[2]]))
        continue;
      soup.triangles.push_back(t);
      kinds.push_back(mended.kinds[i]);
      if (mended.kinds[i] == TriangleKind::cap) caps.triangles.push_back(t);
    }
    body.soup = compacted(std::move(soup), part_of(progress, 0.85, 0.9));
    body.caps = compacted(std::move(caps));
  }
  MassProperties by_area = mass_by_area(body.soup, part_of(progress, 0.9, 0.95));
  if (!any_inside) {
    body.mass = by_area;
    return {};
  }
  // If the mesh is as given, the sum is taken over exactly the triangles used for contact.
  const bool sound = mended.as_given && body.repairs.repeated == 0 &&
                     body.repairs.solid_parts == body.repairs.parts;
  const MassProperties sum =
      mass_by_volume(sound ? body.soup : mended.solid.soup, part_of(progress, 0.95, 1));
  if (!take_mass(body, by_area, sum, region))
    body.why = "closed but flat (no volume)";
  else
    choose_mass(body, open_share(mended, all.vertices));
  body.cracked = mended.cracked;
  if (body.cracked) body.joined = compacted(std::move(mended.solid.soup));
  body.turned = body.repairs.turned_parts > 0 && body.repairs.turned_parts == body.repairs.parts;
  if (std::ranges::count(kinds, TriangleKind::loose) == 0) kinds.clear();
  return kinds;
}

std::vector<TriangleKind> choose_model(Body& body, Model asked, Repair repair,
                                       const Progress& progress) {
  const bool may_be_solid = asked != Model::surface && body.topology.closed;
  MassProperties by_area, sum;
  Region region;
  run_both(
      may_be_solid && body.soup.triangles.size() >= worth_a_thread, progress,
      [&](const Progress& part) {
        by_area = mass_by_area(body.soup, part_of(part, 0, 0.5));
        if (may_be_solid) sum = mass_by_volume(body.soup, part_of(part, 0.5, 1));
      },
      [&](const Progress& part) {
        const std::vector<std::uint32_t> one_part(body.soup.triangles.size(), 0);
        if (may_be_solid) region = find_region(body.soup, one_part, part);
      });
  if (asked == Model::surface) {
    body.why = "asked for: surface";
    body.mass = by_area;
    return {};
  }
  // The mesh crosses itself: perhaps it has parts that are connected only at corners, one of them
  // inside out.
  if (region.overlaps && repair == Repair::automatic)
    return choose_mended(body, Soup(body.soup), asked, progress);
  std::string why_not = why_not_closed(body.topology);
  if (why_not.empty() && !take_mass(body, by_area, sum, region))
    why_not = "closed but flat (no volume)";
  if (why_not.empty()) {
    body.why = "closed: the inside counts";
    body.repairs.parts = body.repairs.solid_parts = 1;
    if (body.mass.measure < 0) turn_inside_out(body);
  } else if (asked == Model::solid) {
    throw InputError::in(body.name, "cannot be a solid: " + why_not);
  } else {
    body.mass = by_area;
    body.why = why_not + ": the inside does not count";
  }
  return {};
}

}  // namespace sonde
