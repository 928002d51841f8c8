// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/copies.hpp"

#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/asset_readers.hpp"

namespace sonde {

std::size_t Copies::add(double corners) {
  objects_.emplace_back().corners = corners;
  return objects_.size() - 1;
}

void Copies::add_up(const std::string& file, std::size_t object, int depth) {
  Object& it = objects_[object];
  if (it.state == Object::State::open)
    throw InputError::in(file, "an object is placed inside itself");
  if (it.state == Object::State::fresh) {
    if (depth > most_depth)
      throw InputError::in(file, "objects are placed within objects more than " +
                                     std::to_string(most_depth) + " deep");
    it.state = Object::State::open;
    for (const std::size_t child : it.places) {
      add_up(file, child, depth + 1);
      it.corners += objects_[child].corners;
      it.copies += objects_[child].copies + 1;
      it.depth = std::max(it.depth, objects_[child].depth + 1);
    }
    it.state = Object::State::counted;
  }
  if (depth + it.depth > most_depth)
    throw InputError::in(file, "objects are placed within objects more than " +
                                   std::to_string(most_depth) + " deep");
}

double Copies::count(const std::string& file, std::size_t root) {
  add_up(file, root, 0);
  const Object& all = objects_[root];
  if (std::max(all.corners, all.copies) > most_corners)
    throw InputError::in(file, "its copies have more than " +
                                   std::to_string(static_cast<long>(most_corners / 3)) +
                                   " triangles in all");
  return all.corners;
}

}  // namespace sonde
