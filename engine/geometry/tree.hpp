// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// A binary tree of boxes over the triangles of a soup, in the mesh frame. Node 0 is the root; the
/// two children of an inner node are adjacent. Boxes are kept in single precision, rounded
/// outwards.
struct Tree {
  struct Node {
    float center[3];
    float half[3];
    std::uint32_t first;  ///< inner node: index of the left child; leaf: its first triangle
    std::uint32_t count;  ///< 0 for an inner node, else the number of triangles of a leaf
    bool is_leaf() const { return count != 0; }
  };
  static constexpr std::uint32_t leaf_size = 1;
  std::vector<Node> nodes;
  int depth = 0;  ///< levels below the root
};

/// Builds the tree over soup and reorders soup.triangles by its leaves; `order[i]` is the old index
/// of the triangle now at i.
Tree build_tree(Soup& soup, std::vector<std::uint32_t>& order);

}  // namespace sonde
