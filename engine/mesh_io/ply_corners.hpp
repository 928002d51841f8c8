// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/geometry/soup.hpp"
#include "engine/mesh_io/remarks.hpp"

namespace sonde {

/// Collects the faces of a PLY file, and the triangles of its strips.
class PlyCorners {
 public:
  explicit PlyCorners(std::vector<Polygon>& polygons) : polygons_(polygons) {}

  void face(Polygon face, std::uint64_t place) {
    if (face.size() < 3) return thin_.add(place, face.size());
    polygons_.push_back(std::move(face));
  }

  /// The next corner of a strip. Every second triangle is turned, as its first two corners come in
  /// the other order. A corner that comes twice is there to go on to another place: such triangles
  /// are none.
  void strip_corner(std::size_t corner, std::uint64_t place) {
    if (length_ >= 2 && before_ != last_ && before_ != corner && last_ != corner) {
      if (length_ % 2 == 0)
        polygons_.push_back({before_, last_, corner});
      else
        polygons_.push_back({last_, before_, corner});
    }
    if (length_++ == 0) place_ = place;
    before_ = std::exchange(last_, corner);
  }
  void end_strip() {
    if (length_ == 1 || length_ == 2) short_.add(place_);
    length_ = 0;
  }

  void remark_to(Remarks& remarks, const char* place) const {
    remark(remarks, place, thin_);
    remark(remarks, place, short_, "strip of fewer than three corners set aside",
           "strips of fewer than three corners set aside");
  }

 private:
  std::vector<Polygon>& polygons_;
  std::uint64_t length_ = 0;  ///< of the strip so far
  std::size_t before_ = 0, last_ = 0;
  std::uint64_t place_ = 0;
  ThinFaces thin_;
  Tally short_;
};

}  // namespace sonde
