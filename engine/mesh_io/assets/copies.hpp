// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sonde {

/// Which objects of a file place which others. Objects that each place two of the next make a file
/// of thirty into a thousand million: what is placed is counted before it is made.
class Copies {
 public:
  /// An object with corners of its own; its number.
  std::size_t add(double corners);
  void add_corners(std::size_t object, double corners) { objects_[object].corners += corners; }
  /// `parent` places `child` once more.
  void place(std::size_t parent, std::size_t child) {
    objects_[parent].places.push_back(child);
    objects_[child].is_placed = true;
  }
  bool is_placed(std::size_t object) const { return objects_[object].is_placed; }
  /// The corners of all that `root` places, each copy counted. Throws InputError where an object is
  /// inside itself, objects are within objects deeper than most_depth, or there are more than
  /// most_corners in all, where a copy without any counts as one: it takes memory, too.
  double count(const std::string& file, std::size_t root);

  /// Readers of such files call themselves for what is inside.
  static constexpr int most_depth = 200;

 private:
  struct Object {
    double corners = 0;  ///< its own; with all that it places, once it is counted
    double copies = 0;   ///< that it places
    std::vector<std::size_t> places;
    enum class State { fresh, open, counted } state = State::fresh;
    int depth = 0;  ///< of what it places
    bool is_placed = false;
  };
  void add_up(const std::string& file, std::size_t object, int depth);
  std::vector<Object> objects_;
};

}  // namespace sonde
