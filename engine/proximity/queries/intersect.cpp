// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/intersect.hpp"

#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {

namespace {

bool boxes_lead_to_a_meeting(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt) {
  const Placement at(a, b, X_BA);
  PairStack<SlotPair> stack;
  SlotPairs found;
  constexpr int straight_down = 24;
  int opened = 0;
  stack.push(at.roots());
  while (!stack.empty()) {
    const SlotPair p = stack.pop();
    if (at.is_leaf(p)) {
      const Corners ta = at.corners_a(at.triangle_a(p)), tb = at.corners_b(at.triangle_b(p));
      const Meeting m = classify(ta, tb);
      if (m == Meeting::apart) continue;
      if (m == Meeting::meeting || doubt == Doubt::contact || meet_exactly(ta, tb)) return true;
      continue;
    }
    // If the bodies overlap, a direct descent usually finds a common point soon; if the query takes
    // longer, the bodies are close but apart.
    const Opening opening = ++opened <= straight_down ? Opening::larger : Opening::both;
    at.open_overlapping(p, opening, found);
    // The deepest overlap is examined first, where a hit is most likely.
    ordering::sort(found.begin(), found.end(),
                   [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& child : found) stack.push(child);
  }
  return false;
}

}  // namespace

bool triangles_meet(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt) {
  return !balls_are_apart(a, b, X_BA) && boxes_lead_to_a_meeting(a, b, X_BA, doubt);
}

bool overlap(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt) {
  return !balls_are_apart(a, b, X_BA) &&
         (boxes_lead_to_a_meeting(a, b, X_BA, doubt) || component_inside(a, b, X_BA));
}

}  // namespace sonde
