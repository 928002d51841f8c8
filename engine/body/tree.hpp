// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A bounding volume tree of oriented boxes over the triangles of a soup, sixteen to a node, in the
/// mesh frame. An oriented box over a piece of a smooth surface has a thickness of second order in
/// the piece's size; an axis-aligned one is as thick as the piece is long, and a query would open
/// far more of them (after Gottschalk, Lin and Manocha, OBB-Tree, 1996). A vector unit compares
/// sixteen boxes at a time.
///
/// A *slot* is one box: lane `slot % width` of node `slot / width`. Slot 0 is the root's.
struct Tree {
  static constexpr std::uint32_t width = 16;
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::uint32_t triangle_bit = 0x80000000u;
  static constexpr int max_depth = 24;

  /// Sixteen boxes, structure of arrays. The box of a lane is {x : |aᵢ·(x − origin − center)| ≤
  /// halfᵢ}, with a₃ = a₁ × a₂; it contains all corners below it. Unused lanes follow the used ones
  /// and repeat the first.
  struct alignas(64) Node {
    float center[3][width];   // relative to the tree's origin, m
    float half[3][width];     // m
    float axis[2][3][width];  // unit, orthogonal to each other
    /// Half the sum of a box's three sides, m.
    float half_sum(std::uint32_t k) const { return half[0][k] + half[1][k] + half[2][k]; }
    std::uint32_t child[width];  // a node, or a triangle with triangle_bit set; or none
  };

  std::vector<Node> nodes;     ///< node 0 holds only the root's box
  Vec3 origin = Vec3::Zero();  ///< mesh frame; boxes are relative to it
  Vec3 low = Vec3::Zero();     ///< of the axis-aligned box in the mesh frame, m
  Vec3 high = Vec3::Zero();
  int depth = 0;  ///< number of nodes from the root to the deepest, at most max_depth

  bool empty() const { return nodes.empty(); }
  std::uint32_t child(std::uint32_t slot) const { return nodes[slot / width].child[slot % width]; }
  /// The first of the triangles below a slot.
  std::uint32_t first_triangle(std::uint32_t slot) const;
  float half_sum(std::uint32_t slot) const { return nodes[slot / width].half_sum(slot % width); }
  double half_diagonal(std::uint32_t slot) const;  ///< m; rounded up
  Vec3 center(std::uint32_t slot) const;           ///< of a box, mesh frame, m
};

/// Builds the tree over soup, on up to two threads, and reorders soup.triangles by its leaves;
/// `order[i]` is the old index of the triangle now at i. The same bits on any number of threads.
/// Throws Cancelled.
Tree build_tree(Soup& soup, std::vector<std::uint32_t>& order, const Progress& progress = {});

/// The memory that a tree takes, bytes.
std::size_t bytes(const Tree& tree);

}  // namespace sonde
