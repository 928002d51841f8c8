// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/offset/fans.hpp"
#include "engine/offset/half_spaces.hpp"

namespace sonde {

/// Faces whose normals differ by less (rad) are one: the error is 1e-10 of the way.
constexpr double one_plane = 1e-5;
/// The corner of blades so sharp that it would go further than this many times the way outwards is
/// held back: of edges below 11.5°. Their faces gain less there, down to nothing at a tip of no
/// angle. Inwards there is no such limit: a blade loses all that is thinner than the offset.
constexpr double most_outward_way = 10;
/// No corner goes further inwards than this many times the way; sharper ones are as saddles.
constexpr double most_inward_way = 1e3;

/// Where the corners of a solid go when its faces move by a length.
class CornerPlanes {
 public:
  /// Of a soup, which stays, its fans, a length by which faces move outwards, and what its
  /// coordinates may be off by (m).
  CornerPlanes(const Soup& soup, const Fans& fans, double by, double rounding,
               const Progress& progress = {});

  double way() const { return way_; }                           ///< |by|
  double sign() const { return sign_; }                         ///< of `by`
  const std::vector<Vec3>& normals() const { return normal_; }  ///< of triangles, unit, outwards
  /// Of triangles: not so flat that rounding decides which way they look.
  const std::vector<char>& have_say() const { return has_say_; }
  /// Of triangles: the angle (rad) that normals of one plane differ by there, by rounding.
  const std::vector<double>& tilts() const { return tilt_; }

  /// Calls each(triangle) for those of a fan that have a say, or for all where none has.
  template <class Each>
  void for_faces(std::uint32_t fan, Each each) const {
    bool any = false;
    for (const bool with_say : {true, false}) {
      for (std::size_t i = first_[fan]; i < first_[fan + 1]; ++i)
        if (bool(has_say_[faces_[i]]) == with_say) {
          each(faces_[i]);
          any = true;
        }
      if (any) return;
    }
  }

  /// The half-spaces that the corner of a fan has to go into, from its vertex.
  std::vector<HalfSpace3> planes_of(std::uint32_t fan) const;
  /// The way of the corner of a fan, m. On all its planes where they have a point in common, else
  /// the shortest way into all its half-spaces; of a saddle that has none, along the mean normal.
  Vec3 way_of(std::uint32_t fan) const;

 private:
  const Vec3& corner(std::size_t t, std::size_t k) const {
    return soup_.vertices[soup_.triangles[t][k]];
  }
  void find_planes(double rounding, const Progress& progress);
  Vec3 limited(const Vec3& way) const;
  Vec3 mean_normal(std::uint32_t fan) const;

  const Soup& soup_;
  const Fans& fans_;
  double way_;
  double sign_;
  std::vector<Vec3> normal_;
  std::vector<double> area_;   // twice
  std::vector<char> has_say_;  // of a triangle
  std::vector<double> tilt_;
  std::vector<std::size_t> first_;  // of each fan in faces_
  std::vector<std::uint32_t> faces_;
};

/// What coordinates from a file in single precision are off by, m: flatter triangles have no say
/// in which way their faces look.
double file_rounding(const Soup& soup);

}  // namespace sonde
