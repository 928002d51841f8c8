// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/offset_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "engine/geometry/by_corners.hpp"
#include "engine/offset/corner_planes.hpp"
#include "engine/offset/fans.hpp"
#include "engine/offset/move_faces.hpp"
#include "engine/offset/thin_places.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/length_text.hpp"

namespace sonde {
namespace {

/// m. No coordinate may lie beyond it; squares of more are none.
constexpr double farthest = 1e30;

std::string place_text(const Vec3& x) {
  std::string text;
  for (const double value : x) text += (text.empty() ? "(" : ", ") + number_text(value, 6);
  return text + ") m";
}

[[noreturn]] void complain(const Body& body, double by, const ThinPlace& place) {
  std::string reason = "an allowance of " + length_text(-by) + " turns parts of it inside out: ";
  if (std::isfinite(place.thickness))
    reason += "the thinnest place found is " + length_text(place.thickness) + " thick, at " +
              place_text(place.at);
  else
    reason += "nothing is left of it";
  if (place.thickness > -2 * by)
    reason += "; corners of sharp grooves go further than the allowance";
  throw InputError::in(body.name, reason);
}

void check(const Body& body, double by) {
  const std::string what = by < 0 ? "an allowance" : "a safety";
  if (!(std::abs(by) <= farthest))
    throw InputError::in(body.name, what + " must be at most " + number_text(farthest, 1) + " m");
  if (!body.solid)
    throw InputError::in(body.name, what + " needs a solid, and this is a surface (" + body.why +
                                        "): it has no inside to be taken " +
                                        (by < 0 ? "smaller" : "larger") + " from");
  if (!body.loose.empty())
    throw InputError::in(
        body.name, what + " needs a solid, and parts of this are surfaces (" + body.why + ")");
}

/// A wall between two parts that share it, there in both directions, is no face of the solid they
/// make; nor is a sheet of no thickness. Moved inwards, the one would be a gap.
Soup without_inner_walls(const Soup& soup, const Progress& progress) {
  const std::vector<CornerTriangle> all = triangles_by_corners(soup, progress);
  std::vector<bool> gone(soup.triangles.size(), false);
  for_each_alike(all, [&](std::span<const CornerTriangle> alike) {
    const std::ptrdiff_t evens = std::ranges::count_if(alike, &CornerTriangle::even);
    std::ptrdiff_t pairs_even = std::min(evens, std::ssize(alike) - evens);
    std::ptrdiff_t pairs_odd = pairs_even;
    for (const CornerTriangle& t : alike)
      gone[t.triangle] = (t.even ? pairs_even : pairs_odd)-- > 0;
  });
  Soup out{soup.vertices, {}};
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (!gone[i]) out.triangles.push_back(soup.triangles[i]);
  return out.triangles.size() == soup.triangles.size() ? soup : compacted(std::move(out));
}

/// The corners of a triangle, whichever of them is the first.
std::array<std::array<double, 3>, 3> places_of(const Soup& soup, const Triangle& t) {
  std::array<std::array<double, 3>, 3> places;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& x = soup.vertices[t[k]];
    places[k] = {x.x(), x.y(), x.z()};
  }
  std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
  return places;
}

/// Of the moved faces, those that close openings.
Soup moved_caps(const Body& body, const Soup& soup, const MovedFaces& moved) {
  if (body.caps.triangles.empty()) return {};
  std::set<std::array<std::array<double, 3>, 3>> caps;
  for (const Triangle& t : body.caps.triangles) caps.insert(places_of(body.caps, t));
  Soup out{moved.soup.vertices, {}};
  for (std::size_t i = 0; i < moved.from.size(); ++i)
    if (caps.contains(places_of(soup, soup.triangles[moved.from[i]])))
      out.triangles.push_back(moved.soup.triangles[i]);
  return compacted(std::move(out));
}

}  // namespace

std::shared_ptr<const Body> offset_faces(const Body& body, double by, const Progress& progress) {
  if (by == 0) return std::make_shared<const Body>(body);
  check(body, by);
  // By themselves, the pieces of a cracked mesh would move apart.
  const Soup& all = body.cracked ? body.joined : body.soup;
  const Soup soup = by < 0 ? without_inner_walls(all, part_of(progress, 0, 0.1)) : all;
  if (soup.triangles.empty()) complain(body, by, {0, body.mass.com});
  const double rounding = std::max(file_rounding(soup), body.repairs.reach);
  const Fans fans = find_fans(soup, rounding, part_of(progress, 0.1, 0.2));
  MovedFaces moved = move_faces(soup, fans, by, rounding, part_of(progress, 0.2, 0.5));
  if (by < 0)
    if (const auto thin = find_thin_place(body, soup, fans, moved, part_of(progress, 0.5, 0.7)))
      complain(body, by, *thin);
  moved.offset.by += body.offset.by;
  Soup caps = moved_caps(body, soup, moved);
  return with_surface(body, std::move(moved.soup), std::move(caps), moved.offset,
                      part_of(progress, 0.7, 1));
}

std::string offset_words(const FaceOffset& offset) {
  if (offset.by == 0) return {};
  const bool smaller = offset.by < 0;
  std::string text = "taken " + length_text(std::abs(offset.by)) +
                     (smaller ? " smaller (allowance)" : " larger (safety)");
  if (offset.held_back > 0)
    text += "; at " + std::to_string(offset.held_back) +
            (offset.held_back == 1 ? " corner" : " corners") + " a face is moved less, by " +
            length_text(offset.least) + " at the least";
  if (offset.filled > 0)
    text += "; gaps narrower than twice that are filled (" + std::to_string(offset.filled) +
            (offset.filled == 1 ? " triangle)" : " triangles)");
  return text;
}

}  // namespace sonde
