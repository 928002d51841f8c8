// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/translated_both_ways.hpp"

#include <tuple>

#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/search.hpp"

namespace sonde {
namespace {

/// True for a pair at a pose or for its exchange, and for both only if nothing distinguishes them:
/// decided by the bodies, or by the pose if the bodies are alike.
bool is_in_order(const Pair& pair, const Pose& device) {
  const auto key = [](const Body& body, const Vec3& p) {
    return std::tuple(surface(body).triangles.size(), body.mass.measure, body.mass.radius, p.x(),
                      p.y(), p.z());
  };
  return key(pair.probe(), device.p) <= key(pair.fixed(), inverse(device).p);
}

/// Whether the first of the two searches is enough. An answer of almost no depth may keep a gap
/// that is a large share of it; the second search may then come nearer.
bool is_enough(const Search& search, const Separation& found, const Body& probe) {
  return found.status == Status::penetrating && search.is_settled() &&
         allowed_clearance(probe.mass.radius, found.depth) <= 1e-4 * found.depth;
}

}  // namespace

Translated translated_both_ways(const Pair& pair, const Pose& device, const StaticOptions& options,
                                const SearchTuning& tuning, const Progress& progress) {
  const Pair exchanged = pair.exchanged();
  Search there(pair, device, options, tuning, {}, progress);
  Search back(exchanged, inverse(device), options, tuning, {}, progress);
  const auto sketches = [&] { return there.sketches_made() + back.sketches_made(); };
  Separation found, other;
  if (is_in_order(pair, device)) {
    found = there.run();
    if (found.status != Status::penetrating || is_enough(there, found, pair.probe()))
      return {found, sketches()};
    back.know(inverse(found.separated));
    other = back.run();
    if (other.status == Status::penetrating && other.depth < (1 - 1e-9) * found.depth) {
      there.know(inverse(other.separated));
      found = there.again();
    }
  } else {
    other = back.run();
    if (other.status == Status::penetrating) there.know(inverse(other.separated));
    if (is_enough(back, other, pair.fixed())) found = there.again();
    if (found.status != Status::penetrating) found = there.run();
    if (found.status != Status::penetrating) return {found, sketches()};
  }
  found.iterations += other.iterations;
  found.limited += other.limited;
  found.phases += other.phases;
  return {found, sketches()};
}

}  // namespace sonde
