// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/intersect.hpp"

#include "engine/proximity/inside.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

bool leaves_meet(const Placement& at, const Tree::Node& na, const Tree::Node& nb, Doubt doubt) {
  for (std::uint32_t i = na.first; i < na.first + na.count; ++i) {
    const Corners ta = at.corners_a(i);
    for (std::uint32_t j = nb.first; j < nb.first + nb.count; ++j) {
      const Corners tb = at.corners_b(j);
      const Meeting m = classify(ta, tb);
      if (m == Meeting::apart) continue;
      if (m == Meeting::meeting || doubt == Doubt::contact || meet_exactly(ta, tb)) return true;
    }
  }
  return false;
}

}  // namespace

bool triangles_meet(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt) {
  const Placement at(a, b, X_BA);
  struct Entry {
    std::uint32_t a, b;
  };
  PairStack<Entry> stack;
  if (at.box_distance(a.tree.nodes[0], b.tree.nodes[0]) > 0) return false;
  stack.push({0, 0});
  while (!stack.empty()) {
    const Entry e = stack.pop();
    const Tree::Node& na = a.tree.nodes[e.a];
    const Tree::Node& nb = b.tree.nodes[e.b];
    if (na.is_leaf() && nb.is_leaf()) {
      if (leaves_meet(at, na, nb, doubt)) return true;
      continue;
    }
    Entry children[2];
    if (open_first(na, nb))
      children[0] = {na.first, e.b}, children[1] = {na.first + 1, e.b};
    else
      children[0] = {e.a, nb.first}, children[1] = {e.a, nb.first + 1};
    double d[2];
    for (int i = 0; i < 2; ++i)
      d[i] = at.box_overlap(a.tree.nodes[children[i].a], b.tree.nodes[children[i].b]);
    // The deeper overlap is looked at first: a first hit is likeliest there.
    const int first = d[0] <= d[1] ? 0 : 1;
    if (d[1 - first] <= 0) stack.push(children[1 - first]);
    if (d[first] <= 0) stack.push(children[first]);
  }
  return false;
}

bool overlap(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt) {
  return triangles_meet(a, b, X_BA, doubt) || component_inside(a, b, X_BA);
}

}  // namespace sonde
